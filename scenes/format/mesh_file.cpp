#include "scenes/format/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace wander {

namespace {

constexpr std::uintmax_t largest_mesh_file = std::uintmax_t{2} << 30;

std::string contents_of_mesh(const std::filesystem::path& path) {
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (status.type() == std::filesystem::file_type::not_found)
    throw MeshFileError("there is no such file; check the path");
  if (!std::filesystem::is_regular_file(status))
    throw MeshFileError("this is no file of data; name an OBJ or PLY file");
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  if (!problem && size > largest_mesh_file)
    throw MeshFileError(
        fmt::format("the file is too large; a mesh may have {} GiB", largest_mesh_file >> 30));
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::string text(problem ? 0 : size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (problem || static_cast<std::uintmax_t>(stream.gcount()) != size)
    throw MeshFileError(fmt::format("the file cannot be read ({}); check its permissions",
                                    std::generic_category().message(errno)));
  return text;
}

}  // namespace

Triangles read_mesh(const std::filesystem::path& path, MeshWants wanted) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".obj" && ending != ".ply")
    throw MeshFileError(
        fmt::format("the ending \"{}\" is not known; a mesh is .obj or .ply", ending));
  const std::string text = contents_of_mesh(path);
  Triangles triangles = ending == ".obj" ? parse_obj(text, wanted) : parse_ply(text, wanted);
  if (triangles.corners.empty())
    throw MeshFileError("the file has no face; a mesh has one or more");
  return triangles;
}

}  // namespace wander
