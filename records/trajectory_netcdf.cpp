#include "records/trajectory_netcdf.h"

#include <numeric>

#include "records/netcdf.h"
#include "records/scene_curves.h"
#include "records/scene_faces.h"
#include "records/scene_record.h"
#include "records/seal.h"
#include "records/trajectory_layout.h"

namespace wander {

namespace {

using netcdf::Writer;

const Writer::Dimensions per_draw{"chain", "draw"}, per_chain{"chain"};

std::string axes_name(int dimension) { return dimension == 2 ? "xy" : "xyz"; }

// A group with the coordinate of its chains and what ArviZ wants to know of it.
Writer chains_group(const Writer& file, const std::string& name, const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  const Writer group = file.group(name);
  group.attribute("inference_library", "wanderlight");
  group.attribute("inference_library_version", record.provenance.version);
  group.attribute("creation_library", "wanderlight");
  group.attribute("creation_library_language", "C++");
  group.dimension("chain", static_cast<std::size_t>(t.chains));
  std::vector<std::int64_t> chains(static_cast<std::size_t>(t.chains));
  std::iota(chains.begin(), chains.end(), 0);
  group.variable("chain", {"chain"}, chains, "number of the chain");
  return group;
}

// With that of its draws too.
Writer draws_group(const Writer& file, const std::string& name, const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  const Writer group = chains_group(file, name, record);
  group.dimension("draw", static_cast<std::size_t>(t.draws));
  std::vector<std::int64_t> steps(static_cast<std::size_t>(t.draws));
  for (std::size_t d = 0; d < steps.size(); ++d)
    steps[d] = static_cast<std::int64_t>(t.first_step + d * t.every);
  group.variable("draw", {"draw"}, steps, "number of the step");
  return group;
}

Writer::Dimensions with(Writer::Dimensions dimensions, const Writer::Dimensions& more) {
  dimensions.insert(dimensions.end(), more.begin(), more.end());
  return dimensions;
}

void write_film(const Writer& group, const RecordedPaths& paths, const Trajectory& t,
                const Writer::Dimensions& of, std::string_view meaning) {
  const std::vector<std::string> names = film_names(t.dimension);
  for (std::size_t k = 0; k < names.size(); ++k)
    group.variable(names[k], of, column_of(paths.film, k, names.size()), meaning);
}

void write_positions(const Writer& group, const RecordedPaths& paths, const Trajectory& t,
                     const Writer::Dimensions& of) {
  const std::string axes = axes_name(t.dimension);
  group.dimension("vertex", static_cast<std::size_t>(t.max_vertices));
  group.dimension(axes, static_cast<std::size_t>(t.dimension));
  group.variable("x", with(of, {"vertex", axes}), paths.position,
                 "vertices of the path, light first; NaN beyond its end");
  group.variable("path_class", of, paths.path_class, t.classes,
                 "class of the path, light first: L light, D scattering, S specular, E sensor; -1: "
                 "no path");
}

void write_posterior(const Writer& file, const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  const Writer group = draws_group(file, "posterior", record);
  write_film(group, t.state, t, per_draw, "where the path meets the film, in [0,1)");
  group.variable("n_vertices", per_draw, t.state.vertices,
                 "vertices of the path, both ends counted");
  group.variable("log_f", per_draw, t.log_f, "log of the contribution of the path");
}

// A proposal that failed.
void write_attempts(const Writer& group, const Trajectory& t) {
  if (t.attempts.max_points == 0) return;
  const std::string axes = axes_name(t.dimension);
  group.dimension("point", static_cast<std::size_t>(t.attempts.max_points));
  group.variable("x_reached", with(per_draw, {"point", axes}), t.attempts.position,
                 "what a proposal that failed came to: its walks, rays and connection, as lines "
                 "with NaN between them");
  group.variable("x_failure", with(per_draw, {axes}), t.attempts.failure,
                 "where a proposal failed; NaN: at no place");
}

void write_start(const Writer& file, const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  if (t.start.vertices.empty()) return;
  const Writer group = chains_group(file, "start", record);
  write_positions(group, t.start, t, per_chain);
  group.variable("n_vertices", per_chain, t.start.vertices, "vertices before the first draw");
  write_film(group, t.start, t, per_chain, "where the path before the first draw meets the film");
}

void write_paths(const Writer& file, const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  write_positions(draws_group(file, "paths", record), t.state, t, per_draw);
  const Writer group = draws_group(file, "proposal", record);
  write_positions(group, t.proposed, t, per_draw);
  group.variable("n_vertices", per_draw, t.proposed.vertices,
                 "vertices of the proposed path; 0: no path was proposed");
  write_film(group, t.proposed, t, per_draw, "where the proposed path meets the film, in [0,1)");
  write_attempts(group, t);
}

void write_sample_stats(const Writer& file, const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  const Writer group = draws_group(file, "sample_stats", record);
  std::vector<std::uint8_t> diverging;
  for (const std::int32_t reason : t.reason)
    diverging.push_back(t.reasons[static_cast<std::size_t>(reason)] == "solver_failed" ? 1 : 0);
  group.variable("lp", per_draw, t.log_f, "log of the target density, up to a constant: log_f");
  group.variable("acceptance_rate", per_draw, t.acceptance, "acceptance probability a of the step");
  group.flags("accepted", per_draw, t.accepted, "the proposal became the state");
  group.flags("diverging", per_draw, diverging, "a solver of the mutation failed");
  group.variable("mutation", per_draw, t.mutation, t.mutations, "the mutation that proposed");
  group.variable("reason", per_draw, t.reason, t.reasons, "why the proposal was refused");
  group.variable("log_f_current", per_draw, t.log_f_current, "log f of the path before the step");
  group.variable("log_f_proposed", per_draw, t.log_f_proposed, "log f of the proposed path");
  group.variable("log_forward", per_draw, t.log_forward,
                 "log of the transition density from the path to the proposed one");
  group.variable("log_reverse", per_draw, t.log_reverse,
                 "log of the transition density from the proposed path back");
}

void write_camera(const Writer& group, const description::Camera& camera, int axes) {
  const auto point = [&](const description::Coordinates& c) {
    return std::span(c).first(static_cast<std::size_t>(axes));
  };
  const Writer::Dimensions of_point{axes == 2 ? "xy" : "xyz"};
  group.variable("camera_position", of_point, point(camera.position), "where the camera stands");
  group.variable("camera_target", of_point, point(camera.target), "what it looks at");
  if (axes == 3)
    group.variable("camera_up", of_point, point(camera.up), "what is upwards in its picture");
  group.variable("camera_fov_deg", {}, std::span(&camera.fov_degrees, 1), "whole angle of view");
  group.variable("camera_aperture_radius", {}, std::span(&camera.aperture_radius, 1),
                 "radius of the lens; 0: a pinhole");
}

void write_curves(const Writer& group, const SceneCurves& curves) {
  group.dimension("curve", curves.size());
  group.dimension("xy", 2);
  const Writer::Dimensions row{"curve"}, point{"curve", "xy"};
  group.variable("shape", row, curves.shape, "index among the shapes of the scene file");
  group.variable("kind", row, curves.kind, curves.kinds, "what curve it is");
  group.variable("material", row, curves.material, material_types, "type of the material");
  group.variable("from", point, curves.from, "first end of a segment; the normal is on its left");
  group.variable("to", point, curves.to, "second end of a segment");
  group.variable("center", point, curves.center, "centre of an arc");
  group.variable("radius", row, curves.radius, "radius of an arc");
  group.variable("from_deg", row, curves.from_degrees, "first end of an arc");
  group.variable("to_deg", row, curves.to_degrees, "second end of an arc, counter-clockwise");
  group.flags("flip", row, curves.flipped, "the normal of the arc points to its centre");
  group.variable("radiance", row, curves.radiance, "of a light, on the side of the normal; else 0");
  group.flags("is_sensor", row, curves.is_sensor, "it listens on the side of the normal");
}

void write_faces(const Writer& group, const SceneFaces& faces) {
  group.dimension("face", faces.size());
  group.dimension("corner", 3);
  group.dimension("xyz", 3);
  const Writer::Dimensions row{"face"};
  group.variable("shape", row, faces.shape, "index among the shapes of the scene file");
  group.variable("kind", row, faces.kind, faces.kinds, "what face it is");
  group.variable("material", row, faces.material, material_types, "type of the material");
  group.variable("corners", {"face", "corner", "xyz"}, faces.corners,
                 "corners of a triangle; origin of a parallelogram and the ends of its edges "
                 "there; centre of a sphere");
  group.variable("radius", row, faces.radius, "radius of a sphere");
  group.flags("flip", row, faces.flipped, "the normal of the sphere points to its centre");
  group.variable("radiance", row, faces.radiance,
                 "luminance of a light, on the side of the normal; else 0");
  group.flags("is_sensor", row, faces.is_sensor, "it listens on the side of the normal");
}

void write_constant_data(const Writer& file, const description::Scene& scene) {
  const Writer group = file.group("constant_data");
  if (scene.dimension == 2)
    write_curves(group, scene_curves(scene));
  else
    write_faces(group, scene_faces(scene));
  if (scene.camera) write_camera(group, *scene.camera, scene.dimension);
}

void write_root(const Writer& file, const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  file.attribute("format", trajectory_format);
  file.attribute("complete", std::int64_t{record.complete ? 1 : 0});
  file.attribute("scene", record.provenance.scene_text);
  file.attribute("scene_name", record.provenance.scene_name);
  file.attribute("scene_sha256", record.provenance.scene_digest.text);
  if (!record.provenance.scene_digest.files.empty())
    file.attribute("scene_files", scene_files_text(record.provenance.scene_digest));
  file.attribute("command_line", record.provenance.command_line);
  file.attribute("version", record.provenance.version);
  for (const OriginField& field : origin_fields)
    file.attribute(field.name, record.provenance.origin.*field.member);
  file.attribute("method", record.method);
  file.attribute("dimension", std::int64_t{t.dimension});
  file.attribute("first_step", t.first_step);
  file.attribute("every", t.every);
  file.attribute("seed", record.seed);
  file.attribute("normalization", record.normalization.value);
  file.attribute("normalization_standard_error", record.normalization.standard_error);
}

// About as many as there will be.
std::size_t bytes_of(const Trajectory& t) {
  constexpr std::size_t columns = 24;
  const std::size_t positions =
      t.state.position.size() + t.proposed.position.size() + t.attempts.position.size();
  return sizeof(double) * (positions + columns * t.size());
}

}  // namespace

std::string to_netcdf(const TrajectoryRecord& record, const description::Scene& scene) {
  Writer file = Writer::create(bytes_of(record.trajectory));
  write_root(file, record);
  write_posterior(file, record);
  write_sample_stats(file, record);
  write_paths(file, record);
  write_start(file, record);
  write_constant_data(file, scene);
  return sealed(file.take());
}

}  // namespace wander
