#include "core/exact/visibility.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace wander::exact {

namespace {

constexpr double relative_tolerance = 1e-13;

double size_of(std::span<const PlaneSegment> segments) {
  double size = 0;
  for (const PlaneSegment& s : segments)
    for (const PlanePoint p : {s.from, s.to}) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  return size;
}

// Both lie on one line and share more of it than a point.
bool overlap(const PlaneSegment& s, const PlaneSegment& other, double tolerance) {
  const PlanePoint d = s.to - s.from;
  const double size = length(d);
  const double along_from = dot(other.from - s.from, d) / size;
  const double along_to = dot(other.to - s.from, d) / size;
  const double off_line =
      std::max(std::abs(cross(other.from - s.from, d)), std::abs(cross(other.to - s.from, d))) /
      size;
  const double common = std::min(size, std::max(along_from, along_to)) -
                        std::max(0.0, std::min(along_from, along_to));
  return off_line <= tolerance && common > 2 * tolerance;
}

// Positions on `s` where it has to be cut because `other` crosses or touches it.
std::vector<double> cuts_by(const PlaneSegment& s, const PlaneSegment& other, double tolerance) {
  if (overlap(s, other, tolerance))
    throw std::invalid_argument("two segments overlap along a length");
  std::vector<double> cuts;
  for (const PlanePoint end : {other.from, other.to})
    if (distance(end, s) <= tolerance) cuts.push_back(nearest_position(end, s));
  if (!cuts.empty()) return cuts;

  const PlanePoint d = s.to - s.from, e = other.to - other.from, offset = other.from - s.from;
  const double turn = cross(d, e);
  if (turn == 0) return cuts;
  const double here = cross(offset, e) / turn, there = cross(offset, d) / turn;
  if (here > 0 && here < 1 && there > 0 && there < 1) cuts.push_back(here);
  return cuts;
}

// A piece in the receiver's frame (x along the tangent, y along the normal), above its horizon.
struct Candidate {
  const SegmentPiece* piece;
  Side side;
  PlanePoint start, along;      // the whole piece: start + s·along, s in [0, 1]
  double theta_from, theta_to;  // rising
  double at_from, at_to;        // positions s on the piece at these angles
};

struct Aperture {
  double theta, at;
};

// The angle of `at` on the piece; a point on the horizon, where a clipped piece ends, has exactly
// ±π/2, which keeps pieces that meet there from leaving a gap.
Aperture aperture_at(PlanePoint start, PlanePoint along, double at, double tolerance) {
  const PlanePoint p = start + at * along;
  const double height = p.y <= tolerance ? 0 : p.y;
  return {std::atan2(p.x, height), at};
}

// Nothing to see of a piece below the horizon, edge-on, or in line with the receiver's own.
void add_candidate(std::vector<Candidate>& candidates, const Receiver& receiver,
                   const SegmentPiece& piece, double tolerance) {
  const PlanePoint n = receiver.normal, t = {n.y, -n.x};
  const PlanePoint a = piece.line.from - receiver.position, b = piece.line.to - receiver.position;
  const PlanePoint start{dot(a, t), dot(a, n)}, end{dot(b, t), dot(b, n)};
  if (start.y <= tolerance && end.y <= tolerance) return;
  const PlanePoint along = end - start;
  const double horizon = start.y / (start.y - end.y);
  Aperture p = aperture_at(start, along, start.y < 0 ? horizon : 0, tolerance);
  Aperture q = aperture_at(start, along, end.y < 0 ? horizon : 1, tolerance);
  // The normal is left of from→to: whoever sees the piece run from left to right is behind it.
  const Side side = p.theta < q.theta ? Side::back : Side::front;
  if (p.theta > q.theta) std::swap(p, q);
  if (q.theta > p.theta)
    candidates.push_back({&piece, side, start, along, p.theta, q.theta, p.at, q.at});
}

// The position on the piece that is seen in this direction.
double position_at(const Candidate& c, double theta) {
  if (theta == c.theta_from) return c.at_from;
  if (theta == c.theta_to) return c.at_to;
  const PlanePoint ray{std::sin(theta), std::cos(theta)};
  const auto [low, high] = std::minmax(c.at_from, c.at_to);
  return std::clamp(cross(c.start, ray) / cross(ray, c.along), low, high);
}

// The candidate that spans the whole interval and is nearest in its middle.
const Candidate* nearest_in(const std::vector<Candidate>& candidates, double from, double to) {
  const double middle = 0.5 * (from + to);
  const PlanePoint ray{std::sin(middle), std::cos(middle)};
  const Candidate* nearest = nullptr;
  double shortest = std::numeric_limits<double>::infinity();
  for (const Candidate& c : candidates) {
    if (c.theta_from > from || c.theta_to < to) continue;
    const double reach = cross(c.start, c.along) / cross(ray, c.along);
    if (reach >= shortest) continue;
    shortest = reach;
    nearest = &c;
  }
  return nearest;
}

double on_segment(const SegmentPiece& piece, double at) {
  return std::lerp(piece.from, piece.to, at);
}

}  // namespace

Visibility::Visibility(std::span<const PlaneSegment> segments)
    : tolerance_(relative_tolerance * size_of(segments)) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double whole = length(segments[i]);
    if (!(whole > tolerance_)) throw std::invalid_argument("a segment has no length");
    std::vector<double> cuts{0, 1};
    for (std::size_t j = 0; j < segments.size(); ++j) {
      if (i == j) continue;
      const std::vector<double> more = cuts_by(segments[i], segments[j], tolerance_);
      cuts.insert(cuts.end(), more.begin(), more.end());
    }
    std::sort(cuts.begin(), cuts.end());
    double from = 0;
    for (const double to : cuts) {
      if ((to - from) * whole <= 2 * tolerance_) continue;
      const double end = (1 - to) * whole <= 2 * tolerance_ ? 1 : to;
      pieces_.push_back({i, from, end, {segments[i].at(from), segments[i].at(end)}});
      from = end;
    }
  }
}

std::vector<VisibleInterval> Visibility::from(const Receiver& receiver) const {
  std::vector<Candidate> candidates;
  for (const SegmentPiece& piece : pieces_) add_candidate(candidates, receiver, piece, tolerance_);
  std::vector<double> angles;
  for (const Candidate& c : candidates) angles.insert(angles.end(), {c.theta_from, c.theta_to});
  std::sort(angles.begin(), angles.end());

  // Between neighbouring angles nothing starts, ends or crosses: one piece is in front throughout.
  std::vector<VisibleInterval> visible;
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const double from = angles[k], to = angles[k + 1];
    if (!(to > from)) continue;
    const Candidate* c = nearest_in(candidates, from, to);
    if (c == nullptr) continue;
    const VisibleInterval next{c->piece->segment,
                               c->side,
                               from,
                               to,
                               on_segment(*c->piece, position_at(*c, from)),
                               on_segment(*c->piece, position_at(*c, to))};
    const bool continues = !visible.empty() && visible.back().segment == next.segment &&
                           visible.back().side == next.side && visible.back().theta_to == from;
    if (continues) {
      visible.back().theta_to = to;
      visible.back().at_to = next.at_to;
    } else {
      visible.push_back(next);
    }
  }
  return visible;
}

}  // namespace wander::exact
