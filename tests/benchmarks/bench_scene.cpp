#include "tests/benchmarks/bench_scene.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "scenes/format/build_scene.h"
#include "scenes/format/scene_file.h"
#include "scenes/gallery_scenes.h"

namespace wander {

namespace {

description::Scene describe(std::string_view name) {
  const std::span scenes(gallery_scenes, gallery_scene_count);
  const auto found =
      std::ranges::find_if(scenes, [&](const GalleryScene& s) { return s.name == name; });
  if (found == scenes.end())
    throw std::runtime_error("the gallery has no scene " + std::string(name));
  return parse_scene(found->text, name).scene;
}

// What build_scene makes of a shape.
int pieces(const description::ShapeKind& kind) {
  const auto* line = std::get_if<description::Polyline>(&kind);
  return line ? static_cast<int>(line->points.size()) - (line->closed ? 0 : 1) : 1;
}

}  // namespace

// A scene as it is built is const, and cannot be watched: the same parts make another one.
template <World W>
std::unique_ptr<Scene<W>> bench_scene(std::string_view name) {
  const description::Scene description = describe(name);
  const auto built = build_scene<W>(description);
  int shapes = 0;
  for (const auto& shape : description.shapes) shapes += pieces(shape.kind);

  SceneParts<W> parts;
  parts.camera = built->camera();
  parts.resolution.assign(built->resolution().begin(), built->resolution().end());
  parts.max_vertices = built->max_vertices();
  for (ShapeId id = 0; id < shapes; ++id) {
    const auto& surface = built->surface(id);
    parts.parts.push_back({built->shape(id), parts.materials.size(), surface.radiance,
                           surface.is_sensor, surface.tint});
    parts.materials.push_back(*surface.material);
  }
  return std::make_unique<Scene<W>>(std::move(parts));
}

template <World W>
double cast_closest(const Scene<W>& scene, const RayLog<W>& log) {
  double sum = 0;
  for (const auto& ray : log.closest) sum += scene.closest(ray).distance;
  return sum;
}

template <World W>
double cast_any(const Scene<W>& scene, const RayLog<W>& log) {
  double sum = 0;
  for (const auto& ray : log.any) sum += scene.occluded(ray) ? 1 : 0;
  return sum;
}

#define WANDER_BENCH_SCENES(World)                                         \
  template std::unique_ptr<Scene<World>> bench_scene(std::string_view);    \
  template double cast_closest(const Scene<World>&, const RayLog<World>&); \
  template double cast_any(const Scene<World>&, const RayLog<World>&);
WANDER_BENCH_SCENES(Flatland)
WANDER_BENCH_SCENES(SpacelandColour)
#undef WANDER_BENCH_SCENES

}  // namespace wander
