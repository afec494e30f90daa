#include "scenes/format/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "scenes/format/json_document.h"
#include "scenes/format/json_explain.h"
#include "scenes/format/json_text.h"
#include "scenes/format/lint.h"
#include "scenes/format/scene_file_build.h"
#include "scenes/format/scene_file_check.h"
#include "scenes/format/scene_file_schema.h"
#include "scenes/format/sha256.h"

namespace wander {

namespace {

constexpr std::size_t largest_scene_file = std::size_t{64} << 20;

std::string lines_of(const std::string& file, const std::vector<Fault>& faults) {
  std::string lines;
  for (const Fault& fault : faults)
    lines += fmt::format("{}{}:{}:{}: {}: {}", lines.empty() ? "" : "\n", file, fault.line,
                         fault.column, fault.pointer, fault.what);
  return lines;
}

// In the order of the text, no more than a hundred.
std::vector<Fault> located(std::vector<JsonFault> faults, std::string_view text) {
  std::sort(faults.begin(), faults.end());
  faults.erase(std::unique(faults.begin(), faults.end()), faults.end());
  Places places(text);
  std::vector<Fault> result;
  for (JsonFault& fault : faults) {
    const auto [line, column] = places.of(fault.byte);
    if (result.size() == json_limits.faults) {
      result.push_back(
          {line, column, "/",
           fmt::format("more faults follow; these are the first {}", json_limits.faults)});
      break;
    }
    result.push_back({line, column, std::move(fault.pointer), std::move(fault.what)});
  }
  return result;
}

// Of a document that is JSON; reads the meshes and textures that it names.
std::vector<JsonFault> faults_in(const JsonDocument& document, std::vector<JsonFault> faults,
                                 const SceneFiles& files, SceneMeshes& meshes,
                                 SceneTextures& textures) {
  static const auto schema = nlohmann::ordered_json::parse(scene_schema_text);
  const Explanation explanation = explain(document, schema);
  faults.insert(faults.end(), explanation.faults.begin(), explanation.faults.end());
  const auto more = check_scene(document, faults, explanation.meant);
  faults.insert(faults.end(), more.begin(), more.end());
  const auto of_textures = textures.read(document, faults, files.texture);
  const auto of_meshes = meshes.read(document, faults, files.mesh);
  faults.insert(faults.end(), of_textures.begin(), of_textures.end());
  faults.insert(faults.end(), of_meshes.begin(), of_meshes.end());
  return faults;
}

[[noreturn]] void refuse(const std::string& file, std::string what) {
  throw SceneFileError(file, {{1, 1, "/", std::move(what)}});
}

void refuse_if_large(std::size_t size, const std::string& file) {
  if (size > largest_scene_file)
    refuse(file,
           fmt::format("the file is too large; a scene may have {} MiB", largest_scene_file >> 20));
}

// Not more than it takes to see that there is too much: the stream may have no end.
std::string contents_of(std::istream& stream) {
  std::string text;
  std::string block(std::size_t{1} << 20, '\0');
  while (stream && text.size() <= largest_scene_file) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

std::string contents_of(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (status.type() == std::filesystem::file_type::not_found)
    refuse(file, "there is no such file; check the path");
  if (std::filesystem::is_directory(status))
    refuse(file, "this is a directory; name a scene file in it");
  // Those of a shell's <(command) have one who writes into them.
  if (status.type() == std::filesystem::file_type::fifo && !file.starts_with("/dev/fd/"))
    refuse(file, "this is a pipe; give its text on standard input, and - as the file");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::string text = contents_of(stream);
  if (!stream.is_open() || stream.bad())
    refuse(file, fmt::format("the file cannot be read ({}); check its permissions",
                             std::generic_category().message(errno)));
  return text;
}

}  // namespace

SceneFileError::SceneFileError(std::string file_name, std::vector<Fault> found)
    : std::runtime_error(lines_of(file_name, found)),
      file(std::move(file_name)),
      faults(std::move(found)) {}

SceneDocument parse_scene(std::string text, std::string_view name, const SceneFiles& files) {
  const std::string file(name);
  refuse_if_large(text.size(), file);
  JsonReading reading = read_json(text);
  std::vector<JsonFault> faults = std::move(reading.faults);
  SceneMeshes meshes;
  SceneTextures textures;
  if (reading.document)
    faults = faults_in(*reading.document, std::move(faults), files, meshes, textures);
  if (!faults.empty()) throw SceneFileError(file, located(std::move(faults), text));

  SceneDocument result;
  result.scene = build_description(*reading.document, text, meshes, textures);
  Lint found = lint(result.scene);
  if (!found.faults.empty()) throw SceneFileError(file, std::move(found.faults));
  result.warnings = std::move(found.warnings);
  result.digest.text = sha256(text);
  try {
    if (files.digest)
      for (const auto& named : {meshes.files(), textures.files()})
        for (const std::string& one : named) result.digest.files[one] = files.digest(one);
  } catch (const std::runtime_error& problem) {
    refuse(file,
           fmt::format("a file that it names changed while it was read ({})", problem.what()));
  }
  result.text = std::move(text);
  return result;
}

SceneDocument read_scene(std::istream& stream, std::string_view name) {
  std::string text = contents_of(stream);
  if (stream.bad()) refuse(std::string(name), "the stream cannot be read");
  return parse_scene(std::move(text), name);
}

SceneDocument read_scene_file(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  return parse_scene(contents_of(path), path.string(), files_in(folder.empty() ? "." : folder));
}

}  // namespace wander
