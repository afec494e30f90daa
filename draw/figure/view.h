// A scene in space as its camera has it in its picture; one without a camera is seen from the front,
// from above and from aside, so that all of it is in the picture.
//
// The picture is 1 wide and as high as its pixels are; x goes to the right and y upwards, from the
// lower left corner.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/description.h"
#include "core/vector.h"
#include "draw/figure/curve.h"
#include "records/scene_faces.h"

namespace wander::figure {

using Place = Vec<3, double>;

class View {
 public:
  explicit View(const description::Camera& camera);
  // Of all these faces.
  explicit View(const SceneFaces& faces);

  double height() const { return height_; }
  Extent extent() const;
  const Place& eye() const { return eye_; }

  // None of what is beside or behind the eye.
  std::optional<Vector> operator()(const Place& place) const;
  // What of a line is before the eye.
  struct Piece {
    Vector from, to;
  };
  std::optional<Piece> line(const Place& from, const Place& to) const;
  // A path in the picture, given the coordinates of its vertices one after the other; a vertex that
  // is no number parts what does not hang together.  The vertex on the lens is the eye, where a path
  // ends that is seen, and is left out.
  std::vector<Vector> path(std::span<const double> coordinates) const;

 private:
  void aim(const Place& target, const Place& up, double fov_degrees);
  double depth(const Place& place) const;
  Vector projected(const Place& place) const;

  Place eye_, axis_, right_, up_;
  double width_ = 1;  // of the picture at distance 1
  double height_ = 1, lens_ = 0;
  double near_ = 1e-6;  // what is nearer is not drawn
};

}  // namespace wander::figure
