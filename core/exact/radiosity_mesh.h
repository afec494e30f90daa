// The mesh of the radiosity solver: where the irradiance on a wall may break, and the elements, on
// each of which it is smooth.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/exact/radiosity.h"
#include "core/exact/visibility.h"

namespace wander::exact {

// A stretch of a wall, by positions in [0, 1].
struct Stretch {
  double from = 0, to = 1;
};

// Part of one side of a wall; `nodes` unknowns from index `first`, at Gauss points.  One node means
// a constant, exact for black emitters and sensors.
struct Element {
  Stretch stretch;
  std::size_t first = 0, nodes = 1;
};

// Cuts walls into stretches on which the irradiance is smooth at their own scale.
class Mesher {
 public:
  Mesher(const RadiosityScene& scene, const Visibility& visibility, const RadiosityMesh& mesh);

  // `edges` are positions at which stretches end, beside where the light changes.
  std::vector<Stretch> stretches(std::size_t wall, std::vector<double> edges) const;

 private:
  struct Corner {
    PlanePoint point;
    std::vector<std::size_t> walls;  // that end, or are touched, there
  };

  void collect_corners();
  void collect_shadow_edges();
  bool lights_past(const Corner& near, PlanePoint direction) const;
  bool is_blocked(PlanePoint p, PlanePoint q) const;
  void break_behind(const Corner& near, PlanePoint direction);
  void refine(std::size_t wall, Stretch stretch, std::vector<Stretch>& result) const;
  bool is_fine(std::size_t wall, Stretch stretch) const;
  PlaneSegment line(std::size_t wall) const;

  const RadiosityScene& scene_;
  const Visibility& visibility_;
  RadiosityMesh mesh_;
  std::vector<Corner> corners_;
  std::vector<std::vector<double>> breaks_;  // per wall
};

// The unknowns: the radiance that leaves each node, numbered by wall, then side, then position.
struct RadiosityElements {
  std::vector<std::array<std::vector<Element>, 2>> sides;  // [wall][side], in order of position
  std::size_t unknowns = 0;

  const std::vector<Element>& of(std::size_t wall, Side side) const {
    return sides[wall][side == Side::front ? 0 : 1];
  }
};

RadiosityElements make_elements(const RadiosityScene& scene, const Mesher& mesher,
                                const RadiosityMesh& mesh);

}  // namespace wander::exact
