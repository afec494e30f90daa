#include "lab/symmetries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/engine.h"
#include "lab/failure.h"
#include "mlt/seeds/nothing_found.h"

namespace wander {

namespace {

// How far a scene is varied, as powers of two: 1e±30 of lengths; of radiances what their range allows.
constexpr int far = 100, near = 30;

// ---- lengths and directions

template <class Visit>
void visit_points(description::Coordinates& point, const Visit& visit) {
  visit(point);
}
template <std::size_t n, class Visit>
void visit_points(std::array<description::Coordinates, n>& points, const Visit& visit) {
  for (auto& point : points) visit(point);
}
template <class Visit>
void visit_points(std::vector<description::Coordinates>& points, const Visit& visit) {
  for (auto& point : points) visit(point);
}
template <class Other, class Visit>
void visit_points(Other&, const Visit&) {}

// Of a shape that is its own: those of a mesh are copied.
template <class Visit>
void visit_points(description::ShapeKind& shape, const Visit& visit) {
  std::visit(
      [&](auto& kind) {
        if constexpr (requires { kind.triangles; }) {
          auto own = std::make_shared<Triangles>(*kind.triangles);
          visit_points(own->points, visit);
          kind.triangles = std::move(own);
        }
        std::apply([&](auto... field) { (visit_points(kind.*field.value, visit), ...); },
                   kind.fields());
      },
      shape);
}

void scale_radius(description::ShapeKind& shape, double factor) {
  std::visit(
      [factor](auto& kind) {
        if constexpr (requires { kind.radius; }) kind.radius *= factor;
      },
      shape);
}

template <class Visit>
description::Scene with_points(description::Scene scene, const Visit& visit) {
  for (description::Shape& shape : scene.shapes) visit_points(shape.kind, visit);
  if (scene.camera) {
    visit(scene.camera->position);
    visit(scene.camera->target);
  }
  return scene;
}

description::Scene scaled(const description::Scene& scene, double factor) {
  description::Scene result = with_points(scene, [factor](description::Coordinates& p) {
    for (double& coordinate : p) coordinate *= factor;
  });
  for (description::Shape& shape : result.shapes) scale_radius(shape.kind, factor);
  if (!result.camera) return result;
  result.camera->aperture_radius *= factor;
  if (result.camera->focus_distance) *result.camera->focus_distance *= factor;
  return result;
}

// About z: points and directions.
description::Scene turned(const description::Scene& scene) {
  constexpr auto turn = [](description::Coordinates& p) { p = {-p[1], p[0], p[2]}; };
  description::Scene result = with_points(scene, turn);
  if (result.camera) turn(result.camera->up);
  for (description::Shape& shape : result.shapes)
    if (auto* mesh = std::get_if<description::Mesh>(&shape.kind)) {
      auto own = std::make_shared<Triangles>(*mesh->triangles);
      std::ranges::for_each(own->normals, turn);
      mesh->triangles = std::move(own);
    }
  return result;
}

bool may_be_said(const description::Scene& scene) {
  bool is_near = true;
  with_points(scene, [&](description::Coordinates& p) {
    is_near = is_near && std::ranges::all_of(p, [](double coordinate) {
                return std::abs(coordinate) <= description::largest_coordinate;
              });
  });
  return is_near && std::ranges::all_of(scene.shapes, [](const description::Shape& shape) {
           return std::visit([](const auto& kind) { return kind.flaws().empty(); }, shape.kind);
         });
}

// Angles are measured from the x-axis: a turned arc has others, and so have the numbers of points that
// are sampled on circles and spheres.
bool turns_exactly(const description::Scene& scene) {
  return std::ranges::all_of(scene.shapes, [](const auto& shape) {
    const bool is_sampled = shape.light || shape.sensor;
    const bool is_round = std::holds_alternative<description::Circle>(shape.kind) ||
                          std::holds_alternative<description::Sphere>(shape.kind);
    return !std::holds_alternative<description::Arc>(shape.kind) && !(is_sampled && is_round);
  });
}

// ---- light

template <class Keep>
bool all_radiances(const description::Scene& scene, Keep&& keep) {
  return std::ranges::all_of(scene.shapes, [&](const description::Shape& shape) {
    return !shape.light || std::ranges::all_of(shape.light->radiance.channels, [&](double channel) {
      return channel == 0 || keep(channel);
    });
  });
}

description::Scene brightened(description::Scene scene, double factor) {
  for (description::Shape& shape : scene.shapes)
    if (shape.light)
      for (double& channel : shape.light->radiance.channels) channel *= factor;
  return scene;
}

}  // namespace

std::vector<Variation> variations_of(const description::Scene& scene) {
  std::vector<Variation> all;
  for (const int exponent : {near, far, -near, -far}) {
    description::Scene other = scaled(scene, std::ldexp(1.0, exponent));
    if (may_be_said(other))
      all.push_back({fmt::format("lengths x 2^{}", exponent), 1, std::move(other)});
  }
  for (const int exponent : {near, -near, far, -far}) {
    const double factor = std::ldexp(1.0, exponent);
    if (all_radiances(scene, [&](double channel) {
          return channel * factor <= description::largest_radiance &&
                 channel * factor >= description::smallest_radiance;
        }))
      all.push_back({fmt::format("radiances x 2^{}", exponent), factor, brightened(scene, factor)});
  }
  if (turns_exactly(scene)) all.push_back({"turned by 90 degrees", 1, turned(scene)});
  description::Scene with_material = scene;
  with_material.materials.push_back({"of nothing", description::Dielectric{}});
  all.push_back({"a material that is not used", 1, std::move(with_material)});
  return all;
}

namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b, double factor) {
  return std::ranges::equal(a, b, [factor](double x, double y) {
    return x * factor == y || (std::isnan(x) && std::isnan(y));
  });
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

void hold_against(const FilmEstimate& film, const FilmEstimate& varied, double factor,
                  SymmetryCheck& check) {
  if (same_bits(film.value, varied.value, factor) &&
      same_bits(film.standard_error, varied.standard_error, factor) &&
      film.reliable == varied.reliable)
    return;
  check.verdict = SymmetryVerdict::differs;
  for (std::size_t i = 0; i < film.value.size(); ++i)
    check.difference =
        std::max(check.difference, std::abs(film.value[i] * factor - varied.value[i]));
  check.difference /= std::max(largest(film.value) * factor, std::numeric_limits<double>::min());
}

// Joined; empty if it can be rendered.
std::string why_refused(const description::Scene& scene, const Method& method, const Dials& dials) {
  return fmt::format("{}", fmt::join(why_unfit(scene, method, dials), "; "));
}

class OfOneMethod {
 public:
  OfOneMethod(const Method& method, const Dials& dials, const Session& session)
      : method_(method), dials_(dials), session_(session) {}

  void check(const description::Scene& scene, const std::vector<Variation>& variations,
             std::vector<SymmetryCheck>& checks) const {
    if (!why_refused(scene, method_, dials_).empty()) return;
    FilmEstimate film;
    try {
      film = film_of(scene);
    } catch (const NoLightFound&) {
      return;
    }
    for (const Variation& variation : variations) {
      SymmetryCheck check{std::string(method_.name), variation.name, dials_.precision};
      check.reason = why_refused(variation.scene, method_, dials_);
      if (check.reason.empty())
        compare(film, variation, check);
      else
        check.verdict = SymmetryVerdict::refused;
      checks.push_back(std::move(check));
    }
  }

 private:
  // Light that is no longer found is all the difference that there can be.
  void compare(const FilmEstimate& film, const Variation& variation, SymmetryCheck& check) const {
    try {
      hold_against(film, film_of(variation.scene), variation.film_factor, check);
    } catch (const NoLightFound&) {
      check.verdict = SymmetryVerdict::differs;
      check.difference = 1;
    }
  }
  FilmEstimate film_of(const description::Scene& scene) const {
    return render(Job(scene, method_, dials_), session_).film;
  }

  const Method& method_;
  const Dials& dials_;
  const Session& session_;
};

}  // namespace

std::vector<SymmetryCheck> check_symmetries(const Job& job,
                                            const std::vector<Variation>& variations,
                                            const Session& session,
                                            const std::function<void()>& done) {
  std::vector<SymmetryCheck> checks;
  for (const Precision precision : {Precision::of_double, Precision::of_float}) {
    Dials dials = job.dials();
    dials.precision = precision;
    for (const Method& method : methods()) {
      OfOneMethod(method, dials, session).check(job.scene(), variations, checks);
      done();
    }
  }
  return checks;
}

}  // namespace wander
