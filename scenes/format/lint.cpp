#include "scenes/format/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "scenes/format/camera_place.h"
#include "scenes/format/lint_bounds.h"
#include "scenes/format/lint_space.h"
#include "scenes/format/scene_file_pieces.h"

namespace wander {

namespace {

// In units of the scene's diameter.
constexpr double near = 1e-6;

// What the comparison of pairs may cost: most are far apart, which costs little to see.
constexpr std::int64_t most_effort = 32'000'000, effort_for_near_pairs = 16;

// One end of an open piece, and what it nearly meets.
struct End {
  bool is_joined = false;
  double gap = std::numeric_limits<double>::infinity();
  std::size_t other = 0;  // shape
};

enum class Doubt { alone, overlap, facing, gap };

class LintOfPlane {
 public:
  explicit LintOfPlane(const description::Scene& scene)
      : scene_(scene), parts_(pieces_of(scene)), ends_(parts_.pieces.size()) {
    rounding_ = rounding_of_points(1, parts_.remoteness);
  }

  Lint found() && {
    if (parts_.pieces.empty()) return {};
    doubt_extent();
    doubt_features();
    if (rounding_ < near) {  // else nothing can be told apart
      doubt_pairs();
      doubt_gaps();
    }
    return std::move(found_);
  }

 private:
  void doubt_extent();
  void doubt_features();
  void doubt_pairs();
  void doubt_pair(const Piece& a, const Piece& b);
  void doubt_overlap(const Piece& a, const Piece& b);
  void doubt_facing(const Piece& light, const Piece& wall);
  void doubt_gaps();
  void measure_gaps(std::size_t i, const Piece& other);

  bool share_carrier(const Piece& a, const Piece& b) const;
  bool overlap(const Piece& a, const Piece& b) const;
  double in_metres(double length) const { return length * parts_.diameter; }

  // Says each kind of doubt about a shape, or about two, once.
  void warn(Doubt doubt, std::size_t shape, std::size_t other, std::string what) {
    note(found_.warnings, doubt, shape, other, std::move(what));
  }
  void note(std::vector<Fault>& list, Doubt doubt, std::size_t shape, std::size_t other,
            std::string what);

  const description::Scene& scene_;
  Pieces parts_;
  double rounding_ = 0;
  std::vector<std::array<End, 2>> ends_;
  std::set<std::tuple<Doubt, std::size_t, std::size_t>> said_;
  Lint found_;
};

bool has_role(const Piece& piece) { return piece.is_light || piece.is_sensor; }

// Points inside the piece, away from its ends.
std::array<glm::dvec2, 3> inner_points(const Piece& piece) {
  return {piece.at(near), piece.at(0.5), piece.at(1 - near)};
}

std::string pointer_to(std::size_t shape) { return fmt::format("/shapes/{}", shape); }

bool differ(double side_a, double side_b) { return (side_a < 0) != (side_b < 0); }

// Each has its ends on both sides of the other, so that no light passes between them.
bool cross_each_other(const Piece& a, const Piece& b) {
  return differ(a.side(b.from), a.side(b.to)) && differ(b.side(a.from), b.side(a.to));
}

void LintOfPlane::note(std::vector<Fault>& list, Doubt doubt, std::size_t shape, std::size_t other,
                       std::string what) {
  const auto [low, high] = std::minmax(shape, other);
  if (list.size() >= most_findings || !said_.emplace(doubt, low, high).second) return;
  const description::Shape& place = scene_.shapes[shape];
  list.push_back({place.line, place.column, pointer_to(shape), std::move(what)});
}

void LintOfPlane::doubt_extent() {
  if (parts_.remoteness > most_remote)
    warn(Doubt::alone, 0, 0,
         fmt::format("the scene lies {:.1e} of its diameters from the origin, which costs as many "
                     "digits; move it nearer to (0, 0)",
                     parts_.remoteness));
}

void LintOfPlane::doubt_features() {
  for (const Piece& piece : parts_.pieces) {
    double feature = piece.length();
    if (piece.carrier == Piece::Carrier::circle) feature = std::min(feature, piece.radius);
    if (feature < smallest_feature)
      warn(Doubt::alone, piece.shape, piece.shape,
           fmt::format("this shape is {:.1e} times smaller than the scene, too small for exact "
                       "results; ratios up to 1e12 are safe",
                       1 / feature));
  }
}

// Along x, only neighbours can touch.
void LintOfPlane::doubt_pairs() {
  const auto& pieces = parts_.pieces;
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::pair(pieces[i].low.x, i) < std::pair(pieces[j].low.x, j);
  });
  std::int64_t effort = 0;
  for (std::size_t m = 0; m < order.size(); ++m) {
    const Piece& a = pieces[order[m]];
    for (std::size_t n = m + 1; n < order.size(); ++n) {
      const Piece& b = pieces[order[n]];
      if (b.low.x > a.high.x + near) break;
      if (++effort > most_effort) {
        warn(Doubt::alone, b.shape, b.shape,
             "the scene has too many shapes to compare each with all; overlaps and gaps from here "
             "to the right are not looked for");
        return;
      }
      if (b.low.y > a.high.y + near || a.low.y > b.high.y + near) continue;
      effort += effort_for_near_pairs;
      doubt_pair(a, b);
      measure_gaps(order[m], b);
      measure_gaps(order[n], a);
    }
  }
}

void LintOfPlane::doubt_pair(const Piece& a, const Piece& b) {
  if (overlap(a, b)) {
    doubt_overlap(a, b);
    return;
  }
  if (a.is_light) doubt_facing(a, b);
  if (b.is_light) doubt_facing(b, a);
}

bool LintOfPlane::share_carrier(const Piece& a, const Piece& b) const {
  if (a.carrier != b.carrier) return false;
  if (a.carrier == Piece::Carrier::circle)
    return glm::length(a.center - b.center) <= rounding_ &&
           std::abs(a.radius - b.radius) <= rounding_;
  const auto& [shorter, longer] = a.length() < b.length() ? std::tie(a, b) : std::tie(b, a);
  return std::abs(longer.side(shorter.from)) <= rounding_ &&
         std::abs(longer.side(shorter.to)) <= rounding_;
}

bool LintOfPlane::overlap(const Piece& a, const Piece& b) const {
  if (!share_carrier(a, b)) return false;
  if (std::min(a.length(), b.length()) < 4 * rounding_) return false;  // too small to tell
  const auto lies_on = [this](const Piece& piece, const Piece& other) {
    const auto points = inner_points(piece);
    return std::any_of(points.begin(), points.end(),
                       [&](glm::dvec2 point) { return other.distance(point) <= rounding_; });
  };
  return lies_on(a, b) || lies_on(b, a);
}

void LintOfPlane::doubt_overlap(const Piece& a, const Piece& b) {
  const bool second = has_role(b) == has_role(a) ? b.shape > a.shape : has_role(b);
  const Piece& piece = second ? b : a;
  const Piece& other = second ? a : b;
  note(found_.faults, Doubt::overlap, piece.shape, other.shape,
       piece.shape == other.shape ? "parts of this shape lie on each other; leave one of them out"
       : has_role(piece)          ? light_or_sensor_lies_on(piece.is_light, other.shape)
                         : fmt::format("this shape lies on {}; shorten or remove one of the two",
                                       pointer_to(other.shape)));
}

void LintOfPlane::doubt_facing(const Piece& light, const Piece& wall) {
  if (light.shape == wall.shape) return;
  double farthest = 0;
  for (const glm::dvec2 point : inner_points(light)) {
    const glm::dvec2 offset = wall.nearest(point) - point;
    const double distance = glm::length(offset);
    const bool is_near = distance > rounding_ && distance < near;
    if (!is_near || glm::dot(offset, light.normal(point)) < distance / 2) return;
    farthest = std::max(farthest, distance);
  }
  warn(Doubt::facing, light.shape, wall.shape,
       fmt::format("the light faces {} at a distance of {:.1e} m, where its light ends; turn it "
                   "round, or move it off",
                   pointer_to(wall.shape), in_metres(farthest)));
}

// A light or sensor just above a wall is no leak: of these only the ends can meet.
void LintOfPlane::measure_gaps(std::size_t i, const Piece& other) {
  const Piece& piece = parts_.pieces[i];
  if (piece.is_closed()) return;
  const bool is_large = std::min(piece.length(), other.length()) > 2 * near;
  const bool ends_only = has_role(piece) || has_role(other);
  const std::array<glm::dvec2, 2> points{piece.from, piece.to};
  for (std::size_t k = 0; k < points.size(); ++k) {
    End& end = ends_[i][k];
    const double distance = other.distance(points[k]);
    if (distance <= rounding_) end.is_joined = true;
    if (!is_large || end.is_joined) continue;
    const double gap = !ends_only          ? distance
                       : other.is_closed() ? std::numeric_limits<double>::infinity()
                                           : std::min(glm::length(points[k] - other.from),
                                                      glm::length(points[k] - other.to));
    if (gap < end.gap && !cross_each_other(piece, other)) {
      end.gap = gap;
      end.other = other.shape;
    }
  }
}

void LintOfPlane::doubt_gaps() {
  for (std::size_t i = 0; i < ends_.size(); ++i)
    for (const End& end : ends_[i])
      if (!end.is_joined && end.gap < near)
        warn(Doubt::gap, parts_.pieces[i].shape, end.other,
             fmt::format("an end of this shape and {} are {:.1e} m apart, and light leaks through "
                         "the gap; let them share a point",
                         pointer_to(end.other), in_metres(end.gap)));
}

}  // namespace

std::string light_or_sensor_lies_on(bool is_light, std::size_t shape) {
  return fmt::format(
      "the {0} lies on {1} at no distance; move it a small distance off, or put the "
      "{0} on {1} itself",
      is_light ? "light" : "sensor", pointer_to(shape));
}

Lint lint(const description::Scene& scene) {
  Lint found = scene.dimension == 3 ? lint_space(scene) : LintOfPlane(scene).found();
  if (const auto shape = shape_below_camera(scene))
    found.faults.push_back({scene.camera->line, scene.camera->column, "/camera",
                            fmt::format("the camera lies on {} at no distance; move it a small "
                                        "distance off",
                                        pointer_to(*shape))});
  return found;
}

}  // namespace wander
