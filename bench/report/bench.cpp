#include "bench/report/bench.hpp"

#include "bench/fma_peak.hpp"
#include "bench/report/choices.hpp"
#include "bench/report/edges.hpp"
#include "bench/report/figures.hpp"
#include "bench/report/growth.hpp"
#include "bench/report/journal.hpp"
#include "bench/report/kernels.hpp"
#include "bench/report/machine.hpp"
#include "bench/report/page.hpp"
#include "bench/report/race.hpp"
#include "core/image/partial_file.hpp"
#include "core/render/engine.hpp"

#include <algorithm>
#include <iterator>
#include <ostream>

namespace raylab::bench {
namespace {

/// The most that multiply-adds in float can do in this thread, in thousand million operations a second: now and then, since
/// a processor's clock changes.
std::vector<Unit> peak_units() {
  return {{"machine/peak", 0.3, [](const std::atomic<bool>&) {
             Json all = Json::array();
             for (int round = 0; round < 9; ++round) all.push_back(1e-9 * fma_peak());
             return all;
           }}};
}

std::vector<Unit> all_units(const BenchRun& run, const StageTable& stages) {
  std::vector<Unit> all = peak_units();
  for (std::vector<Unit> some : {image_units(run.plan, run.scenes, stages), kernel_units(run.plan, stages),
                                 growth_units(run.plan, stages), edge_units(run.plan)})
    all.insert(all.end(), std::move_iterator(some.begin()), std::move_iterator(some.end()));
  return all;
}

/// Of what the figures are: another run of the same may go on with them.
Json identity_of(const BenchRun& run, const Json& machine) {
  Json scenes = Json::array();
  for (std::size_t k = 0; k < run.scenes.size(); ++k)
    scenes.push_back({{"scene", run.scenes[k].name}, {"sha1", run.scene_hashes[k]}});
  return {{"mode", run.plan.quick ? "quick" : "full"}, {"machine", machine}, {"scenes", std::move(scenes)}};
}

void measure(const std::vector<Unit>& units, Journal& journal, const BenchProgress& progress,
             const std::atomic<bool>& cancel) {
  double all = 0, done = 0;
  for (const Unit& unit : units) all += unit.seconds;
  for (const Unit& unit : units) {
    progress(done / all, unit.name);
    done += unit.seconds;
    if (journal.results().contains(unit.name)) continue;
    if (cancel) throw Cancelled{};
    const double start = wall_seconds();
    Json result = unit.measure(cancel);
    journal.add(unit.name, std::move(result), wall_seconds() - start);
  }
}

Json header_of(const BenchRun& run, const Json& identity, const Journal& journal) {
  Json header = {{"date", journal.date()}, {"command", run.command}, {"seconds", journal.seconds()}};
  header.update({{"mode", identity["mode"]}, {"scenes", identity["scenes"]}});
  header.update(identity["machine"]);
  header["fma_peak_gflops"] = spread(journal.results().at("machine/peak"));
  return header;
}

/// How far the times can be believed.
Json noise_of(const std::vector<Figure>& figures) {
  std::size_t times = 0, noisy = 0;
  for (const Figure& figure : figures) {
    times += figure.low.has_value();
    noisy += figure.noisy;
  }
  const std::string counted = std::to_string(noisy) + " of " + std::to_string(times) + " times";
  const std::string meaning = ": half of their rounds lie in a range wider than a tenth of the time itself.";
  std::string sentence = "No time was too noisy to judge by.";
  if (10 * noisy > times)
    sentence =
        "The machine was busy: " + counted + " are too noisy to judge by" + meaning + " Repeat the run on an idle machine.";
  else if (noisy > 0)
    sentence = counted + " are too noisy to judge by, and marked" + meaning;
  return {{"noisy", noisy}, {"times", times}, {"sentence", sentence}};
}

void write_report(const std::filesystem::path& folder, const Json& report, const std::vector<Figure>& figures) {
  write_file(folder / "report.json", [&](std::ostream& out) { out << report.dump(1) << '\n'; });
  write_file(folder / "report.html", [&](std::ostream& out) { write_page(out, report); });
  write_file(folder / "report.csv", [&](std::ostream& out) { write_csv(out, figures); });
}

}  // namespace

Json run_bench(const BenchRun& run, const StageTable& stages, const BenchProgress& progress,
               const std::atomic<bool>& cancel) {
  const Json identity = identity_of(run, describe_machine());
  Journal journal(run.out / "measurements.jsonl", identity);
  measure(all_units(run, stages), journal, progress, cancel);

  const Results& results = journal.results();
  Json report = {{"format", "raylab bench 1"}, {"header", header_of(run, identity, journal)}};
  Json images = image_report(run.plan, run.scenes, results);
  report["choices"] = choices_from(images);
  report["images"] = std::move(images);
  report["kernels"] = kernel_report(results);
  report["growth"] = growth_report(run.plan, results);
  report["edges"] = edge_report(results);
  const std::vector<Figure> figures = figures_of(report);
  report["noise"] = noise_of(figures);
  write_report(run.out, report, figures);
  journal.remove();
  return report;
}

}  // namespace raylab::bench
