#include "lab/scene_source.h"

#include <fmt/format.h>

#include <iostream>
#include <span>

#include "lab/failure.h"
#include "lab/nearest.h"
#include "records/version.h"

namespace wander {

namespace {

constexpr std::string_view standard_input = "-";

}  // namespace

bool is_scene(std::string_view source) {
  return source == standard_input || source.starts_with(gallery_prefix);
}

std::string shown_name(const std::string& source) {
  return source == standard_input ? "<stdin>" : source;
}

SceneDocument open_scene(const std::string& source) {
  if (source == standard_input) return read_scene(std::cin, shown_name(source));
  if (!source.starts_with(gallery_prefix)) return read_scene_file(source);
  const GalleryScene& scene = gallery_scene(std::string_view(source).substr(gallery_prefix.size()));
  return parse_scene(scene.text, source);
}

Provenance provenance_of(const SceneDocument& document, const std::string& command_line) {
  return {.scene_name = document.scene.name,
          .scene_text = document.text,
          .scene_sha256 = document.sha256,
          .dimension = document.scene.dimension,
          .command_line = command_line,
          .version = program_version(),
          .origin = origin_here()};
}

std::vector<std::string> scene_warnings(const SceneDocument& document, const std::string& source) {
  std::vector<std::string> lines;
  for (const Fault& fault : document.warnings)
    lines.push_back(fmt::format("{}:{}:{}: {}: {}", shown_name(source), fault.line, fault.column,
                                fault.pointer, fault.what));
  return lines;
}

const GalleryScene& gallery_scene(std::string_view name) {
  std::vector<std::string_view> known;
  for (const GalleryScene& scene : std::span(gallery_scenes, gallery_scene_count)) {
    if (scene.name == name) return scene;
    known.emplace_back(scene.name);
  }
  throw UsageError(unknown_word("scene", name, known));
}

}  // namespace wander
