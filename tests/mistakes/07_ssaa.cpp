#include "tests/mistakes/building_blocks.hpp"
#include "tests/mistakes/stages.hpp"

namespace raylab::test {

std::vector<Mistake> mistakes_in_ssaa() {
  return {
      {"7.1", "samples at the corners",
       [](StageTable& t) {
         t.sample_positions = [] { return std::vector<SampleOffset>{{.5, .5}, {.5, -.5}, {-.5, -.5}, {-.5, .5}}; };
       }},
      {"7.1", "a square grid",
       [](StageTable& t) {
         t.sample_positions = [] { return std::vector<SampleOffset>{{.25, .25}, {.25, -.25}, {-.25, -.25}, {-.25, .25}}; };
       }},
      {"7.1", "the grid mirrored",
       [](StageTable& t) {
         t.sample_positions = [] {
           return std::vector<SampleOffset>{{-.125, .375}, {-.375, -.125}, {.125, -.375}, {.375, .125}};
         };
       }},
      {"7.1", "from the pixel's corner, not its center",
       [](StageTable& t) {
         t.sample_positions = [] {
           return std::vector<SampleOffset>{{.625, .875}, {.875, .375}, {.375, .125}, {.125, .625}};
         };
       }},
      {"7.1", "dx and dy exchanged",
       [](StageTable& t) {
         t.sample_positions = [] {
           return std::vector<SampleOffset>{{.375, .125}, {-.125, .375}, {-.375, -.125}, {.125, -.375}};
         };
       }},
      {"7.1", "one sample four times",
       [](StageTable& t) { t.sample_positions = [] { return std::vector<SampleOffset>(4); }; }},
      {"7.1", "twice as far from the center",
       [](StageTable& t) {
         t.sample_positions = [] { return std::vector<SampleOffset>{{.25, .75}, {.75, -.25}, {-.25, -.75}, {-.75, .25}}; };
       }},
      {"7.1", "in another order",
       [](StageTable& t) {
         t.sample_positions = [] {
           return std::vector<SampleOffset>{{-.375, .125}, {-.125, -.375}, {.375, -.125}, {.125, .375}};
         };
       },
       Shows::in_unit_tests, "a mean does not depend on the order of its terms"},
      {"7.2", "the sum, not the mean",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color sum(0);
           for (const Color& sample : samples) sum += sample;
           return glm::clamp(sum, Color(0), Color(1));
         };
       }},
      {"7.2", "each sample clamped",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color sum(0);
           for (const Color& sample : samples)
             sum += glm::clamp(sample, Color(0), Color(1)) / static_cast<double>(samples.size());
           return sum;
         };
       }},
      {"7.2", "the first sample only",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) { return glm::clamp(samples[0], Color(0), Color(1)); };
       }},
      {"7.2", "clamped before the division",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color sum(0);
           for (const Color& sample : samples) sum += sample;
           return glm::clamp(sum, Color(0), Color(1)) / static_cast<double>(samples.size());
         };
       }},
      {"7.2", "the brightest sample",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color brightest(0);
           for (const Color& sample : samples) brightest = glm::max(brightest, sample);
           return glm::min(brightest, Color(1));
         };
       }},
      {"7.2", "gamma: the square root of the mean",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color mean(0);
           for (const Color& sample : samples) mean += sample / static_cast<double>(samples.size());
           return glm::sqrt(glm::clamp(mean, Color(0), Color(1)));
         };
       }},
      {"7.2", "no clamp",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color sum(0);
           for (const Color& sample : samples) sum += sample / static_cast<double>(samples.size());
           return sum;
         };
       },
       Shows::in_floats, "8 bits hold nothing beyond 1, so the file clamps"},
      {"7.2", "always divided by 4",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color sum(0);
           for (const Color& sample : samples) sum += sample;
           return glm::clamp(sum / 4.0, Color(0), Color(1));
         };
       },
       Shows::in_unit_tests, "stage 7 has four samples; `--aa grid16` would show it"},
      {"7.2", "a NaN hidden by fmin and fmax",
       [](StageTable& t) {
         t.resolve = [](std::span<const Color> samples) {
           Color mean(0);
           for (const Color& sample : samples) mean += sample / static_cast<double>(samples.size());
           for (int k = 0; k < 3; ++k) mean[k] = std::fmin(std::fmax(mean[k], 0), 1);
           return mean;
         };
       },
       Shows::in_unit_tests, "where all other tasks are right, no sample is a NaN"},
  };
}

}  // namespace raylab::test
