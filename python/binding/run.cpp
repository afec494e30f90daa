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

// As far as it has come: in memory, or where it was kept.
struct Progressed {
  std::string budget{};
  KeptRun from{};                  // until it goes on from there
  std::unique_ptr<HeldRun> run{};  // from then on
  BoundRecord record{};            // of what was computed

  const Headway& headway() const { return run ? run->headway() : from.headway; }
  KeptRun kept() const { return run ? run->kept() : from; }
  double error() const {
    return record.run ? relative_error(record.run->rendering.film) : not_known;
  }
};

class BoundRun {
 public:
  explicit BoundRun(RunRequest request) : request_(std::move(request)) {}
  // From where it was kept.
  BoundRun(RunRequest request, Checkpoint&& kept, BoundRecord record)
      : request_(std::move(request)),
        shown_{.budget = std::move(kept.budget),
               .from = std::move(kept.run),
               .record = std::move(record)} {}

  // "complete", "rested" or "interrupted".
  std::string go_on(const std::string& budget, int threads, std::optional<double> rest,
                    nb::object progress) {
    const Alone alone(is_going_on_);
    Listening listening(std::move(progress));
    Rest resting(rest);
    Progressed& run = run_for(budget);
    const Session session{.budget = aimed_at(run, budget),
                          .seed = request_.seed,
                          .threads = threads,
                          .interrupted = &listening.is_stopped(),
                          .report = [&](const ProgressReport& report) {
                            listening.tell(report);
                            if (resting.is_due(report)) listening.stop();
                          }};
    BoundRecord made;
    try {
      listening.carry_out([&] { made = computed(run, session); });
    } catch (const NothingComputed&) {
      return "interrupted";
    }
    run.record = std::move(made);
    const bool is_complete = run.record.run->rendering.complete;
    if (anew_ && (is_complete || anew_->headway().samples >= shown_.headway().samples)) {
      shown_ = std::move(*anew_);
      anew_.reset();
    }
    if (is_complete) return "complete";
    return listening.heard_interrupt() ? "interrupted" : "rested";
  }

  // None before anything was computed.
  std::optional<BoundRecord> record() const {
    if (!shown_.record.run) return std::nullopt;
    return shown_.record;
  }

  // With its checkpoint: `wander render --continue` carries it on.
  void write(const std::string& directory, bool replaces, double exposure) {
    const Alone alone(is_going_on_);
    if (!shown_.record.run) throw UsageError("this run has computed nothing yet");
    write_record(shown_.record, directory, replaces, exposure);
    Checkpoint checkpoint = request_.checkpoint(shown_.budget);
    checkpoint.run = shown_.kept();
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

  // What such a budget, of which a run counts all, asks of it.
  Onward onward_of(const Progressed& run, const std::string& text) const {
    const Budget budget = parse_budget(text);
    const auto* count = std::get_if<SampleBudget>(&budget);
    if (count && count->samples < run.headway().samples) return Onward::enough;
    if (run.budget.empty() || budget == parse_budget(run.budget)) return Onward::further;
    return onward(
        parse_budget(run.budget), budget, run.headway(), [&] { return run.error(); },
        request_.job());
  }
  // One that has to begin again does so beside the old one.
  Progressed& run_for(const std::string& budget) {
    if (onward_of(shown_, budget) != Onward::begun_again) {
      anew_.reset();
      return shown_;
    }
    if (!anew_ || onward_of(*anew_, budget) == Onward::begun_again)
      anew_ = Progressed{.budget = budget};
    return *anew_;
  }
  Budget aimed_at(Progressed& run, const std::string& text) const {
    switch (onward_of(run, text)) {
      case Onward::enough:
        return SampleBudget{run.headway().samples};
      case Onward::as_planned:
        break;
      default:
        run.budget = text;
    }
    return parse_budget(text);
  }
  BoundRecord computed(Progressed& run, const Session& session) {
    if (!run.run) {
      run.run = std::make_unique<HeldRun>(request_.job(), session, run.from);
      run.from = {};
    }
    Rendering rendering = run.run->go_on(session);
    const SceneDocument& document = request_.scene.document;
    add_warnings(rendering, session, document, request_.scene.source);
    return {std::make_shared<const RunRecord>(
        RunRecord{std::move(rendering), provenance_of(document, request_.command_line)})};
  }

  RunRequest request_;
  Progressed shown_;
  // One that has begun again, until it has ended or has as many samples as the one that is shown.
  std::optional<Progressed> anew_;
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

// From the checkpoint in a directory; with its scene, and its budget.
std::tuple<std::unique_ptr<BoundRun>, BoundScene, std::string> resumed(
    const std::string& directory, const std::string& scene_now) {
  Checkpoint kept = read_checkpoint(directory, anew);
  const BoundScene scene{reopened(kept.scene, scene_now),
                         scene_now.empty() ? kept.scene.source : scene_now};
  const std::string budget = kept.budget;
  RunRequest request{scene, kept.method, kept.dials, kept.seed, "wanderlight.open_run"};
  const BoundRecord record{std::make_shared<const RunRecord>(read_run(directory))};
  return {std::make_unique<BoundRun>(std::move(request), std::move(kept), record), scene, budget};
}

}  // namespace

void bind_run(nb::module_& module) {
  module.def("samples_of_budget", &samples_of, nb::arg("budget"),
             "None of one that is a time or an error; raises UsageError if it is none.");
  nb::class_<BoundRun>(module, "Run", "A run that goes on as often as it is asked.")
      .def(nb::new_(&begin), nb::arg("scene"), nb::arg("method"), nb::arg("dials"), nb::arg("seed"),
           nb::arg("command_line"))
      .def_static("resumed", &resumed, nb::arg("directory"), nb::arg("scene"),
                  "From its checkpoint; with its scene, and its budget.")
      .def("go_on", &BoundRun::go_on, nb::arg("budget"), nb::arg("threads"), nb::arg("rest").none(),
           nb::arg("progress").none())
      .def_prop_ro("record", &BoundRun::record)
      .def("write", &BoundRun::write, nb::arg("directory"), nb::arg("overwrite"),
           nb::arg("exposure"));
}

}  // namespace wander::python
