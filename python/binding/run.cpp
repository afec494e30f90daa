// Runs that are made: begun, carried on as often as Python asks, and kept.
#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/film_statistics.h"
#include "lab/checkpoint.h"
#include "lab/failure.h"
#include "lab/held_run.h"
#include "lab/onward.h"
#include "lab/parsing.h"
#include "lab/run_warnings.h"
#include "lab/scene_source.h"
#include "mlt/seeds/nothing_found.h"
#include "python/binding/bindings.h"
#include "python/binding/listening.h"
#include "python/binding/record.h"
#include "python/binding/run_request.h"
#include "python/binding/scene.h"
#include "records/run_json.h"
#include "tools/output_place.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

// Rests after so many seconds of sampling, where a run that is interrupted has the bits of one that
// is not.
class Rest {
 public:
  explicit Rest(std::optional<double> seconds) : seconds_(seconds) {}

  bool is_due(const ProgressReport& report) {
    if (!seconds_ || report.phase != sampling) return false;
    if (!begun_) begun_ = report.seconds;
    return report.seconds - *begun_ >= *seconds_;
  }

 private:
  static constexpr std::string_view sampling = "sampling";

  std::optional<double> seconds_, begun_;
};

class BoundRun {
 public:
  explicit BoundRun(RunRequest request) : request_(std::move(request)) {}
  // From where it was kept.
  BoundRun(RunRequest request, Checkpoint&& kept, BoundRecord record)
      : request_(std::move(request)),
        from_(std::move(kept.run)),
        budget_(std::move(kept.budget)),
        record_(std::move(record)) {}

  // "complete", "rested" or "interrupted".
  std::string go_on(const std::string& budget, int threads, std::optional<double> rest,
                    nb::object progress) {
    const Alone alone(is_going_on_);
    Listening listening(std::move(progress));
    Rest resting(rest);
    const Session session{.budget = aimed_at(budget),
                          .seed = request_.seed,
                          .threads = threads,
                          .interrupted = &listening.is_stopped(),
                          .report = [&](const ProgressReport& report) {
                            listening.tell(report);
                            if (resting.is_due(report)) listening.stop();
                          }};
    BoundRecord made;
    try {
      listening.carry_out([&] { made = computed(session); });
    } catch (const NothingComputed&) {
      return "interrupted";
    }
    record_ = std::move(made);
    if (record_.run->rendering.complete) return "complete";
    return listening.heard_interrupt() ? "interrupted" : "rested";
  }

  // None before anything was computed.
  std::optional<BoundRecord> record() const {
    if (!record_.run) return std::nullopt;
    return record_;
  }

  // With its checkpoint: `wander render --continue` carries it on.
  void write(const std::string& directory, bool replaces, double exposure) {
    const Alone alone(is_going_on_);
    write_record(record_, directory, replaces, exposure);
    Checkpoint checkpoint = request_.checkpoint(budget_);
    checkpoint.run = run_ ? run_->kept() : from_;
    const StateWriter state = [&](std::ostream& bytes) { bytes << checkpoint.run.state; };
    write_checkpoint(checkpoint, state, directory);
  }

 private:
  // Of two threads that want it at once the second is told so.
  class Alone {
   public:
    explicit Alone(std::atomic<bool>& taken) : taken_(taken) {
      if (taken_.exchange(true))
        throw UsageError("this run is going on already, in another thread");
    }
    ~Alone() { taken_ = false; }
    Alone(const Alone&) = delete;
    Alone& operator=(const Alone&) = delete;

   private:
    std::atomic<bool>& taken_;
  };

  // What is left of such a budget for the run, of which it counts all.
  Budget aimed_at(const std::string& text) {
    Budget budget = parse_budget(text);
    const Headway done = run_ ? run_->headway() : from_.headway;
    const auto error = [this] {
      return record_.run ? relative_error(record_.run->rendering.film) : not_known;
    };
    const auto* count = std::get_if<SampleBudget>(&budget);
    if (count && count->samples < done.samples) return SampleBudget{done.samples};
    if (!budget_.empty() && !are_the_same(budget, parse_budget(budget_))) {
      switch (onward(parse_budget(budget_), budget, done, error, request_.job())) {
        case Onward::as_planned:
          return budget;
        case Onward::enough:
          return SampleBudget{done.samples};
        case Onward::begun_again:
          run_.reset();
          from_ = {};
          break;
        case Onward::further:
          break;
      }
    }
    budget_ = text;
    return budget;
  }
  BoundRecord computed(const Session& session) {
    if (!run_) {
      run_ = std::make_unique<HeldRun>(request_.job(), session, from_);
      from_ = {};
    }
    Rendering rendering = run_->go_on(session);
    const SceneDocument& document = request_.scene.document;
    add_warnings(rendering, session, document, request_.scene.source);
    return {std::make_shared<const RunRecord>(
        RunRecord{std::move(rendering), provenance_of(document, request_.command_line)})};
  }

  RunRequest request_;
  KeptRun from_;
  std::string budget_;
  std::unique_ptr<HeldRun> run_;
  BoundRecord record_;
  std::atomic<bool> is_going_on_ = false;
};

// None of a budget of another kind.
std::optional<std::uint64_t> samples_of(const std::string& budget) {
  const Budget parsed = parse_budget(budget);
  const auto* count = std::get_if<SampleBudget>(&parsed);
  return count ? std::optional(count->samples) : std::nullopt;
}

std::unique_ptr<BoundRun> begin(const BoundScene& scene, const std::string& method,
                                const std::map<std::string, std::string>& dials, std::uint64_t seed,
                                const std::string& command_line) {
  RunRequest request{scene, method, dials, seed, command_line};
  request.require_sound();
  return std::make_unique<BoundRun>(std::move(request));
}

constexpr const char* anew = "render the scene anew";

// From the checkpoint in a directory; with the source of its scene, and its budget.
std::tuple<std::unique_ptr<BoundRun>, std::string, std::string> resumed(
    const std::string& directory) {
  Checkpoint kept = read_checkpoint(directory, anew);
  RunRequest request{{reopened(kept.scene), kept.scene.source},
                     kept.method,
                     kept.dials,
                     kept.seed,
                     "wanderlight.open_run"};
  const std::string source = kept.scene.source, budget = kept.budget;
  const BoundRecord record{std::make_shared<const RunRecord>(read_run(directory))};
  return {std::make_unique<BoundRun>(std::move(request), std::move(kept), record), source, budget};
}

}  // namespace

void bind_run(nb::module_& module) {
  module.def("samples_of_budget", &samples_of, nb::arg("budget"),
             "None of one that is a time or an error; raises UsageError if it is none.");
  nb::class_<BoundRun>(module, "Run", "A run that goes on as often as it is asked.")
      .def(nb::new_(&begin), nb::arg("scene"), nb::arg("method"), nb::arg("dials"), nb::arg("seed"),
           nb::arg("command_line"))
      .def_static("resumed", &resumed, nb::arg("directory"),
                  "From its checkpoint; with the source of its scene, and its budget.")
      .def("go_on", &BoundRun::go_on, nb::arg("budget"), nb::arg("threads"), nb::arg("rest").none(),
           nb::arg("progress").none())
      .def_prop_ro("record", &BoundRun::record)
      .def("write", &BoundRun::write, nb::arg("directory"), nb::arg("overwrite"),
           nb::arg("exposure"));
}

}  // namespace wander::python
