#include "core/submission/worker_engine.hpp"

#include "core/scene/diagnostic.hpp"

#include <algorithm>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

namespace raylab {
namespace {

constexpr int pixels_at_once = 32;

/// How long a few pixels may take: many times longer than slow code needs, since each of their rays may ask each geometry.
std::chrono::milliseconds time_for_pixels(const Scene& scene, const WorkerLimits& limits) {
  return 2 * limits.call + std::chrono::milliseconds(geometry_count(scene) / 4);
}

class WorkerEngine final : public Engine {
 public:
  WorkerEngine(const Scene& scene, const Settings& settings, WorkerSetup setup, unsigned threads,
               std::function<void(const std::string&)> stands_in)
      : settings_(settings),
        setup_(std::move(setup)),
        limit_(time_for_pixels(scene, setup_.limits)),
        scene_request_("scene " + to_json(SceneMessage{scene, settings})),
        stands_in_(std::move(stands_in)) {
    // Here, not in the threads that use them: a worker ends with the thread that has started it.
    for (unsigned k = 0; k < threads; ++k) idle_.push_back(std::make_unique<Worker>(setup_));
    for (const auto& worker : idle_) prepare(*worker);
  }

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    const Borrowed worker(*this);
    const auto width = static_cast<std::size_t>(settings_.size.width);
    for (std::size_t row = 0; row * width < pixels.size(); ++row)
      trace_row(*worker.get(), first_row + static_cast<int>(row), pixels.subspan(row * width, width), counts, cancel);
  }

 private:
  /// A worker while a thread uses it.
  class Borrowed {
   public:
    explicit Borrowed(const WorkerEngine& engine) : engine_(engine) {
      const std::lock_guard lock(engine.mutex_);
      if (engine.idle_.empty()) throw std::logic_error("more threads than workers");
      worker_ = std::move(engine.idle_.back());
      engine.idle_.pop_back();
    }
    ~Borrowed() {
      const std::lock_guard lock(engine_.mutex_);
      engine_.idle_.push_back(std::move(worker_));
    }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;

    Worker* get() const { return worker_.get(); }

   private:
    const WorkerEngine& engine_;
    std::unique_ptr<Worker> worker_;
  };

  void prepare(Worker& worker) const {
    worker.ask(scene_request_, limit_, [this](auto verb, auto rest) { note(verb, rest); });
  }

  void note(std::string_view verb, std::string_view rest) const {
    if (verb != "stands-in") return;
    const std::string what = text_in(rest);
    const std::lock_guard lock(mutex_);
    if (noted_.insert(what).second) stands_in_(what);
  }

  static std::string text_in(std::string_view json) {
    try {
      return from_json<std::string>(json);
    } catch (const InputError&) {
      throw NoAnswer(Trouble::no_value, "sent something that is no answer");
    }
  }

  void trace_row(Worker& worker, int row, std::span<Color> pixels, RayCounts& counts,
                 const std::atomic<bool>& cancel) const {
    for (std::size_t done = 0; done < pixels.size(); done += pixels_at_once) {
      const std::size_t some = std::min<std::size_t>(pixels_at_once, pixels.size() - done);
      const TraceMessage wanted{row, static_cast<int>(done), static_cast<int>(some)};
      const TraceAnswer answer = traced(worker, wanted, cancel);
      std::copy(answer.pixels.begin(), answer.pixels.end(), pixels.begin() + static_cast<std::ptrdiff_t>(done));
      counts += answer.rays;
    }
  }

  TraceAnswer traced(Worker& worker, const TraceMessage& wanted, const std::atomic<bool>& cancel) const {
    const std::string request = "trace " + to_json(wanted);
    try {
      const auto aside = [this](auto verb, auto rest) { note(verb, rest); };
      auto answer = from_json<TraceAnswer>(worker.ask(request, limit_, aside, &cancel));
      if (answer.pixels.size() != static_cast<std::size_t>(wanted.pixels)) throw InputError("another number of pixels");
      return answer;
    } catch (const NoAnswer& error) {
      fail_in_call(wanted, error, cancel);
    } catch (const InputError& error) {
      fail_in_call(wanted, {Trouble::no_value, "gave an answer that is none: " + printable(error.what())}, cancel);
    }
  }

  /// Traces the pixels again in a worker that says before each call what it will be; the last one is where it ends.
  [[noreturn]] void fail_in_call(const TraceMessage& pixels, const NoAnswer& how, const std::atomic<bool>& cancel) const {
    std::string last;
    try {
      Worker worker(setup_);
      prepare(worker);
      worker.ask("announce {}", setup_.limits.call);
      const auto aside = [&](std::string_view verb, std::string_view rest) {
        if (verb == "calling") last = rest;
      };
      worker.ask("trace " + to_json(pixels), setup_.limits.call, aside, &cancel);
      last.clear();  // it did not happen again
    } catch (const NoAnswer&) {
    }
    const std::string where = "pixels " + std::to_string(pixels.column) + " to " +
                              std::to_string(pixels.column + pixels.pixels - 1) + " of row " + std::to_string(pixels.row);
    if (last.empty()) throw NoAnswer(how.trouble, "the submission " + std::string(how.what()) + ", at " + where);
    const auto [label, arguments] = first_word(last);
    NoAnswer full(how.trouble, "task " + std::string(label) + ' ' + how.what() + ", at " + where + ". " +
                                   repeated_call(setup_, label, arguments));
    full.label = label;
    full.arguments = arguments;
    throw full;
  }

  const Settings settings_;
  const WorkerSetup setup_;
  const std::chrono::milliseconds limit_;
  const std::string scene_request_;
  const std::function<void(const std::string&)> stands_in_;
  mutable std::mutex mutex_;  // guards what follows
  mutable std::vector<std::unique_ptr<Worker>> idle_;
  mutable std::set<std::string> noted_;
};

}  // namespace

std::unique_ptr<Engine> make_worker_engine(const Scene& scene, const Settings& settings, const WorkerSetup& setup,
                                           unsigned threads, std::function<void(const std::string&)> stands_in) {
  return std::make_unique<WorkerEngine>(scene, settings, setup, threads, std::move(stands_in));
}

}  // namespace raylab
