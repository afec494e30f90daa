#include "core/exact/radiosity_mesh.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace wander::exact {

namespace {

// Breaks nearer than this, as a part of their wall, are one: a kink so little off costs its square.
constexpr double same_break = 1e-7;

// Side of the line through `through` along `direction` (unit) on which p lies: -1, 0 or 1.
int side_of_line(PlanePoint p, PlanePoint through, PlanePoint direction, double tolerance) {
  const double offset = cross(direction, p - through);
  if (std::abs(offset) <= tolerance) return 0;
  return offset > 0 ? 1 : -1;
}

struct Hit {
  double along;     // from the origin of the ray
  double position;  // on the piece
};

std::optional<Hit> intersect(PlanePoint origin, PlanePoint direction, const PlaneSegment& s) {
  const PlanePoint e = s.to - s.from, offset = s.from - origin;
  const double turn = cross(direction, e);
  if (turn == 0) return std::nullopt;
  const double position = cross(offset, direction) / turn;
  if (!(position >= 0 && position <= 1)) return std::nullopt;
  return Hit{cross(offset, e) / turn, position};
}

bool ends_at(const SegmentPiece& piece, PlanePoint p, double tolerance) {
  return length(piece.line.from - p) <= tolerance || length(piece.line.to - p) <= tolerance;
}

}  // namespace

Mesher::Mesher(const RadiosityScene& scene, const Visibility& visibility, const RadiosityMesh& mesh)
    : scene_(scene), visibility_(visibility), mesh_(mesh), breaks_(scene.walls.size()) {
  collect_corners();
  collect_shadow_edges();
}

PlaneSegment Mesher::line(std::size_t wall) const {
  return {scene_.walls[wall].from, scene_.walls[wall].to};
}

void Mesher::collect_corners() {
  const double tolerance = 4 * visibility_.tolerance();
  for (const SegmentPiece& piece : visibility_.pieces()) {
    breaks_[piece.segment].push_back(piece.from);
    for (const PlanePoint p : {piece.line.from, piece.line.to}) {
      auto known = std::find_if(corners_.begin(), corners_.end(),
                                [&](const Corner& c) { return length(c.point - p) <= tolerance; });
      if (known == corners_.end()) known = corners_.insert(known, Corner{p, {}});
      known->walls.push_back(piece.segment);
    }
  }
}

// Whoever moves along a wall sees a change when two corners line up: the nearer one begins or
// ceases to hide the farther.  That happens where the line from the far corner through the near one
// goes on.
void Mesher::collect_shadow_edges() {
  for (const Corner& far : corners_) {
    for (const Corner& near : corners_) {
      if (&far == &near || is_blocked(far.point, near.point)) continue;
      const PlanePoint way = near.point - far.point;
      const PlanePoint direction = (1 / length(way)) * way;
      if (lights_past(near, direction)) break_behind(near, direction);
    }
  }
}

// Not if walls at the corner leave on both sides of the line: then they block it.
bool Mesher::lights_past(const Corner& near, PlanePoint direction) const {
  const double tolerance = 4 * visibility_.tolerance();
  bool left = false, right = false;
  for (const SegmentPiece& piece : visibility_.pieces()) {
    if (!ends_at(piece, near.point, tolerance)) continue;
    for (const PlanePoint end : {piece.line.from, piece.line.to}) {
      const int side = side_of_line(end, near.point, direction, tolerance);
      left = left || side > 0;
      right = right || side < 0;
    }
  }
  return !(left && right);
}

// A wall crosses the open segment pq; one that only touches it does not count.
bool Mesher::is_blocked(PlanePoint p, PlanePoint q) const {
  const double tolerance = 4 * visibility_.tolerance();
  const PlanePoint direction = (1 / length(q - p)) * (q - p);
  for (const SegmentPiece& piece : visibility_.pieces()) {
    const int from = side_of_line(piece.line.from, p, direction, tolerance);
    const int to = side_of_line(piece.line.to, p, direction, tolerance);
    if (from * to >= 0) continue;
    const auto hit = intersect(p, direction, piece.line);
    if (hit && hit->along > tolerance && hit->along < length(q - p) - tolerance) return true;
  }
  return false;
}

void Mesher::break_behind(const Corner& near, PlanePoint direction) {
  const double tolerance = 4 * visibility_.tolerance();
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> wall;
  double position = 0;
  for (const SegmentPiece& piece : visibility_.pieces()) {
    if (ends_at(piece, near.point, tolerance)) continue;
    const auto hit = intersect(near.point, direction, piece.line);
    if (!hit || hit->along <= tolerance || hit->along >= nearest) continue;
    nearest = hit->along;
    wall = piece.segment;
    position = std::lerp(piece.from, piece.to, hit->position);
  }
  if (wall) breaks_[*wall].push_back(position);
}

// Breaks that are as good as one are one; the edges of bins are all kept, where they are.
std::vector<Stretch> Mesher::stretches(std::size_t wall, std::vector<double> edges) const {
  edges.push_back(0);
  edges.push_back(1);
  std::ranges::sort(edges);
  std::vector<double> breaks = breaks_[wall], ends = edges;
  std::ranges::sort(breaks);
  double last = 0;
  for (const double at : breaks) {
    const auto next = std::ranges::upper_bound(edges, at);
    if (next == edges.begin() || next == edges.end()) continue;
    last = std::max(last, *(next - 1));
    if (at - last <= same_break || *next - at <= same_break) continue;
    ends.push_back(last = at);
  }
  std::ranges::sort(ends);
  std::vector<Stretch> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) refine(wall, {ends[i], ends[i + 1]}, result);
  return result;
}

void Mesher::refine(std::size_t wall, Stretch stretch, std::vector<Stretch>& result) const {
  if (is_fine(wall, stretch)) {
    result.push_back(stretch);
    return;
  }
  const double middle = std::midpoint(stretch.from, stretch.to);
  refine(wall, {stretch.from, middle}, result);
  refine(wall, {middle, stretch.to}, result);
}

// Seen from x, the end P of another wall has a sine whose nearest complex singularity is |P - x|
// away: an element no longer than that is resolved by a few nodes.
bool Mesher::is_fine(std::size_t wall, Stretch stretch) const {
  if (stretch.to - stretch.from <= mesh_.smallest) return true;
  const PlaneSegment whole = line(wall);
  const PlaneSegment part{whole.at(stretch.from), whole.at(stretch.to)};
  const double longest = length(part) / mesh_.grading;
  return std::all_of(corners_.begin(), corners_.end(), [&](const Corner& corner) {
    const bool free_end = std::all_of(corner.walls.begin(), corner.walls.end(),
                                      [&](std::size_t owner) { return owner == wall; });
    return free_end || distance(corner.point, part) >= longest;
  });
}

RadiosityElements make_elements(const RadiosityScene& scene, const Mesher& mesher,
                                const RadiosityMesh& mesh) {
  RadiosityElements elements;
  elements.sides.resize(scene.walls.size());
  const auto append = [&](std::vector<Element>& list, Stretch stretch, std::size_t nodes) {
    list.push_back({stretch, elements.unknowns, nodes});
    elements.unknowns += nodes;
  };
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const Wall& wall = scene.walls[w];
    auto& [front, back] = elements.sides[w];
    if (wall.reflectance > 0) {
      const std::vector<Stretch> stretches = mesher.stretches(w, {});
      for (const Stretch stretch : stretches) append(front, stretch, mesh.nodes);
      for (const Stretch stretch : stretches) append(back, stretch, mesh.nodes);
    } else if (wall.radiance > 0 || wall.bins > 0) {  // of a sensor: as if it shone
      append(front, {}, 1);
    }
  }
  return elements;
}

}  // namespace wander::exact
