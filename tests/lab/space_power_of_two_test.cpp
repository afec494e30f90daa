// A scene of space multiplied by a power of two, or with brighter light, is the same scene to every
// method: the same decisions, and every bit of the film's mantissas.  There is no absolute epsilon.
#include <gtest/gtest.h>

#include "lab/engine.h"
#include "tests/support/coloured_box.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

void scale(description::Coordinates& c, double factor) {
  for (double& x : c) x *= factor;
}
struct Scaling {
  double factor;

  void operator()(description::Triangle& shape) const {
    for (auto& point : shape.points) scale(point, factor);
  }
  void operator()(description::Parallelogram& shape) const {
    scale(shape.origin, factor);
    for (auto& edge : shape.edges) scale(edge, factor);
  }
  void operator()(description::Sphere& shape) const {
    scale(shape.center, factor);
    shape.radius *= factor;
  }
  void operator()(description::Mesh& shape) const {
    Triangles triangles = *shape.triangles;
    for (auto& point : triangles.points) scale(point, factor);
    shape.triangles = std::make_shared<const Triangles>(std::move(triangles));
  }
  template <class PlaneShape>
  void operator()(PlaneShape&) const {
    FAIL() << "a shape of the plane";
  }
};
description::Scene scaled_in_space(description::Scene scene, double factor) {
  for (description::Shape& shape : scene.shapes) std::visit(Scaling{factor}, shape.kind);
  if (scene.camera) {
    scale(scene.camera->position, factor);
    scale(scene.camera->target, factor);
    scene.camera->aperture_radius *= factor;
    if (scene.camera->focus_distance) *scene.camera->focus_distance *= factor;
  }
  return scene;
}

description::Scene box_with_lens() {
  description::Scene scene = box_with_mesh();
  scene.camera->aperture_radius = 0.03;
  scene.camera->focus_distance = 0.7;
  return scene;
}
// The same, in one channel, as its floor sees it.
description::Scene box_with_sensor() {
  description::Scene scene = channel_of(box_with_lens(), 1);
  scene.camera.reset();
  scene.shapes[0].sensor = description::Sensor{{4, 3}};
  return scene;
}

Rendering rendered(const description::Scene& scene, const char* method) {
  Session session;
  session.budget = SampleBudget{3000};
  session.threads = 2;
  Dials dials;
  dials.chains.fewest_seeds = 2048;
  return render(Job(scene, find_method(method), dials), session);
}

void expect_same(const Rendering& a, const Rendering& b, double brightness) {
  ASSERT_EQ(a.film.value.size(), b.film.value.size());
  for (std::size_t i = 0; i < a.film.value.size(); ++i) {
    EXPECT_EQ(a.film.value[i] * brightness, b.film.value[i]) << "bin " << i;
    EXPECT_EQ(a.film.standard_error[i] * brightness, b.film.standard_error[i]) << "bin " << i;
  }
  ASSERT_EQ(a.mutations.size(), b.mutations.size());
  for (std::size_t k = 0; k < a.mutations.size(); ++k) {
    EXPECT_EQ(a.mutations[k].proposed, b.mutations[k].proposed) << k;
    EXPECT_EQ(a.mutations[k].accepted, b.mutations[k].accepted) << k;
  }
}

class PowerOfTwoInSpace : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, PowerOfTwoInSpace,
                         ::testing::Values("pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(PowerOfTwoInSpace, ChangesNoBitOfAFilm) {
  const auto rendered_by = [](const description::Scene& scene) {
    return rendered(scene, GetParam());
  };
  const description::Scene seen_through_lens = box_with_lens();
  const Rendering image = rendered_by(seen_through_lens);
  for (const double factor : {0x1p-100, 8.0})
    expect_same(image, rendered_by(scaled_in_space(seen_through_lens, factor)), 1);
  expect_same(image, rendered_by(brightened(seen_through_lens, 0x1p100)), 0x1p100);
  // The comparison notices a scene that is not the same.
  EXPECT_NE(image.film.value, rendered_by(scaled_in_space(seen_through_lens, 1.1)).film.value);

  const description::Scene seen_by_floor = box_with_sensor();
  expect_same(rendered_by(seen_by_floor),
              rendered_by(brightened(scaled_in_space(seen_by_floor, 0x1p100), 0x1p-100)), 0x1p-100);
}

}  // namespace
}  // namespace wander::test
