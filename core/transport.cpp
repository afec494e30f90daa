#include "core/transport.h"

#include <algorithm>
#include <cmath>

#include "core/film_position.h"
#include "core/shading.h"
#include "core/texturing.h"

namespace wander {

namespace {

// G without visibility: |cos cos'| / r^(D-1) for the edge along `direction`.
template <World W>
double geometry(const Vertex<W>& a, const Vertex<W>& b, typename W::Direction direction,
                typename W::Length distance) {
  return static_cast<double>(
      std::abs(glm::dot(direction, a.place.normal) * glm::dot(direction, b.place.normal)) /
      W::Dimension::spread(distance));
}

template <World W>
void place(Vertex<W>& v, const SurfacePoint<W>& p, ShapeId shape, Event event) {
  v.place.position = p.position;
  v.place.normal = p.normal;
  v.place.shape = shape;
  v.place.primitive = p.primitive;
  v.event = event;
}

// Coordinates of the unit cube that are made of angles.
template <World W>
typename W::Square square(const std::array<typename W::Length, W::dimension - 1>& u) {
  typename W::Square numbers;
  std::ranges::transform(u, numbers.begin(), into_unit<typename W::Real, typename W::Length>);
  return numbers;
}

// The event at a surface as long as no direction away from it has been sampled.  On a specular
// surface it is some specular event, which forbids a connection there.
template <World W>
Event undecided(const Surface<W>& surface) {
  return surface.is_specular ? Event::reflection : Event::scattering;
}

}  // namespace

template <World W>
void Transport<W>::begin_light(Path<W>& x, int i, PointNumbers<W> u) const {
  const ShapeId shape = scene_->lights()[scene_->light_choice()(u.light)];
  const auto point =
      visit_shape([&](const auto& s) { return s.sample(u.position); }, scene_->shape(shape));
  place<W>(x[i], point, shape, Event::emission);
}

template <World W>
void Transport<W>::begin_sensor(Path<W>& x, int i, PointNumbers<W> u) const {
  if (const auto& camera = scene_->camera()) {
    place<W>(x[i], {camera->sample_lens(u.position), camera->axis}, no_shape, Event::detection);
    return;
  }
  const ShapeId shape = scene_->sensor();
  const auto point =
      visit_shape([&](const auto& s) { return s.sample(u.position); }, scene_->shape(shape));
  place<W>(x[i], point, shape, Event::detection);
}

template <World W>
auto Transport<W>::sample_direction(Path<W>& x, int i, Toward toward, ScatterNumbers<W> u) const
    -> std::optional<Direction> {
  Vertex<W>& v = x[i];
  if (v.event == Event::detection && v.place.shape == no_shape)
    return scene_->camera()->sample_direction(v.place.position, u.direction);
  if (v.event == Event::emission || v.event == Event::detection) {
    const auto frame = frame_at(*scene_, v.place, v.place.normal);
    return frame.to_world(Direction(W::Dimension::cosine_sample(u.direction)));
  }

  const ShadingFrame<W> frame(*scene_, v.place);
  const Direction known = known_direction(x, i, toward);
  if (!frame.agrees(known)) return {};
  const Local known_local = frame.to_local(known);
  const auto sample =
      std::visit([&](const auto& m) { return m.sample(known_local, u); }, material(v));
  if (!sample) return {};
  v.event = sample->event;
  const Direction sampled = frame.to_world(sample->direction);
  if (!frame.agrees(sampled)) return {};
  return sampled;
}

template <World W>
bool Transport<W>::extend(Path<W>& x, int i, Toward toward, ScatterNumbers<W> u) const {
  const auto direction = sample_direction(x, i, toward, u);
  return direction && shoot(x, i, toward, *direction);
}

template <World W>
bool Transport<W>::shoot(Path<W>& x, int i, Toward toward, Direction direction) const {
  const Ray<W> ray{
      .origin = x[i].place.position, .direction = direction, .from = x[i].place.element()};
  const int j = toward == Toward::sensor ? i + 1 : i - 1;
  Vertex<W>& lower = x[std::min(i, j)];
  // Also of a ray that meets nothing, for those who watch (mlt/watch/attempt.h).
  lower.place.to_sensor = toward == Toward::sensor ? direction : -direction;
  const Hit<W> hit = scene_->closest(ray);
  if (!hit || !(hit.distance > 0)) return false;

  place<W>(x[j], scene_->surface_point(ray, hit), hit.shape, undecided(scene_->surface(hit.shape)));
  lower.geometry = geometry(x[i], x[j], direction, hit.distance);
  return lower.geometry > 0;
}

template <World W>
void Transport<W>::move_end(Path<W>& x, int i, typename W::Square u) const {
  Vertex<W>& v = x[i];
  if (is_camera(v)) {
    v.place.position = scene_->camera()->sample_lens(u);
    return;
  }
  const auto point =
      visit_shape([&](const auto& s) { return s.sample(u); }, scene_->shape(v.place.shape));
  place<W>(v, point, v.place.shape, v.event);
}

template <World W>
bool Transport<W>::follow(Path<W>& x, int i, Toward toward, Event event) const {
  const ShadingFrame<W> frame(*scene_, x[i].place);
  const Direction arriving = known_direction(x, i, toward);
  if (!frame.agrees(arriving)) return false;
  const Local known = frame.to_local(arriving);
  const auto followed = std::visit(
      [&]<class M>(const M& m) -> std::optional<Local> {
        if constexpr (M::specular)
          return m.follow(known, event);
        else
          return {};
      },
      material(x[i]));
  if (!followed) return false;
  const Direction direction = frame.to_world(*followed);
  if (!frame.agrees(direction)) return false;
  x[i].event = event;
  return shoot(x, i, toward, direction);
}

template <World W>
double Transport<W>::end_density(const Path<W>& x, int i) const {
  const Vertex<W>& v = x[i];
  if (is_camera(v)) return static_cast<double>(scene_->camera()->lens_density());
  return static_cast<double>(
      1 / visit_shape([](const auto& s) { return s.measure(); }, scene_->shape(v.place.shape)));
}

// Of film coordinates: p⊥ G.  Of angle: dω/dA = |cos'| / r^(D-1) = G / |cos|.
template <World W>
double Transport<W>::aim_density(const Path<W>& x, int i, Toward toward) const {
  const Vertex<W>& v = x[i];
  const Direction way = direction(x, i, toward);
  const double edge = x[toward == Toward::sensor ? i : i - 1].geometry;
  if (is_camera(v))
    return double(scene_->camera()->direction_density(v.place.position, way)) * edge;
  return edge / static_cast<double>(std::abs(glm::dot(way, v.place.normal)));
}

template <World W>
double Transport<W>::follow_density(const Path<W>& x, int i, Toward toward) const {
  const ShadingFrame<W> frame(*scene_, x[i].place);
  const Direction way = direction(x, i, toward);
  const Local followed = frame.to_local(way);
  const double edge =
      x[toward == Toward::sensor ? i : i - 1].geometry * static_cast<double>(frame.stretch(way));
  return std::visit(
      [&]<class M>(const M& m) -> double {
        if constexpr (M::specular)
          return static_cast<double>(m.follow_density(followed, x[i].event)) * edge;
        else
          return 0;
      },
      material(x[i]));
}

template <World W>
bool Transport<W>::passes(const Vertex<W>& v, Direction way, Direction known) const {
  if (is_camera(v)) return scene_->camera()->film_coordinate(v.place.position, way).has_value();
  const Length side = glm::dot(way, v.place.normal);
  if (v.event == Event::emission || v.event == Event::detection) return side > 0;
  const Surface<W>& surface = scene_->surface(v.place.shape);
  return !surface.is_opaque || surface.is_smooth || side * glm::dot(known, v.place.normal) > 0;
}

template <World W>
bool Transport<W>::may_connect(const Path<W>& x, int i, const Path<W>& z, int j) const {
  const Direction way = z[j].place.position - x[i].place.position;
  const Direction light = i > 0 ? -x[i - 1].place.to_sensor : Direction{};
  return passes(x[i], way, light) && passes(z[j], -way, z[j].place.to_sensor);
}

template <World W>
Connection Transport<W>::connect(Path<W>& x, int i) const {
  Vertex<W>& a = x[i];
  const Vertex<W>& b = x[i + 1];
  const bool same_element = a.place.element() == b.place.element() && a.place.shape != no_shape;
  if (same_element && scene_->surface(a.place.shape).is_flat) return Connection::facing_away;
  const Direction offset = b.place.position - a.place.position;
  const Length squared = glm::dot(offset, offset);
  if (!(squared > 0)) return Connection::facing_away;
  const Ray<W> ray{.origin = a.place.position,
                   .direction = offset,
                   .from = a.place.element(),
                   .to = b.place.element(),
                   .limit = 1};
  // Before the roots and quotients below: of most connections nothing else is asked.
  if (scene_->occluded(ray)) return Connection::occluded;
  const Length distance = std::sqrt(squared);
  a.place.to_sensor = offset / distance;
  a.geometry = geometry(a, b, a.place.to_sensor, distance);
  return a.geometry > 0 ? Connection::open : Connection::facing_away;
}

// Lambertian emission: radiance L on the normal's side, directions sampled ∝ cos: p⊥ = 1/c.
template <World W>
void Transport<W>::evaluate_emission(Path<W>& x) const {
  Vertex<W>& v = x[0];
  const Surface<W>& light = scene_->surface(v.place.shape);
  const bool faces = glm::dot(v.place.to_sensor, v.place.normal) > 0;
  constexpr Real c = W::Dimension::template half_space<Real>;
  v.value = faces ? light.radiance : 0;
  v.tint = light.tint;
  v.from_light = light.light_density;
  x[1].from_light = faces ? static_cast<Real>(v.geometry / c) : 0;
}

// Lambertian response We = 1/|sensor|, sampled like an emission; or a camera's.
template <World W>
void Transport<W>::evaluate_detection(Path<W>& x, int i) const {
  Vertex<W>& v = x[i];
  const Direction direction = -x[i - 1].place.to_sensor;
  const double edge = x[i - 1].geometry;
  v.tint = {};
  if (v.place.shape == no_shape) {
    const Camera<W>& camera = *scene_->camera();
    const Real density = camera.direction_density(v.place.position, direction);
    v.from_sensor = camera.lens_density();
    v.value = v.from_sensor * density;
    x[i - 1].from_sensor = static_cast<Real>(density * edge);
    if (importance_ && density > 0) v.value *= importance_at(*scene_, x, i, *importance_);
    return;
  }
  const bool faces = glm::dot(direction, v.place.normal) > 0;
  constexpr Real c = W::Dimension::template half_space<Real>;
  v.from_sensor = static_cast<Real>(1 / scene_->sensor_measure());
  v.value = faces ? v.from_sensor : 0;
  if (importance_) v.value *= importance_at(*scene_, x, i, *importance_);
  x[i - 1].from_sensor = faces ? static_cast<Real>(edge / c) : 0;
}

template <World W>
void Transport<W>::evaluate(Path<W>& x, int i) const {
  Vertex<W>& v = x[i];
  if (v.event == Event::emission) return evaluate_emission(x);
  if (v.event == Event::detection) return evaluate_detection(x, i);
  const ShadingFrame<W> frame(*scene_, v.place);
  const Direction light = -x[i - 1].place.to_sensor, sensor = v.place.to_sensor;
  const Local to_light = frame.to_local(light), to_sensor = frame.to_local(sensor);
  const Texel<W> texel(*scene_, v.place);
  const Scattering<W> s = texel.scaled(frame.stretched(
      std::visit([&](const auto& m) { return m.evaluate(v.event, to_light, to_sensor); },
                 material(v)),
      light, sensor));
  const auto q = static_cast<double>(survival(v));
  v.value = s.value;
  v.tint = s.tint;
  x[i + 1].from_light = static_cast<Real>(q * s.toward_sensor * v.geometry);
  x[i - 1].from_sensor = static_cast<Real>(q * s.toward_light * x[i - 1].geometry);
}

template <World W>
auto Transport<W>::albedo(const Vertex<W>& v) const -> Real {
  if (v.event == Event::emission || v.event == Event::detection) return 1;
  return Texel<W>(*scene_, v.place).scaled(scene_->surface(v.place.shape).albedo);
}

template <World W>
InvertedNumbers<W> Transport<W>::inverted(const Path<W>& x, int i, Toward toward) const {
  const Vertex<W>& v = x[i];
  const Direction sampled = direction(x, i, toward);
  if (v.event == Event::detection && v.place.shape == no_shape)
    return {.direction = *scene_->camera()->film_coordinate(v.place.position, sampled)};
  if (v.event == Event::emission || v.event == Event::detection)
    return {.direction = square<W>(W::Dimension::cosine_invert(
                frame_at(*scene_, v.place, v.place.normal).to_local(sampled)))};
  const ShadingFrame<W> frame(*scene_, v.place);
  return std::visit(
      [&](const auto& m) {
        return m.invert(frame.to_local(known_direction(x, i, toward)), frame.to_local(sampled),
                        v.event);
      },
      material(v));
}

template <World W>
PointNumbers<W> Transport<W>::inverted_point(const Path<W>& x, int i) const {
  const Vertex<W>& v = x[i];
  if (v.place.shape == no_shape) {
    if (scene_->camera()->is_pinhole()) return {};
    return {.position = scene_->camera()->invert_lens(v.place.position)};
  }
  return {.position = visit_shape(
              [&](const auto& s) { return s.parameter(v.place.position, v.place.primitive); },
              scene_->shape(v.place.shape))};
}

template <World W>
double Transport<W>::light_choice(ShapeId shape, double u) const {
  const auto lights = scene_->lights();
  const auto light = std::ranges::lower_bound(lights, shape) - lights.begin();
  return scene_->light_choice().number(static_cast<std::size_t>(light), u);
}

template <World W>
auto Transport<W>::film_position(const Path<W>& x) const -> typename W::Square {
  return film_position_at(*scene_, x, x.size() - 1);
}

static_assert(MovablePathSpace<Transport<Flatland>>);
static_assert(MovablePathSpace<Transport<FlatlandSingle>>);
static_assert(MovablePathSpace<Transport<Spaceland>>);
static_assert(MovablePathSpace<Transport<SpacelandColour>>);

template class Transport<Flatland>;
template class Transport<FlatlandSingle>;
template class Transport<Spaceland>;
template class Transport<SpacelandColour>;

}  // namespace wander
