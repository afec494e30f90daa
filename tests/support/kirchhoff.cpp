#include "tests/support/kirchhoff.h"

#include <cmath>
#include <numbers>

#include "tests/support/quadrature.h"

namespace wander::test {

namespace {

using W = Flatland;
using Local = W::Local;

bool emits(const Material<W>& material) { return !std::holds_alternative<Dielectric<W>>(material); }

// ∫ f(ω_i → ω_o) dσ⊥ over the hemisphere, θ_i = ±(π/2) (1 - (1 - t)²) towards grazing directions.
double scattered(const RoughConductor<W>& metal, Local to_sensor) {
  const GaussRule& rule = gauss_rule(48);
  double sum = 0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double t = rule.nodes[k], theta = std::numbers::pi / 2 * (1 - (1 - t) * (1 - t));
    const double weight = rule.weights[k] * std::numbers::pi * (1 - t) * std::cos(theta);
    for (const double side : {-1.0, 1.0})
      sum += weight * metal
                          .evaluate(Event::scattering,
                                    Local(side * std::sin(theta), std::cos(theta)), to_sensor)
                          .value;
  }
  return sum;
}

struct Albedo {
  Local to_sensor;
  double operator()(const RoughConductor<W>& m) const { return scattered(m, to_sensor); }
  double operator()(const auto& m) const { return m.survival(); }
};

double length_of(const Shape<W>& shape) {
  return visit_shape([](const auto& s) { return static_cast<double>(s.measure()); }, shape);
}

}  // namespace

Kirchhoff::Kirchhoff(const Scene<W>& scene, int shapes)
    : flat_(scene, Roulette::off), pmf_(static_cast<std::size_t>(shapes)) {
  double total = 0;
  for (ShapeId id = 0; id < shapes; ++id)
    if (emits(*scene.surface(id).material)) total += pmf_[index(id)] = length_of(scene.shape(id));
  for (double& p : pmf_) p /= total;
  density_ = 1 / total;
}

void Kirchhoff::begin_light(Path<W>& x, int i, PointNumbers<W> u) const {
  std::size_t shape = 0;
  while (shape + 1 < pmf_.size() && (pmf_[shape] == 0 || u.light >= pmf_[shape]))
    u.light -= pmf_[shape++];
  const auto id = static_cast<ShapeId>(shape);
  const auto point =
      visit_shape([&](const auto& s) { return s.sample(u.position); }, scene().shape(id));
  x[i].place.position = point.position;
  x[i].place.normal = point.normal;
  x[i].place.shape = id;
  x[i].event = Event::emission;
}

PointNumbers<W> Kirchhoff::inverted_emitter(const Vertex<W>& v, double free) const {
  PointNumbers<W> u;
  const std::size_t shape = index(v.place.shape);
  for (std::size_t k = 0; k < shape; ++k) u.light += pmf_[k];
  u.light += free * pmf_[shape];
  u.position = visit_shape([&](const auto& s) { return s.parameter(v.place.position); },
                           scene().shape(v.place.shape));
  return u;
}

double Kirchhoff::albedo(const Vertex<W>& v, W::Direction sensor_side) const {
  const Local local = Frame<2, double>{v.place.normal}.to_local(sensor_side);
  return std::visit(Albedo{local}, *scene().surface(v.place.shape).material);
}

// Directions are sampled ∝ cos on the inner side, as those of a light: p⊥ = 1/2.
void Kirchhoff::evaluate(Path<W>& x, int i) const {
  Vertex<W>& v = x[i];
  if (v.event != Event::emission) return flat_.evaluate(x, i);
  const bool faces = glm::dot(v.place.to_sensor, v.place.normal) > 0;
  v.value = faces ? 1 - albedo(v, v.place.to_sensor) : 0;
  v.from_light = density_;
  x[1].from_light = faces ? v.geometry / W::Dimension::half_space<double> : 0;
}

// A scattered direction of density p is kept with the probability f / p, so it goes on with the
// probability ∫ p f/p = albedo.
bool Kirchhoff::sample(Path<W>& x, Rng& random) const {
  const int longest = max_vertices();
  x.resize(longest);
  int i = longest - 1;
  flat_.begin_sensor(x, i, random);
  if (!flat_.extend(x, i, Toward::light, random)) return false;
  flat_.evaluate(x, i);
  for (--i; i > 0; --i) {
    const bool absorbs = is_light(x[i]);
    const bool sampled = flat_.extend(x, i, Toward::light, random);
    double kept = 0;
    if (sampled) {
      flat_.evaluate(x, i);
      kept = x[i].value * x[i - 1].geometry / x[i - 1].from_sensor;
    }
    if (absorbs && !(random.uniform() < kept)) break;
    if (!sampled) return false;
  }
  // The first vertex has room for no other: it must end here, or the path is too long.
  if (i == 0 && !(is_light(x[0]) && random.uniform() >= albedo(x[0], x[0].place.to_sensor)))
    return false;
  const int n = longest - i;
  for (int k = 0; k < n; ++k) x[k] = x[i + k];
  x.resize(n);
  x[0].event = Event::emission;
  evaluate(x, 0);
  return true;
}

std::uint64_t Kirchhoff::sample_short(Path<W>& x, Rng& random) const {
  std::uint64_t tries = 1;
  while (!sample(x, random)) ++tries;
  return tries;
}

namespace {

SceneParts<W> room(std::vector<Material<W>> walls, int max_vertices) {
  const std::vector<W::Point> corners{{0, 0}, {0.3, 0}, {0.9, 0}, {1.1, 0.9}, {0.4, 1}, {0, 0.6}};
  SceneParts<W> parts;
  parts.materials = std::move(walls);
  for (std::size_t k = 0; k < furnace_walls; ++k)
    parts.parts.push_back({.shape = Segment<W>(corners[k], corners[(k + 1) % furnace_walls]),
                           .material = k,
                           .is_sensor = k == 1});
  parts.resolution = {8};
  parts.max_vertices = max_vertices;
  return parts;
}

Furnace built(SceneParts<W> parts) {
  const int shapes = static_cast<int>(parts.parts.size());
  auto scene = std::make_unique<const Scene<W>>(std::move(parts));
  const Kirchhoff space(*scene, shapes);
  return {std::move(scene), space};
}

}  // namespace

Furnace furnace(std::vector<Material<W>> walls, int max_vertices) {
  return built(room(std::move(walls), max_vertices));
}

Furnace diffuse_furnace(int max_vertices) {
  return furnace({Diffuse<W>{0.2}, Diffuse<W>{0.5}, Diffuse<W>{0.7}, Diffuse<W>{0.3},
                  Diffuse<W>{0.6}, Diffuse<W>{0.4}},
                 max_vertices);
}

Furnace mixed_furnace(int max_vertices) {
  SceneParts<W> parts = room({Diffuse<W>{0.4}, Diffuse<W>{0.3}, Mirror<W>{0.7}, Diffuse<W>{0.5},
                              RoughConductor<W>{0.4, 0.8}, Diffuse<W>{0.6}},
                             max_vertices);
  parts.materials.push_back(Dielectric<W>{1.5, 1});
  parts.parts.push_back(
      {.shape = Arc<W>({0.55, 0.45}, 0.15, 0, 2 * std::numbers::pi, Arc<W>::Facing::outward),
       .material = furnace_walls});
  return built(std::move(parts));
}

}  // namespace wander::test
