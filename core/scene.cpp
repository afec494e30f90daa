#include "core/scene.h"

#include <algorithm>

namespace wander {

namespace {

template <World W>
typename W::Length measure(const Shape<W>& shape) {
  return visit_shape([](const auto& s) { return s.measure(); }, shape);
}

template <World W>
bool is_flat(const Shape<W>& shape) {
  return visit_shape([](const auto& s) { return std::decay_t<decltype(s)>::flat; }, shape);
}

template <World W>
bool is_smooth(const Shape<W>& shape) {
  return visit_shape(
      [](const auto& s) {
        if constexpr (requires { s.is_smooth(); })
          return s.is_smooth();
        else
          return false;
      },
      shape);
}

template <World W>
bool specular_material(const Material<W>& material) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::specular; }, material);
}

template <World W>
bool is_opaque(const Material<W>& material) {
  return !std::holds_alternative<Dielectric<W>>(material) &&
         !std::holds_alternative<RoughDielectric<W>>(material);
}

template <World W>
bool has_lobes(const Material<W>& material) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::has_lobes; }, material);
}

}  // namespace

template <World W>
Scene<W>::Scene(SceneParts<W> parts)
    : materials_(std::move(parts.materials)),
      textures_(std::move(parts.textures)),
      camera_(std::move(parts.camera)),
      resolution_(std::move(parts.resolution)),
      bins_(1),
      max_vertices_(parts.max_vertices) {
  for (const int n : resolution_) bins_ *= n;
  textures_.resize(materials_.size());
  double power = 0;  // of all lights
  std::vector<double> powers;
  for (const auto& part : parts.parts) {
    const auto id = static_cast<ShapeId>(shapes_.size());
    const Material<W>& material = materials_[part.material];
    shapes_.push_back(part.shape);
    surfaces_.push_back({.material = &material,
                         .is_specular = specular_material<W>(material),
                         .scatters = !std::holds_alternative<Black<W>>(material),
                         .is_opaque = is_opaque<W>(material),
                         .has_lobes = has_lobes<W>(material),
                         .is_flat = is_flat<W>(part.shape),
                         .is_sensor = part.is_sensor,
                         .is_smooth = is_smooth<W>(part.shape),
                         .albedo = std::visit([](const auto& m) { return m.survival(); }, material),
                         .radiance = part.radiance,
                         .tint = part.tint,
                         .texture = textures_[part.material].get()});
    if (part.is_sensor) sensor_ = id;
    if (!(part.radiance > 0)) continue;
    lights_.push_back(id);
    powers.push_back(static_cast<double>(part.radiance) *
                     static_cast<double>(measure<W>(part.shape)));
    power += powers.back();
  }
  light_choice_ = LightChoice(powers);
  for (const ShapeId id : lights_) {
    Surface<W>& light = surfaces_[static_cast<std::size_t>(id)];
    light.light_density = static_cast<Real>(static_cast<double>(light.radiance) / power);
  }
  accelerator_ = SceneAccelerator<W>(shapes_);
}

template <World W>
Box<W> Scene<W>::bounds() const {
  const auto of = [](const Shape<W>& shape) {
    return visit_shape([](const auto& s) { return s.bounds(); }, shape);
  };
  Box<W> all = of(shapes_.front());
  for (const Shape<W>& shape : shapes_) {
    const Box<W> box = of(shape);
    all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  }
  return all;
}

template <World W>
std::vector<int> Scene<W>::film_shape() const {
  std::vector<int> shape = resolution_;
  if (W::channels > 1) shape.push_back(W::channels);
  return shape;
}

template <World W>
int Scene<W>::bin(typename W::Square film) const {
  // Film coordinates name the fastest axis first, `resolution` last.
  int index = 0;
  for (std::size_t k = film.size(); k-- > 0;) {
    const int n = resolution_[film.size() - 1 - k];
    const int cell = static_cast<int>(film[k] * static_cast<Real>(n));
    index = index * n + std::clamp(cell, 0, n - 1);
  }
  return index;
}

template <World W>
double Scene<W>::narrowest_lobe() const {
  double narrowest = 1;
  for (const Surface<W>& surface : surfaces_) {
    const double lobe = std::visit(
        [](const auto& m) {
          if constexpr (requires { m.roughness; })
            return std::pow(static_cast<double>(m.roughness), W::dimension - 1);
          else
            return m.specular ? 0.0 : 1.0;
        },
        *surface.material);
    narrowest = std::min(narrowest, lobe);
  }
  return narrowest;
}

template <World W>
auto Scene<W>::sensor_measure() const -> Length {
  return measure<W>(shape(sensor_));
}

template class Scene<Flatland>;
template class Scene<FlatlandSingle>;
template class Scene<Spaceland>;
template class Scene<SpacelandColour>;

}  // namespace wander
