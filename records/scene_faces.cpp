#include "records/scene_faces.h"

#include "core/film_estimate.h"
#include "records/scene_curves.h"

namespace wander {

namespace {

using description::Coordinates;

constexpr Coordinates nowhere{not_known, not_known, not_known};

// Adds the faces of one shape.
struct FaceAdder {
  SceneFaces& faces;

  void operator()(const description::Triangle& t) { add(0, t.points[0], t.points[1], t.points[2]); }
  void operator()(const description::Parallelogram& p) {
    add(1, p.origin, sum(p.origin, p.edges[0]), sum(p.origin, p.edges[1]));
  }
  void operator()(const description::Sphere& s) {
    add(2, s.center, nowhere, nowhere);
    faces.radius.back() = s.radius;
    faces.flipped.back() = s.flip ? 1 : 0;
  }

 private:
  static Coordinates sum(const Coordinates& a, const Coordinates& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }
  void add(std::int32_t kind, const Coordinates& a, const Coordinates& b, const Coordinates& c) {
    faces.kind.push_back(kind);
    for (const Coordinates* corner : {&a, &b, &c})
      faces.corners.insert(faces.corners.end(), corner->begin(), corner->end());
    faces.radius.push_back(not_known);
    faces.flipped.push_back(0);
  }
};

}  // namespace

SceneFaces scene_faces(const description::Scene& scene) {
  SceneFaces faces;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const description::Shape& shape = scene.shapes[i];
    description::visit_kind<3>([&](const auto& kind) { kind.for_each_face(FaceAdder{faces}); },
                               shape.kind);
    const std::size_t count = faces.kind.size();
    faces.shape.resize(count, static_cast<std::int32_t>(i));
    faces.material.resize(count, material_number(scene, shape));
    faces.radiance.resize(count, shape.light ? luminance(shape.light->radiance) : 0);
    faces.is_sensor.resize(count, shape.sensor ? 1 : 0);
  }
  return faces;
}

}  // namespace wander
