// What the program does with whole scenes and runs: check, compare, merge and import.
#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "draw/report/comparison_files.h"
#include "lab/compare/comparison_json.h"
#include "lab/merge.h"
#include "lab/scene_source.h"
#include "python/binding/bindings.h"
#include "python/binding/listening.h"
#include "python/binding/record.h"
#include "python/binding/run_request.h"
#include "tools/check_run.h"
#include "tools/compare_runs.h"
#include "tools/import_files.h"
#include "tools/output_place.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

namespace fs = std::filesystem;
using Texts = std::map<std::string, std::string>;

Session heard_by(Listening& listening, std::uint64_t seed, int threads) {
  return {.seed = seed,
          .threads = threads,
          .interrupted = &listening.is_stopped(),
          .report = [&](const ProgressReport& report) { listening.tell(report); }};
}

// The findings as JSON, and as text for people.
std::pair<std::string, std::string> check_of(const BoundScene& scene, const Texts& dials,
                                             std::uint64_t samples, std::uint64_t seed, int threads,
                                             nb::object progress) {
  const RunRequest request{scene, std::string(mutated_method().name), dials, seed, {}};
  request.require_sound();
  Listening listening(std::move(progress));
  Session session = heard_by(listening, seed, threads);
  session.budget = SampleBudget{samples};
  std::string json, text;
  listening.carry_out([&] {
    const CheckReport report = check(scene.document, request.job(), samples, session);
    json = json_of(report).dump();
    text = text_of(report);
  });
  return {json, text};
}

// ---- runs of different seeds

BoundRecord merged(const std::vector<std::string>& directories, int threads) {
  std::vector<MergePart> parts;
  for (const std::string& directory : directories) parts.push_back(read_part(directory));
  require_mergeable(parts);
  const Checkpoint& first = parts.front().run;
  Listening listening{nb::object(nb::none())};
  const Session session = heard_by(listening, first.seed, threads);
  BoundRecord record;
  listening.carry_out([&] {
    const SceneDocument document = reopen_scene(first.scene_text, first.scene_source);
    const Job job(document.scene, find_method(first.method), first.turned());
    RunRecord run{merge(job, parts, session), provenance_of(document, "wanderlight.merge")};
    const std::vector<std::string> doubts = scene_warnings(document, first.scene_source);
    run.rendering.warnings.insert(run.rendering.warnings.begin(), doubts.begin(), doubts.end());
    record.run = std::make_shared<const RunRecord>(std::move(run));
  });
  return record;
}

// ---- comparisons

CompareOptions options_of(const BoundScene& scene, const Texts& words,
                          const std::vector<std::string>& fixed,
                          const std::vector<std::string>& sweeps, std::size_t replicates,
                          std::uint64_t seed, std::optional<double> target) {
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

// compare.json; its files are in the directory.
std::string comparison_of(const BoundScene& scene, const Texts& words,
                          const std::vector<std::string>& fixed,
                          const std::vector<std::string>& sweeps, std::size_t replicates,
                          std::uint64_t seed, std::optional<double> target,
                          const std::string& directory, bool replaces, int threads,
                          const std::string& command_line, nb::object progress) {
  Global global;
  global.out = directory;
  global.force = replaces;
  global.threads = threads;
  global.seed = seed;
  const CompareOptions options = options_of(scene, words, fixed, sweeps, replicates, seed, target);
  Examination examination;
  std::optional<CompareTask> task = examine_compare(options, global, examination);
  examination.require_passed();
  const OutputDirectory place(directory, global);
  Listening listening(std::move(progress));
  const compare::CompareHost host{.session = heard_by(listening, seed, threads),
                                  .announce = [](const compare::Forecast&) {},
                                  .command_line = command_line};
  std::string json;
  listening.carry_out([&] {
    const compare::Comparison comparison =
        compare::summarize(compare::runs_of(*task, options, host, place.path()));
    compare::write_comparison(comparison, task->document.scene, place.path());
    json = compare::to_json(comparison).dump();
  });
  return json;
}

// ---- scenes of Mitsuba

// What is not exact, each with its place.
std::vector<std::string> imported(const std::string& file, const std::string& out,
                                  const Texts& parameters, bool approximate) {
  std::vector<std::string> notes;
  const XmlParameters words(parameters.begin(), parameters.end());
  const ImportedScene scene =
      import_to(out, file, words, approximate ? Fidelity::approximate : Fidelity::exact);
  for (const ImportFault& note : scene.approximations) notes.push_back(line_of(note));
  return notes;
}

}  // namespace

void bind_verbs(nb::module_& module) {
  module.def("check", &check_of, nb::arg("scene"), nb::arg("dials"), nb::arg("samples"),
             nb::arg("seed"), nb::arg("threads"), nb::arg("progress").none(),
             "The findings as JSON and as text.");
  module.def("merge", &merged, nb::arg("directories"), nb::arg("threads"));
  module.def("compare", &comparison_of, nb::arg("scene"), nb::arg("words"), nb::arg("fixed"),
             nb::arg("sweeps"), nb::arg("replicates"), nb::arg("seed"), nb::arg("target").none(),
             nb::arg("directory"), nb::arg("overwrite"), nb::arg("threads"),
             nb::arg("command_line"), nb::arg("progress").none(), "compare.json");
  module.def("import_mitsuba", &imported, nb::arg("file"), nb::arg("out"), nb::arg("parameters"),
             nb::arg("approximate"), "What is not exact, each with its place.");
}

}  // namespace wander::python
