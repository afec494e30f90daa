// What estimators and mutations ask of a world of paths.  Transport is one (core/transport.h says
// what each of these does); the finite graphs in which kernels are enumerated are another.
#pragma once

#include <concepts>

#include "core/path.h"
#include "core/rng.h"

namespace wander {

// Russian roulette: whether a walk goes on depends on the vertex alone, and is part of the density.
enum class Roulette { off, by_albedo };

enum class Connection { open, occluded, facing_away };

// Subpaths are sampled vertex by vertex, connected and measured.
template <class S>
concept PathSpace = requires(const S& space, Path<typename S::Universe>& y,
                             const Path<typename S::Universe>& x,
                             const Vertex<typename S::Universe>& v, int i, Toward toward,
                             Rng& random) {
  { space.max_vertices() } -> std::same_as<int>;
  space.begin_light(y, i, random);
  space.begin_sensor(y, i, random);
  { space.extend(y, i, toward, random) } -> std::same_as<bool>;
  { space.survival(v) } -> std::convertible_to<double>;
  { space.albedo(v) } -> std::convertible_to<double>;
  { space.with(Roulette::by_albedo) } -> std::convertible_to<S>;
  { space.may_connect(x, i, x, i) } -> std::same_as<bool>;
  { space.connect(y, i) } -> std::same_as<Connection>;
  space.evaluate(y, i);
  { space.can_connect(v) } -> std::same_as<bool>;
  { space.is_light(v) } -> std::same_as<bool>;
  { space.is_sensor(v) } -> std::same_as<bool>;
  { space.sensor_can_be_hit() } -> std::same_as<bool>;
  { space.bin(x) } -> std::same_as<int>;
};

// What is there can be moved: ends on their surfaces, directions, specular events; and a path can
// be turned back into the random numbers that would have made it.
template <class S>
concept MovablePathSpace = PathSpace<S> &&
    requires(const S& space, Path<typename S::Universe>& y, const Path<typename S::Universe>& x,
             int i, Toward toward, Event event, typename S::Direction direction, Rng& random) {
  space.move_end(y, i, space.end_parameter(x, i));
  { space.shoot(y, i, toward, direction) } -> std::same_as<bool>;
  { space.aim_film(y, i, space.film_position(x)) } -> std::same_as<bool>;
  { space.follow(y, i, toward, event) } -> std::same_as<bool>;
  { space.direction(x, i, toward) } -> std::convertible_to<typename S::Direction>;
  { space.end_density(x, i) } -> std::convertible_to<double>;
  { space.aim_density(x, i, toward) } -> std::convertible_to<double>;
  { space.follow_density(x, i, toward) } -> std::convertible_to<double>;
  space.begin_light(y, i, space.invert_begin(x, i, random));
  space.begin_sensor(y, i, space.invert_begin(x, i, random));
  { space.extend(y, i, toward, space.invert_extend(x, i, toward, random)) } -> std::same_as<bool>;
  { space.chooses_light(x[i]) } -> std::same_as<bool>;
  { space.chooses_lobe(x[i]) } -> std::same_as<bool>;
};

}  // namespace wander
