#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "records/film_netcdf.h"
#include "records/netcdf.h"
#include "records/scene_record.h"
#include "records/seal.h"
#include "records/trajectory_layout.h"
#include "records/trajectory_netcdf.h"
#include "scenes/format/json_text.h"

namespace wander {

namespace {

using Group = netcdf::Reader::Group;

constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";  // netCDF-4 is HDF5
constexpr std::size_t most_draws = 1'000'000'000, most_axes_and_vertices = 1'000'000;

// Every index names something.
void require_below(const std::vector<std::int32_t>& indices, std::int32_t low, std::size_t high,
                   const char* name) {
  for (const std::int32_t index : indices)
    if (index < low || index >= static_cast<std::int64_t>(high))
      throw netcdf::Error(fmt::format("{}: it holds {}, which has no meaning", name, index));
}

int bounded(std::size_t count, std::size_t most, const char* name) {
  if (count > most) throw netcdf::Error(fmt::format("{}: too many", name));
  return static_cast<int>(count);
}

RecordedPaths read_paths(const Group& positions, const Group& scalars, const Trajectory& t,
                         std::size_t size) {
  RecordedPaths paths;
  const std::size_t vertices = static_cast<std::size_t>(t.max_vertices);
  const std::vector<std::string> names = film_names(t.dimension);
  positions.read("x", size * vertices * static_cast<std::size_t>(t.dimension), paths.position);
  positions.read("path_class", size, paths.path_class);
  scalars.read("n_vertices", size, paths.vertices);
  require_below(paths.path_class, -1, t.classes.size(), "path_class");
  require_below(paths.vertices, 0, vertices + 1, "n_vertices");
  paths.film.resize(size * names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<double> column;
    scalars.read(names[k], size, column);
    for (std::size_t i = 0; i < size; ++i) paths.film[i * names.size() + k] = column[i];
  }
  return paths;
}

RecordedAttempts read_attempts(const Group& group, const Trajectory& t) {
  RecordedAttempts attempts;
  const auto axes = static_cast<std::size_t>(t.dimension);
  attempts.max_points = bounded(group.dimension("point"), most_axes_and_vertices, "point");
  group.read("x_reached", t.size() * static_cast<std::size_t>(attempts.max_points) * axes,
             attempts.position);
  group.read("x_failure", t.size() * axes, attempts.failure);
  return attempts;
}

void read_sample_stats(const Group& group, Trajectory& t) {
  const std::size_t size = t.size();
  t.mutations = group.words("mutation");
  t.reasons = group.words("reason");
  group.read("lp", size, t.log_f);
  group.read("acceptance_rate", size, t.acceptance);
  group.read("accepted", size, t.accepted);
  group.read("mutation", size, t.mutation);
  group.read("reason", size, t.reason);
  group.read("log_f_current", size, t.log_f_current);
  group.read("log_f_proposed", size, t.log_f_proposed);
  group.read("log_forward", size, t.log_forward);
  group.read("log_reverse", size, t.log_reverse);
  require_below(t.mutation, 0, t.mutations.size(), "mutation");
  require_below(t.reason, 0, t.reasons.size(), "reason");
}

Trajectory trajectory_from(const Group& root) {
  Trajectory t;
  const Group posterior = root.group("posterior"), paths = root.group("paths");
  const Group proposal = root.group("proposal");
  t.dimension = root.count("dimension") == 3 ? 3 : 2;
  t.first_step = root.count("first_step");
  t.every = root.count("every");
  t.chains = bounded(posterior.dimension("chain"), most_draws, "chain");
  t.draws = bounded(posterior.dimension("draw"), most_draws, "draw");
  if (t.size() > most_draws) throw netcdf::Error("draw: too many");
  t.max_vertices = bounded(paths.dimension("vertex"), most_axes_and_vertices, "vertex");
  read_sample_stats(root.group("sample_stats"), t);
  t.classes = paths.words("path_class");
  t.state = read_paths(paths, posterior, t, t.size());
  t.proposed = read_paths(proposal, proposal, t, t.size());
  if (proposal.has_variable("x_reached")) t.attempts = read_attempts(proposal, t);
  if (root.has_group("start")) {
    const Group start = root.group("start");
    t.start = read_paths(start, start, t, static_cast<std::size_t>(t.chains));
  }
  return t;
}

Origin origin_from(const Group& root) {
  Origin origin;
  for (const OriginField& field : origin_fields)
    if (root.has(field.name)) origin.*field.member = root.text(field.name);
  return origin;
}

TrajectoryRecord record_from(const Group& root) {
  if (root.text("format") != trajectory_format)
    throw netcdf::Error(fmt::format("format: it is {}", excerpt(root.text("format"))));
  TrajectoryRecord record;
  record.trajectory = trajectory_from(root);
  record.complete = root.count("complete") == 1;
  record.method = root.text("method");
  record.seed = root.count("seed");
  record.normalization = {root.number("normalization"),
                          root.number("normalization_standard_error")};
  record.provenance = {root.text("scene_name"),
                       root.text("scene"),
                       {root.text("scene_sha256"), {}},
                       record.trajectory.dimension,
                       root.text("command_line"),
                       root.text("version"),
                       origin_from(root)};
  if (root.has("scene_files"))
    read_scene_files(root.text("scene_files"), record.provenance.scene_digest);
  return record;
}

SceneFaces faces_from(const Group& root) {
  const Group group = root.group("constant_data");
  SceneFaces faces;
  const std::size_t size = group.dimension("face");
  group.read("shape", size, faces.shape);
  group.read("kind", size, faces.kind);
  group.read("material", size, faces.material);
  group.read("corners", 9 * size, faces.corners);
  group.read("radius", size, faces.radius);
  group.read("flip", size, faces.flipped);
  group.read("radiance", size, faces.radiance);
  group.read("is_sensor", size, faces.is_sensor);
  require_below(faces.kind, 0, faces.kinds.size(), "kind");
  return faces;
}

std::string bytes_of(const std::filesystem::path& path, std::size_t most) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(most, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

// What `part` reads from the root of the file.
template <class Part>
auto read_whole(const std::filesystem::path& path, Part&& part) {
  const std::string bytes = bytes_of(path, std::filesystem::file_size(path));
  const std::optional<std::string_view> whole = unsealed(bytes);
  if (!whole)
    throw RunFileError(
        fmt::format("{}: not a trajectory or film of this program, or cut short or changed since "
                    "it was written",
                    path.string()));
  try {
    const netcdf::Reader reader(*whole);
    return part(reader.root());
  } catch (const netcdf::Error& problem) {
    throw RunFileError(fmt::format("{}: {}; not a trajectory of format {}", path.string(),
                                   problem.what(), trajectory_format));
  }
}

}  // namespace

std::optional<TrajectoryRecord> find_trajectory(const std::filesystem::path& path) {
  std::error_code unreachable;
  if (!std::filesystem::is_regular_file(path, unreachable)) return std::nullopt;
  const std::string beginning = bytes_of(path, signature.size());
  if (beginning != signature || is_film_netcdf(path)) return std::nullopt;
  return read_whole(path, record_from);
}

TrajectoryRecord read_trajectory(const std::filesystem::path& path) {
  if (auto record = find_trajectory(path)) return *std::move(record);
  throw RunFileError(fmt::format("{}: not a trajectory file (netCDF-4)", path.string()));
}

SceneFaces read_faces(const std::filesystem::path& path) { return read_whole(path, faces_from); }

}  // namespace wander
