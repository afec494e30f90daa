// What a point of the plane sees of a scene of segments, exactly: a finite set of angular
// intervals, found by sorting the angles of all ends, so that occlusion costs no accuracy.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/exact/plane.h"

namespace wander::exact {

// A part of a segment as seen from a receiver; angles rise from the horizon on the left of the
// receiver's normal to the one on its right, -π/2 … π/2.  `at_from` is the position on the segment,
// in [0, 1], seen at `theta_from`.
struct VisibleInterval {
  std::size_t segment = 0;
  Side side = Side::front;  // which side of the segment is seen
  double theta_from = 0, theta_to = 0;
  double at_from = 0, at_to = 0;
};

// A part of one of the given segments that no other touches in its interior.
struct SegmentPiece {
  std::size_t segment = 0;
  double from = 0, to = 1;  // positions on the segment
  PlaneSegment line;
};

// The scene, prepared: segments are cut where others cross or touch them.  Segments that overlap
// along a length are an error (std::invalid_argument), since neither side is then defined.
class Visibility {
 public:
  explicit Visibility(std::span<const PlaneSegment> segments);

  // What the receiver sees, in rising angle.  Segments in line with the receiver's own are edge-on
  // and not seen, so a receiver may lie on one.
  std::vector<VisibleInterval> from(const Receiver& receiver) const;

  const std::vector<SegmentPiece>& pieces() const { return pieces_; }
  double tolerance() const { return tolerance_; }  // of lengths: rounding at the scene's size

 private:
  std::vector<SegmentPiece> pieces_;
  double tolerance_ = 0;
};

}  // namespace wander::exact
