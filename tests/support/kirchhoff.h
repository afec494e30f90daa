// The Kirchhoff furnace: a closed room in which every surface emits what it does not scatter,
//   Le(x→ω) = 1 - albedo(x, ω),
// so that L = 1 everywhere outside of glass, whatever the materials.  Then b = c = ∫ cos θ dω for
// paths of any length, and exact independent samples of the target exist: start at the sensor,
// scatter by the material, and end at a vertex with the probability 1 - albedo that it absorbs.
//
// Kirchhoff has the vocabulary of Transport<Flatland>, with emission that depends on the direction.
// Walls run counter-clockwise and emit on their inner side; glass is smooth, and emits nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/techniques.h"
#include "core/transport.h"

namespace wander::test {

class Kirchhoff {
 public:
  using Universe = Flatland;
  using W = Flatland;

  // Shapes 0 … shapes - 1 are those of the scene.
  Kirchhoff(const Scene<W>& scene, int shapes);

  const Scene<W>& scene() const { return flat_.scene(); }
  int max_vertices() const { return flat_.max_vertices(); }
  double survival(const Vertex<W>&) const { return 1; }
  double albedo(const Vertex<W>&) const { return 1; }
  const Kirchhoff& with(Roulette) const { return *this; }

  template <class Random>
  void begin_light(Path<W>& x, int i, Random& random) const {
    PointNumbers<W> u;
    u.light = random.uniform();
    u.position[0] = random.uniform();
    begin_light(x, i, u);
  }
  void begin_light(Path<W>& x, int i, PointNumbers<W> u) const;
  template <class NumbersOrRandom>
  void begin_sensor(Path<W>& x, int i, NumbersOrRandom& u) const {
    flat_.begin_sensor(x, i, u);
  }
  template <class NumbersOrRandom>
  bool extend(Path<W>& x, int i, Toward toward, NumbersOrRandom& u) const {
    return flat_.extend(x, i, toward, u);
  }
  bool may_connect(const Path<W>&, int, const Path<W>&, int) const { return true; }
  Connection connect(Path<W>& x, int i) const { return flat_.connect(x, i); }
  void evaluate(Path<W>& x, int i) const;

  template <class Random>
  PointNumbers<W> invert_begin(const Path<W>& x, int i, Random& random) const {
    if (x[i].event != Event::emission) return flat_.invert_begin(x, i, random);
    return inverted_emitter(x[i], random.uniform());
  }
  template <class Random>
  ScatterNumbers<W> invert_extend(const Path<W>& x, int i, Toward toward, Random& random) const {
    return flat_.invert_extend(x, i, toward, random);
  }

  bool chooses_light(const Vertex<W>& v) const { return v.event == Event::emission; }
  bool chooses_lobe(const Vertex<W>& v) const { return flat_.chooses_lobe(v); }

  W::Square end_parameter(const Path<W>& x, int i) const { return flat_.end_parameter(x, i); }
  void move_end(Path<W>& x, int i, W::Square u) const { flat_.move_end(x, i, u); }
  bool shoot(Path<W>& x, int i, Toward toward, W::Direction direction) const {
    return flat_.shoot(x, i, toward, direction);
  }
  bool aim_film(Path<W>& x, int i, W::Square film) const { return flat_.aim_film(x, i, film); }
  bool follow(Path<W>& x, int i, Toward toward, Event event) const {
    return flat_.follow(x, i, toward, event);
  }
  W::Direction direction(const Path<W>& x, int i, Toward toward) const {
    return flat_.direction(x, i, toward);
  }
  double end_density(const Path<W>& x, int i) const { return flat_.end_density(x, i); }
  double aim_density(const Path<W>& x, int i, Toward toward) const {
    return flat_.aim_density(x, i, toward);
  }
  double follow_density(const Path<W>& x, int i, Toward toward) const {
    return flat_.follow_density(x, i, toward);
  }
  bool is_camera(const Vertex<W>& v) const { return flat_.is_camera(v); }
  bool is_pinhole(const Vertex<W>& v) const { return flat_.is_pinhole(v); }

  bool can_connect(const Vertex<W>& v) const { return flat_.can_connect(v); }
  bool is_light(const Vertex<W>& v) const { return pmf_[index(v.place.shape)] > 0; }
  bool is_sensor(const Vertex<W>& v) const { return flat_.is_sensor(v); }
  bool sensor_can_be_hit() const { return true; }
  W::Square film_position(const Path<W>& x) const { return flat_.film_position(x); }
  int bin(const Path<W>& x) const { return flat_.bin(x); }

  // The share of light towards `sensor_side` that is scattered light of a room where L = 1.
  double albedo(const Vertex<W>& v, W::Direction sensor_side) const;

  // An exact sample of f / b into x.  False: it has more than max_vertices vertices.
  bool sample(Path<W>& x, Rng& random) const;
  // Samples until one is short enough; counts the tries.
  std::uint64_t sample_short(Path<W>& x, Rng& random) const;

 private:
  static std::size_t index(ShapeId shape) { return static_cast<std::size_t>(shape); }
  PointNumbers<W> inverted_emitter(const Vertex<W>& v, double free) const;

  Transport<W> flat_;
  std::vector<double> pmf_;  // of choosing a shape as the emitter; 0: it does not emit
  double density_ = 0;       // of points on emitters
};

// A room with its space; the scene outlives the copies of the space.
struct Furnace {
  std::unique_ptr<const Scene<Flatland>> scene;
  Kirchhoff space;
};

// Six walls of these materials; the second is the sensor.
inline constexpr std::size_t furnace_walls = 6;
Furnace furnace(std::vector<Material<Flatland>> walls, int max_vertices);
// Diffuse walls of several reflectances.
Furnace diffuse_furnace(int max_vertices);
// Diffuse walls, a mirror, rough metal, and a circle of glass in the middle.
Furnace mixed_furnace(int max_vertices);

}  // namespace wander::test
