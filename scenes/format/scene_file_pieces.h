// The curves of a scene in units of its diameter: what the doubts about its geometry are measured
// on.  Independent of the shapes that rays meet, and never on the way of light.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/description.h"

namespace wander {

struct Piece {
  enum class Carrier { line, circle };

  Carrier carrier = Carrier::line;
  std::size_t shape = 0;                     // in the scene
  glm::dvec2 from{}, to{};                   // ends; equal for a circle
  glm::dvec2 center{};                       // of a circle or arc
  double radius = 0, start = 0, extent = 0;  // radians, counter-clockwise
  double facing = 1;  // -1: the normal of a circle or arc points to the centre
  bool is_light = false, is_sensor = false;
  glm::dvec2 low{}, high{};  // bounding box

  double length() const;
  bool is_closed() const { return carrier == Carrier::circle && from == to; }
  glm::dvec2 at(double u) const;  // u in [0, 1] along the curve
  glm::dvec2 normal(glm::dvec2 point) const;
  glm::dvec2 nearest(glm::dvec2 point) const;
  double distance(glm::dvec2 point) const;
  // Signed distance from the whole line or circle that carries the piece.
  double side(glm::dvec2 point) const;
};

struct Pieces {
  std::vector<Piece> pieces;  // the scene moved to its centre and divided by its diameter
  glm::dvec2 middle{};        // of the scene, in metres
  double diameter = 0;        // of the scene, in metres
  double remoteness = 0;      // largest coordinate, in diameters
};

Pieces pieces_of(const description::Scene& scene);

}  // namespace wander
