// `wander import`: a scene of Mitsuba as a scene file, with its meshes and pictures beside it.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "lab/failure.h"
#include "scenes/import/import_mitsuba.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/import_files.h"
#include "tools/output_place.h"
#include "tools/verb.h"

namespace wander {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct ImportOptions {
  std::string file;
  bool approximate = false;
  std::vector<std::string> definitions;  // NAME=VALUE
};

XmlParameters parameters_of(const ImportOptions& options) {
  XmlParameters parameters;
  for (const std::string& definition : options.definitions) {
    const std::size_t equals = definition.find('=');
    if (equals == std::string::npos || equals == 0)
      throw UsageError(fmt::format("-D {}: it is -D NAME=VALUE", definition));
    parameters[definition.substr(0, equals)] = definition.substr(equals + 1);
  }
  return parameters;
}

void examine(const ImportOptions& options, const Global& global, Examination& examination) {
  examination.part([&] {
    if (global.out.empty())
      throw UsageError("import needs -o SCENE.json, where the scene goes; its meshes go beside it");
    if (is_standard_output(global.out))
      throw UsageError("-o - is standard output, and meshes lie beside a scene; name a file");
    // Files that the scene includes are not known yet, and --force would replace them.
    if (const fs::path ending = global.out.extension(); ending == ".xml" || ending == ".XML")
      throw UsageError(fmt::format("-o {}: a scene file is no XML; name it {}", global.out.string(),
                                   fs::path(global.out).replace_extension(".json").string()));
    require_replaceable(global.out, global);
    require_apart(global.out, std::span(&options.file, 1));
    const fs::path folder = global.out.parent_path() / mesh_folder_of(global.out);
    std::error_code error;
    if (fs::exists(folder, error) && !global.force)
      throw UsageError(
          fmt::format("{} exists, where the meshes would go; add --force to replace "
                      "what has the same names",
                      folder.string()));
    require_writable_directory(global.out);
  });
  examination.part([&] { parameters_of(options); });
}

ordered_json summary_of(const ImportedScene& scene, const Global& global) {
  ordered_json files = ordered_json::array(), approximations = ordered_json::array();
  for (const ImportedFile& file : scene.files) files.push_back(file.path);
  for (const ImportFault& one : scene.approximations)
    approximations.push_back({{"file", one.file},
                              {"line", one.line},
                              {"column", one.column},
                              {"path", one.path},
                              {"what", one.what}});
  return {{"schema", "wanderlight-import/1"}, {"scene", global.out.string()},
          {"shapes", scene.shapes},           {"materials", scene.materials},
          {"files", std::move(files)},        {"approximations", std::move(approximations)}};
}

ExitCode import_scene(const ImportOptions& options, const Global& global) {
  const ImportedScene scene =
      import_to(global.out, options.file, parameters_of(options),
                options.approximate ? Fidelity::approximate : Fidelity::exact);
  for (const ImportFault& one : scene.approximations) spdlog::warn("{}", line_of(one));
  if (!global.quiet)
    print_note(fmt::format(
        "{}: shapes: {}, materials: {}, files: {}; {}\n", global.out.string(), scene.shapes,
        scene.materials, scene.files.size(),
        scene.approximations.empty() ? "all of it is exact" : "what is not exact is listed above"));
  if (global.json) print_json(summary_of(scene, global));
  return ExitCode::ok;
}

constexpr const char* import_details = R"(
FILE.xml is a scene of Mitsuba 3 or 0.6.  What cannot be said exactly is an error, all of them at once with
their places; with --approximate the nearest thing is imported instead, and each is listed on stderr and in
the "description" of the scene.  What maps to what: docs/importing.md.

Meshes and pictures are copied into the folder SCENE-meshes beside SCENE.json, each content once.

Examples:
  wander import cbox.xml -o cbox.json
  wander import cbox.xml -o cbox.json -D width=200 -D height=200 --approximate
)";

}  // namespace

void add_import(CLI::App& app, Global& global) {
  auto options = std::make_shared<ImportOptions>();
  Command verb = add_verb(app, "import", "make a scene file of a Mitsuba scene");
  verb.add_option("FILE.xml", options->file, "a scene of Mitsuba, 3.x or 0.6")
      .type_name("")
      .required();
  verb.add_flag("--approximate", options->approximate,
                "import the nearest thing where there is no exact one, and say so");
  verb.add_option("-D,--define", options->definitions,
                  "the value of a parameter $NAME of the scene")
      .type_name("NAME=VALUE")
      .one_value_each_time();
  add_global_options(verb, global);
  verb.footer(import_details);
  examine_with(verb, global, [options, &global](Examination& examination) {
    examine(*options, global, examination);
  });
  verb.callback([options, &global] {
    global.job = [options, &global] { return import_scene(*options, global); };
  });
}

}  // namespace wander
