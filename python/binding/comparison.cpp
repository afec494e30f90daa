// Comparisons of methods: planned, their runs made here or elsewhere, and summarized.
#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "draw/report/comparison_files.h"
#include "lab/compare/comparison_json.h"
#include "lab/failure.h"
#include "python/binding/bindings.h"
#include "python/binding/listening.h"
#include "python/binding/record.h"
#include "python/binding/scene.h"
#include "tools/compare_runs.h"
#include "tools/output_place.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

using Texts = std::map<std::string, std::string>;

// What is asked for, in the words of the command line.
struct ComparisonRequest {
  BoundScene scene;
  Texts words;  // methods, budgets, reference
  std::vector<std::string> fixed, sweeps;
  std::size_t replicates = 8;
  std::uint64_t seed = 1;
  std::optional<double> target;
  std::string directory;
  bool replaces = false;
  int threads = 0;
  std::string command_line;

  CompareOptions options() const {
    CompareOptions options;
    options.scene = scene.source;
    options.document = scene.document;
    options.methods = words.at("methods");
    options.budgets = words.at("budgets");
    options.reference = words.at("reference");
    options.replicates = replicates;
    options.seed = seed;
    options.fixed = fixed;
    options.sweeps = sweeps;
    options.target = target;
    return options;
  }
  Global global() const {
    Global global;
    global.out = directory;
    global.force = replaces;
    global.threads = threads;
    global.seed = seed;
    return global;
  }
};

CompareTask examined(const CompareOptions& options, const Global& global) {
  Examination examination;
  std::optional<CompareTask> task = examine_compare(options, global, examination);
  examination.require_passed();
  return *std::move(task);
}

class BoundComparison {
 public:
  explicit BoundComparison(ComparisonRequest request)
      : request_(std::move(request)),
        options_(request_.options()),
        task_(examined(options_, request_.global())),
        place_(std::in_place, request_.directory, request_.global()) {}

  // Of each run that is to be made: its method and dials, its budget and seed.
  nb::typed<nb::list, nb::typed<nb::dict, nb::str, nb::any>> turns() const {
    nb::typed<nb::list, nb::typed<nb::dict, nb::str, nb::any>> list;
    for (const compare::Turn& turn : compare::turns_of(task_.plan)) {
      const compare::Entrant& entrant = task_.plan.entrants[turn.contender];
      nb::typed<nb::dict, nb::str, nb::any> row;
      nb::dict dials;
      for (const compare::Setting& setting : entrant.settings)
        dials[nb::str(setting.dial->word.data(), setting.dial->word.size())] = setting.value;
      row["method"] = entrant.contender.method;
      row["dials"] = dials;
      row["budget"] = task_.plan.budgets[turn.budget].text;
      row["seed"] = turn.seed;
      list.append(row);
    }
    return list;
  }

  // A run that was made elsewhere: the turn of this number; or why there is none.
  void take(std::size_t number, const BoundRecord& record) {
    keep(compare::finished(task_.plan, turn_of(number), record.run->rendering));
  }
  void take_failure(std::size_t number, const std::string& message) {
    const compare::Turn turn = turn_of(number);
    keep({.failure =
              compare::FailedRun{turn.contender, turn.budget, turn.replicate, turn.seed, message}});
  }

  // Makes what is not there; compare.json, and its files in the directory.
  std::string finish(nb::object progress) {
    go_on_from_kept();
    Listening listening(std::move(progress));
    const compare::CompareHost host{.session = listening.session(request_.seed, request_.threads),
                                    .announce = [](const compare::Forecast&) {},
                                    .command_line = request_.command_line};
    std::string json;
    listening.carry_out([&] {
      const compare::Comparison comparison =
          compare::summarize(compare::runs_of(task_, options_, host, place_->path()));
      compare::write_comparison(comparison, task_.document.scene, place_->path());
      json = compare::to_json(comparison).dump();
    });
    return json;
  }

  void close() { place_.reset(); }

 private:
  compare::Turn turn_of(std::size_t number) const {
    return compare::turns_of(task_.plan).at(number);
  }
  void keep(const compare::FinishedTurn& finished) {
    if (!taken_) taken_.emplace(task_.request, place_->path());
    taken_->keep(finished);
  }
  // What was taken is carried on like a comparison that was interrupted.
  void go_on_from_kept() {
    if (!taken_) return;
    taken_->keep_all();
    taken_.reset();
    options_.is_continuation = true;
    options_.scene.clear();  // it is kept, and may be in no file
    Global global = request_.global();
    global.force = false;
    task_ = examined(options_, global);
  }

  ComparisonRequest request_;
  CompareOptions options_;
  CompareTask task_;
  std::optional<OutputDirectory> place_;  // until it is closed
  std::optional<compare::KeptComparison> taken_;
};

}  // namespace

void bind_comparison(nb::module_& module) {
  nb::class_<BoundComparison>(module, "Comparison", "A comparison of methods.")
      .def(
          "__init__",
          [](BoundComparison* self, const BoundScene& scene, const Texts& words,
             const std::vector<std::string>& fixed, const std::vector<std::string>& sweeps,
             std::size_t replicates, std::uint64_t seed, std::optional<double> target,
             const std::string& directory, bool overwrite, int threads,
             const std::string& command_line) {
            new (self) BoundComparison(ComparisonRequest{scene, words, fixed, sweeps, replicates,
                                                         seed, target, directory, overwrite,
                                                         threads, command_line});
          },
          nb::arg("scene"), nb::arg("words"), nb::arg("fixed"), nb::arg("sweeps"),
          nb::arg("replicates"), nb::arg("seed"), nb::arg("target").none(), nb::arg("directory"),
          nb::arg("overwrite"), nb::arg("threads"), nb::arg("command_line"))
      .def("turns", &BoundComparison::turns, "The runs that are to be made.")
      .def("take", &BoundComparison::take, nb::arg("number"), nb::arg("record"),
           "A run that was made elsewhere.")
      .def("take_failure", &BoundComparison::take_failure, nb::arg("number"), nb::arg("message"),
           "A run that found no light.")
      .def("finish", &BoundComparison::finish, nb::arg("progress").none(), "compare.json")
      .def("close", &BoundComparison::close,
           "Others may write into the directory from now on; this is the end of it.");
}

}  // namespace wander::python
