// `wander gallery`: the scenes that come with the program.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "lab/scene_source.h"
#include "records/atomic_file.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/output_place.h"
#include "tools/verb.h"

namespace wander {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json document_of(const GalleryScene& scene) {
  return ordered_json::parse(scene.text, nullptr, true, true);  // comments are allowed
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

ordered_json listing() {
  ordered_json scenes = ordered_json::array();
  for (const GalleryScene& scene : std::span(gallery_scenes, gallery_scene_count)) {
    const ordered_json document = document_of(scene);
    scenes.push_back({{"name", scene.name},
                      {"description", first_line(document.value("description", ""))},
                      {"dimension", document.value("dimension", 2)}});
  }
  return {{"schema", "wanderlight-gallery/1"}, {"scenes", std::move(scenes)}};
}

std::string listing_text() {
  std::string text;
  const ordered_json list = listing();
  for (const ordered_json& scene : list["scenes"])
    text += fmt::format("{:<20} {}\n", scene["name"].get<std::string>(),
                        scene["description"].get<std::string>());
  return text;
}

// With -o the text is written there, as it would be to stdout, where --json still prints.
ExitCode show(const std::string& text, const ordered_json& document, const Global& global) {
  if (!global.out.empty()) {
    require_replaceable(global.out, global);
    write_output(global.out, text);
  }
  if (global.json)
    print_json(document);
  else if (global.out.empty())
    print_data(text);
  return ExitCode::ok;
}

bool holds(const fs::path& file, std::string_view text) {
  std::ifstream stream(file, std::ios::binary);
  return stream && std::string(std::istreambuf_iterator(stream), {}) == text;
}

// Beside the scene, where it looks for them: those that are not there yet.
void write_meshes(const std::vector<GalleryMesh>& meshes, const Global& global) {
  const fs::path folder = global.out.parent_path();
  std::vector<StagedFile> files;
  for (const GalleryMesh& mesh : meshes) {
    const fs::path file = folder / mesh.file;
    if (holds(file, mesh.text)) continue;
    require_replaceable(file, global);
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw OutputError(file.string(), error.value());
    files.emplace_back(file, mesh.text);
  }
  StagedFile::commit_together(files);
}

// Pipes and devices have no folder.
bool is_written_to_a_folder(const Global& global) {
  std::error_code ignored;
  const fs::file_status status = fs::status(global.out, ignored);
  return !global.out.empty() && !is_standard_output(global.out) &&
         (!fs::exists(status) || fs::is_regular_file(status));
}

void say_what_is_missing(const GalleryScene& scene, const std::vector<GalleryMesh>& meshes) {
  std::vector<std::string_view> files;
  for (const GalleryMesh& mesh : meshes) files.emplace_back(mesh.file);
  print_note(
      fmt::format("The scene needs {}: wander gallery {} -o FILE.json writes {} beside it.\n",
                  fmt::join(files, ", "), scene.name, files.size() > 1 ? "them" : "it"));
}

ExitCode show_gallery(const std::string& name, const Global& global) {
  if (name.empty()) return show(listing_text(), listing(), global);
  const GalleryScene& scene = gallery_scene(name);
  const std::vector<GalleryMesh> meshes = meshes_of(scene);
  if (is_written_to_a_folder(global)) {
    require_replaceable(global.out, global);
    write_meshes(meshes, global);
  } else if (!meshes.empty() && !global.quiet) {
    say_what_is_missing(scene, meshes);
  }
  return show(scene.text, document_of(scene), global);
}

}  // namespace

void add_gallery(CLI::App& app, Global& global) {
  auto name = std::make_shared<std::string>();
  Command verb = add_verb(app, "gallery", "list the scenes that come with the program");
  verb.add_option("NAME", *name, "print this scene's file").type_name("");
  add_global_options(verb, global);
  verb.footer(
      "\nExample:\n  wander gallery NAME -o scene.json\n\n"
      "Meshes that the scene names are written beside it, into meshes/.\n"
      "Verbs that take a SCENE also take gallery:NAME.");
  verb.callback(
      [name, &global] { global.job = [name, &global] { return show_gallery(*name, global); }; });
}

}  // namespace wander
