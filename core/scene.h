// A scene: surfaces with materials, lights, and one sensor.
//
// Lights and sensors are one idea seen from two ends: a one-sided Lambertian emitter on a surface,
// of radiance or of importance.  A light is chosen in proportion to its power and then uniformly,
// so the density of a point on it is L / Σ L |A|.  A sensor's importance is We = 1/|sensor|: the
// mean of the film is the mean irradiance, b = ∫ f.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/camera.h"
#include "core/geometry/accelerator.h"
#include "core/light_choice.h"
#include "core/material.h"

namespace wander {

class Texture;

// What a material reflects is what this says (texturing.h).  Surfaces of the plane have none, and take
// no memory to say so.
struct NoTexture {
  constexpr NoTexture(const Texture* = nullptr) {}
};
template <World W>
using SurfaceTexture = std::conditional_t<W::dimension == 3, const Texture*, NoTexture>;

template <World W>
struct Surface {
  using Real = typename W::Real;
  const Material<W>* material = nullptr;
  bool is_specular = false;  // of the material: a class of vertices, never of directions
  bool scatters = false;     // false: black
  bool is_opaque = false;    // light stays on its side
  bool has_lobes = false;    // of its scattering, one of which a sample chooses
  bool is_flat = false;      // no two points of one primitive see each other
  bool is_sensor = false;
  bool is_smooth = false;  // scatters about normals that are not its own (shading.h)
  Real albedo = 0;         // of the material, with which Russian roulette lets a walk go on
  Real radiance = 0;       // 0: no light; of colours luminance, as all values
  Real light_density = 0;  // of points, when a light is sampled; per unit of area
  [[no_unique_address]] typename W::Tint tint{};  // of its radiance
  [[no_unique_address]] SurfaceTexture<W> texture = nullptr;

  bool is_light() const { return radiance > 0; }
};

template <World W>
struct SceneParts {
  struct Part {
    Shape<W> shape;
    std::size_t material;
    typename W::Real radiance = 0;
    bool is_sensor = false;
    [[no_unique_address]] typename W::Tint tint{};  // of its radiance
  };
  std::vector<Material<W>> materials;
  std::vector<std::shared_ptr<const Texture>> textures;  // of the materials; null: none
  std::vector<Part> parts;
  std::optional<Camera<W>> camera;
  std::vector<int> resolution;  // of the film, fastest axis last
  int max_vertices = 8;
};

template <World W>
class Scene {
 public:
  using Universe = W;
  using Real = typename W::Real;
  using Length = typename W::Length;

  explicit Scene(SceneParts<W> parts);
  Scene(const Scene&) = delete;  // surfaces point into it
  Scene& operator=(const Scene&) = delete;

  int max_vertices() const { return max_vertices_; }
  // Of the film, without its channels.
  std::span<const int> resolution() const { return resolution_; }
  int bins() const { return bins_; }
  // How its values are laid out (tint.h).
  std::vector<int> film_shape() const;
  int bin(typename W::Square film) const;

  const Surface<W>& surface(ShapeId id) const { return surfaces_[static_cast<std::size_t>(id)]; }
  const Shape<W>& shape(ShapeId id) const { return shapes_[static_cast<std::size_t>(id)]; }
  std::span<const ShapeId> lights() const { return lights_; }        // ascending
  const LightChoice& light_choice() const { return light_choice_; }  // by index in lights()

  // Of its materials, about the direction of a mirror's reflection or of smooth glass, as a share of all directions: α^(D-1).
  // 0 where one is specular, 1 where none scatters so.
  double narrowest_lobe() const;

  // Exactly one of the two: a sensor is a surface or a camera.
  ShapeId sensor() const { return sensor_; }
  const std::optional<Camera<W>>& camera() const { return camera_; }
  Length sensor_measure() const;  // of a sensor that is a surface
  Box<W> bounds() const;          // of all its shapes

  Hit<W> closest(const Ray<W>& ray) const {
    if (log_) log_->closest.push_back(ray);
    return accelerator_.closest(ray);
  }
  bool occluded(const Ray<W>& ray) const {
    if (log_) log_->any.push_back(ray);
    return accelerator_.any(ray);
  }
  SurfacePoint<W> surface_point(const Ray<W>& ray, const Hit<W>& hit) const {
    return visit_shape([&](const auto& s) { return s.surface(ray, hit); }, shape(hit.shape));
  }

  // Writes down every ray from now on, for benchmarks; null ends it.  One thread only.
  void watch(RayLog<W>* log) { log_ = log; }

 private:
  std::vector<Shape<W>> shapes_;
  std::vector<Surface<W>> surfaces_;
  std::vector<Material<W>> materials_;
  std::vector<std::shared_ptr<const Texture>> textures_;
  std::vector<ShapeId> lights_;
  LightChoice light_choice_;
  SceneAccelerator<W> accelerator_;
  ShapeId sensor_ = no_shape;
  std::optional<Camera<W>> camera_;
  std::vector<int> resolution_;
  int bins_ = 0, max_vertices_ = 8;
  RayLog<W>* log_ = nullptr;
};

}  // namespace wander
