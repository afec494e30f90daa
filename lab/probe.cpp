#include "lab/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/path_sampler.h"
#include "core/requirements.h"
#include "core/rng.h"
#include "mlt/seeds/nothing_found.h"
#include "scenes/format/build_scene.h"

namespace wander {

namespace {

constexpr int walks = 4000, legs = 12, most_crossings = 64;
constexpr std::uint64_t light_samples = 4096,
                        most_samples = 1 << 18;  // the latter until some is found
constexpr std::uint64_t most_rays = 8'000'000;   // of all samples
constexpr double turns = 0.25;                   // of the lines end in the open
constexpr std::size_t most_contradictions = 10;

struct Sides {
  double inside = 0, outside = 0;  // indices of refraction
};

template <World W>
std::optional<Sides> sides_of(const Material<W>& material) {
  return std::visit(
      [](const auto& m) -> std::optional<Sides> {
        if constexpr (requires { m.interior; })
          return Sides{m.interior, m.exterior};
        else
          return std::nullopt;
      },
      material);
}

template <World W>
class MediaWalk {
 public:
  using Point = typename W::Point;
  using Direction = typename W::Direction;

  MediaWalk(const Scene<W>& scene, const description::Scene& described, Probe& found)
      : scene_(scene), described_(described), shapes_(shapes_named<W>(described)), found_(found) {}

  void all() {
    for (int i = 0; i < walks && said_.size() < most_contradictions; ++i) {
      rng_.start(static_cast<std::uint64_t>(i));
      walk();
    }
  }

 private:
  struct Place {
    Point position;
    Element<W> element{};  // none: in the open
    Direction outward{};   // away from the surface it is on
  };
  struct Medium {
    std::optional<double> index;
    ShapeId told_by = no_shape;  // none: what was found at the sensor
  };

  Direction direction_from(const Place& place) {
    for (;;) {
      Direction d{};
      for (int axis = 0; axis < W::dimension; ++axis) d[axis] = 2 * rng_.uniform() - 1;
      const double size = glm::dot(d, d);
      if (!(size > 0.01 && size <= 1)) continue;
      d /= std::sqrt(size);
      return glm::dot(d, place.outward) < 0 ? -d : d;
    }
  }

  Place start() {
    if (scene_.camera()) return {scene_.camera()->position};
    typename W::Square u;
    for (auto& number : u) number = rng_.uniform();
    const SurfacePoint<W> point =
        visit_shape([&](const auto& s) { return s.sample(u); }, scene_.shape(scene_.sensor()));
    return {point.position, Element<W>(scene_.sensor(), point.primitive), point.normal};
  }

  void walk() {
    Place place = start();
    Medium medium{found_.index_at_sensor};
    for (int leg = 0; leg < legs; ++leg)
      if (!go_straight(place, medium)) return;
  }

  // As far as what is opaque, or somewhere before it.  False if the line ends nowhere, or the media
  // contradict each other.
  bool go_straight(Place& place, Medium& medium) {
    Ray<W> ray{place.position, direction_from(place), place.element};
    for (int crossing = 0; crossing < most_crossings; ++crossing) {
      const Hit<W> hit = scene_.closest(ray);
      if (!hit) return false;
      if (rng_.uniform() < turns) {
        const double share = rng_.uniform();
        place = {ray.origin + share * hit.distance * ray.direction};
        return true;
      }
      const SurfacePoint<W> point = scene_.surface_point(ray, hit);
      const bool from_outside = glm::dot(ray.direction, point.normal) < 0;
      const Element<W> element(hit.shape, hit.primitive);
      const auto sides = sides_of<W>(*scene_.surface(hit.shape).material);
      if (!sides) {
        place = {point.position, element, from_outside ? point.normal : -point.normal};
        return true;
      }
      if (!enter(*sides, from_outside, hit.shape, medium)) return false;
      ray = {point.position, ray.direction, element};
    }
    return false;
  }

  bool enter(const Sides& sides, bool from_outside, ShapeId shape, Medium& medium) {
    const double here = from_outside ? sides.outside : sides.inside;
    if (!medium.index) {
      found_.index_at_sensor = here;
      if (!from_outside)
        warn(shape,
             "the sensor is inside this glass, which is behind its normal; flip the glass if "
             "that is not meant");
    } else if (std::abs(*medium.index - here) > 1e-9 * here) {
      contradict(medium, shape, from_outside, here);
      return false;
    }
    medium = {from_outside ? sides.inside : sides.outside, shape};
    return true;
  }

  void contradict(const Medium& medium, ShapeId shape, bool from_outside, double here) {
    if (!said_.insert(shape_of(shape)).second) return;
    const std::string source = medium.told_by == no_shape
                                   ? "as at the sensor"
                                   : fmt::format("as beyond /shapes/{}", shape_of(medium.told_by));
    warn(shape, fmt::format(
                    "light meets this glass from the {} in a medium of index {}, {}, and here that "
                    "side has {}; a face is turned over, two bodies of glass overlap, or one is "
                    "open",
                    from_outside ? "outside" : "inside", *medium.index, source, here));
  }

  std::size_t shape_of(ShapeId id) const { return shapes_[static_cast<std::size_t>(id)]; }
  void warn(ShapeId id, std::string what) {
    const description::Shape& place = described_.shapes[shape_of(id)];
    found_.warnings.push_back(
        {place.line, place.column, fmt::format("/shapes/{}", shape_of(id)), std::move(what)});
  }

  const Scene<W>& scene_;
  const description::Scene& described_;
  std::vector<std::size_t> shapes_;  // of the file, of each that rays meet
  Probe& found_;
  Rng rng_{1, Purpose::test, 0};
  std::set<std::size_t> said_;  // shapes
};

bool has_glass(const description::Scene& scene) {
  return std::ranges::any_of(scene.materials, [](const description::Material& material) {
    return std::holds_alternative<description::Dielectric>(material.kind) ||
           std::holds_alternative<description::RoughDielectric>(material.kind);
  });
}

template <World W>
void look_for_light(const Scene<W>& scene, Probe& found) {
  PathSampler<Transport<W>> sampler(Transport<W>(scene, Roulette::by_albedo), all_techniques,
                                    Heuristic::power);
  Rng rng(1, Purpose::test, 1);
  const auto is_enough = [&] {
    return sampler.rays() >= most_rays ||
           found.samples >= (found.samples_with_light > 0 ? light_samples : most_samples);
  };
  for (; !is_enough(); ++found.samples) {
    rng.start(found.samples);
    bool arrives = false;
    sampler.sample(rng, [&](const JoinedPath<W>&, int, double) { arrives = true; });
    if (arrives) ++found.samples_with_light;
  }
  if (found.samples_with_light == 0)
    found.warnings.push_back(
        {1, 1, "/",
         fmt::format("none of {} bidirectional samples found a light path from a light to the "
                     "sensor: it is rare, or there is none; {}",
                     found.samples, where_light_is_lost)});
}

template <World W>
Probe probe_in(const description::Scene& described) {
  const auto scene = build_scene<W>(described);
  Probe found;
  if (has_glass(described)) MediaWalk<W>(*scene, described, found).all();
  look_for_light(*scene, found);
  return found;
}

}  // namespace

Probe probe(const description::Scene& scene) {
  if (scene.dimension == 2) return probe_in<Flatland>(scene);
  // Of colours that have no channel in common the luminances alone would let light through.
  return requires_of(scene).colour_channels == 1 ? probe_in<Spaceland>(scene)
                                                 : probe_in<SpacelandColour>(scene);
}

}  // namespace wander
