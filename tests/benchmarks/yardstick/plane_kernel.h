// The default mixture on scenes of the plane in which segments are all there is, one lamp, one sensor
// and diffuse walls, written by hand for these alone: what the generic text is measured against.
//
// The chain has the same four mutations with the same acceptances, and the same film.  Rays and random
// numbers are those of the library.  What it makes use of: every density is a product of geometry terms
// of edges,
//   p_s = P · 2 / g_{s-1},  p_0 = P |lamp|,  p_n = P |sensor|,  P = Π (g_e / 2) / (|lamp| |sensor|).
#pragma once

#include <array>
#include <vector>

#include "core/path.h"
#include "core/rng.h"
#include "core/scene.h"
#include "mlt/seeds/seed_tally.h"
#include "mutations/kelemen.h"
#include "mutations/perturbation.h"

namespace wander {

class PlaneKernel {
 public:
  using W = Flatland;
  using Point = W::Point;
  enum Mutation { bidirectional, lens, primary_small, primary_large, mutations };
  static constexpr int most_vertices = 16;

  struct Vertex {
    Point position;
    int wall;
  };
  struct Path {
    int n = 0;
    std::array<Vertex, most_vertices> at;
    std::array<Point, most_vertices> way;  // from vertex i to i + 1, of unit length
    std::array<double, most_vertices> g;   // of that edge
    double f = 0, intensity = 0;
    int bin = 0;
  };
  struct Outcome {
    int mutation;
    double acceptance;
    bool accepted;
  };

  PlaneKernel(const Scene<W>& scene, const SeedTally& seeds);

  Path start(const wander::Path<W>& x) const;
  // Moves x on, with y for its proposal, whose bin and acceptance are what a film needs.
  Outcome step(Path& x, Path& y, Rng& random) const;

 private:
  struct Wall {
    Point from, along, normal;
    double length, half_reflectance;
    bool scatters;
  };

  // Ratio f T⁻¹ of y to that of x; 0 where y is no path.
  double try_bidirectional(const Path& x, Path& y, Rng& random) const;
  double try_lens(const Path& x, Path& y, Rng& random) const;
  double try_small(const Path& x, Path& y, Rng& random) const;
  double try_large(const Path& x, Path& y, Rng& random) const;

  const Wall& wall(const Path& x, int i) const {
    return walls_[static_cast<std::size_t>(x.at[static_cast<std::size_t>(i)].wall)];
  }
  void begin(Path& y, int i, int wall, double u) const;
  bool shoot(Path& y, int i, int step, Point direction) const;
  bool extend(Path& y, int i, int step, double u) const;
  bool faces(const Path& y, int i, Point direction) const;
  bool join(Path& y, int s) const;
  void measure(Path& y) const;
  double from_light(const Path& x, int i) const;
  double from_sensor(const Path& x, int i) const;
  double technique(const Path& x, int s) const;  // p_s / P
  double added_density(const Path& z, int light, int added) const;
  double large_density(const Path& z) const;
  double number_of(const Path& x, int i, int step) const;

  const Scene<W>* scene_;
  std::vector<Wall> walls_;
  int lamp_, sensor_, longest_;
  double radiance_;
  std::array<double, mutations> weights_;
  std::vector<double> length_pmf_;
  std::vector<std::vector<double>> technique_pmf_;  // [n]
  PerturbationRange range_;
  Kelemen kelemen_;
};

}  // namespace wander
