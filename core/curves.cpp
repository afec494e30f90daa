#include "core/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wander::description {

namespace {

bool same_point(const Coordinates& a, const Coordinates& b) { return a == b; }  // -0 is 0

double distance(const Coordinates& a, const Coordinates& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

}  // namespace

Flaws Segment::flaws() const {
  if (same_point(from, to))
    return {{"to", "from and to are the same point; a segment has a length > 0"}};
  if (too_near(from, to)) return {{"to", too_short}};
  return {};
}

Outline Segment::outline() const { return {*this}; }

double Segment::length() const { return distance(from, to); }

Flaws Polyline::flaws() const {
  Flaws found;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (same_point(points[i], points[i - 1]))
      found.push_back({"points", "this repeats the point before it; leave one of the two out", i});
    else if (too_near(points[i], points[i - 1]))
      found.push_back({"points", too_short, i});
  }
  if (!closed) return found;
  const std::size_t last = points.size() - 1;
  if (same_point(points.front(), points.back()))
    found.push_back({"points",
                     "this repeats the first point; leave it out, for \"closed\" joins the ends",
                     last});
  else if (too_near(points.front(), points.back()))
    found.push_back({"points", too_short, last});
  return found;
}

Outline Polyline::outline() const {
  Outline sides;
  sides.reserve(points.size());
  for_each_side([&](const auto& from, const auto& to) { sides.push_back(Segment{from, to}); });
  return sides;
}

double Polyline::length() const {
  double sum = 0;
  for_each_side([&](const auto& from, const auto& to) { sum += distance(from, to); });
  return sum;
}

Flaws Circle::flaws() const { return flaws_of_radius(radius); }

Outline Circle::outline() const { return {Arc{center, radius, 0, 360, flip}}; }

double Circle::length() const { return 2 * std::numbers::pi * radius; }

double Arc::degrees_turned() const {
  double turn = to_degrees - from_degrees;
  while (turn <= 0) turn += 360;
  return std::min(turn, 360.0);
}

Flaws Arc::flaws() const {
  Flaws found = flaws_of_radius(radius);
  const double turn = std::abs(to_degrees - from_degrees);
  if (turn == 0)
    found.push_back(
        {"to_deg", "from_deg and to_deg are equal; an arc spans > 0 and at most 360 degrees"});
  else if (turn > 360)
    found.push_back(
        {"to_deg", fmt::format("{} degrees are too many; an arc spans at most 360", turn)});
  return found;
}

Outline Arc::outline() const { return {*this}; }

double Arc::length() const { return std::numbers::pi / 180 * degrees_turned() * radius; }

}  // namespace wander::description
