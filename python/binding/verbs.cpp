// What the program does with whole scenes and runs: check, merge and import.
#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/failure.h"
#include "lab/merge.h"
#include "lab/scene_source.h"
#include "python/binding/bindings.h"
#include "python/binding/listening.h"
#include "python/binding/record.h"
#include "python/binding/run_request.h"
#include "records/atomic_file.h"
#include "tools/check_run.h"
#include "tools/import_files.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

using Texts = std::map<std::string, std::string>;

// The findings as JSON, and as text for people.
std::pair<std::string, std::string> check_of(const BoundScene& scene, const Texts& dials,
                                             std::uint64_t samples, std::uint64_t seed, int threads,
                                             nb::object progress) {
  const RunRequest request{scene, std::string(mutated_method().name), dials, seed, {}};
  request.require_sound();
  Listening listening(std::move(progress));
  Session session = listening.session(seed, threads);
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

BoundRecord merged(const std::vector<std::string>& directories, const std::string& scene,
                   int threads) {
  if (directories.empty()) throw UsageError("merge takes at least one run");
  std::vector<MergePart> parts;
  for (const std::string& directory : directories) parts.push_back(read_part(directory));
  require_mergeable(parts);
  const Checkpoint& first = parts.front().run;
  Listening listening{nb::object(nb::none())};
  const Session session = listening.session(first.seed, threads);
  BoundRecord record;
  listening.carry_out([&] {
    const SceneDocument document = reopened(first.scene, scene);
    const Job job(document.scene, find_method(first.method), first.turned());
    RunRecord run{merge(job, parts, session), provenance_of(document, "wanderlight.merge")};
    const std::vector<std::string> doubts =
        scene_warnings(document, scene.empty() ? first.scene.source : scene);
    run.rendering.warnings.insert(run.rendering.warnings.begin(), doubts.begin(), doubts.end());
    record.run = std::make_shared<const RunRecord>(std::move(run));
  });
  return record;
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
  module.def(
      "write_file",
      [](const std::string& path, const nb::bytes& bytes) {
        write_file(path, std::string_view(bytes.c_str(), bytes.size()));
      },
      nb::arg("path"), nb::arg("bytes"), "Whole or not at all.");
  module.def("merge", &merged, nb::arg("directories"), nb::arg("scene"), nb::arg("threads"));
  module.def("import_mitsuba", &imported, nb::arg("file"), nb::arg("out"), nb::arg("parameters"),
             nb::arg("approximate"), "What is not exact, each with its place.");
}

}  // namespace wander::python
