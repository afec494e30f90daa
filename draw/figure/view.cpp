#include "draw/figure/view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace wander::figure {
namespace {

// Of the distance to what is looked at.
constexpr double nearest = 1e-3;

Place place_of(const description::Coordinates& c) { return {c[0], c[1], c[2]}; }

bool is_finite(const Place& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct Ball {
  Place centre{0, 0, 0};
  double radius = 1;
};

Ball ball_around(const SceneFaces& faces) {
  constexpr std::size_t numbers = 9;
  Place low(INFINITY), high(-INFINITY);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const double* c = &faces.corners[f * numbers + 3 * k];
      const Place p{c[0], c[1], c[2]};
      if (!is_finite(p)) continue;
      const Place reach(std::isfinite(faces.radius[f]) ? faces.radius[f] : 0);
      low = glm::min(low, p - reach);
      high = glm::max(high, p + reach);
    }
  if (!is_finite(low)) return {};
  return {(low + high) / 2., std::max(glm::length(high - low) / 2, 1e-300)};
}

}  // namespace

View::View(const description::Camera& camera)
    : eye_(place_of(camera.position)), lens_(camera.aperture_radius) {
  height_ = static_cast<double>(camera.resolution[1]) / camera.resolution[0];
  aim(place_of(camera.target), place_of(camera.up), camera.fov_degrees);
}

View::View(const SceneFaces& faces) {
  constexpr double fov = 40;
  const Ball ball = ball_around(faces);
  const double distance = ball.radius / std::sin(fov / 2 * std::numbers::pi / 180);
  eye_ = ball.centre + distance * glm::normalize(Place{0.55, 0.45, 1});
  aim(ball.centre, {0, 1, 0}, fov);
}

void View::aim(const Place& target, const Place& up, double fov_degrees) {
  axis_ = glm::normalize(target - eye_);
  right_ = glm::normalize(glm::cross(axis_, glm::normalize(up)));
  up_ = glm::cross(right_, axis_);
  width_ = 2 * std::tan(fov_degrees * std::numbers::pi / 360);
  near_ = nearest * glm::distance(target, eye_);
}

Extent View::extent() const { return {{0, 0}, {1, height_}}; }

double View::depth(const Place& place) const { return glm::dot(place - eye_, axis_); }

Vector View::projected(const Place& place) const {
  const Place offset = place - eye_;
  const double scale = 1 / (depth(place) * width_);
  return {0.5 + glm::dot(offset, right_) * scale, height_ / 2 + glm::dot(offset, up_) * scale};
}

std::optional<Vector> View::operator()(const Place& place) const {
  if (!(depth(place) >= near_)) return std::nullopt;
  return projected(place);
}

std::optional<View::Piece> View::line(const Place& from, const Place& to) const {
  const double a = depth(from), b = depth(to);
  if (!(std::max(a, b) >= near_) || !std::isfinite(a + b)) return std::nullopt;
  const auto end = [&](const Place& place, double own, const Place& other, double others) {
    return own >= near_ ? place : place + (near_ - own) / (others - own) * (other - place);
  };
  return Piece{projected(end(from, a, to, b)), projected(end(to, b, from, a))};
}

std::vector<Vector> View::path(std::span<const double> coordinates) const {
  std::vector<Place> places;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    const Place p{coordinates[i], coordinates[i + 1], coordinates[i + 2]};
    if (is_finite(p) && glm::distance(p, eye_) > std::max(near_, 1.001 * lens_))
      places.push_back(p);
  }
  std::vector<Vector> line;
  if (places.size() == 1)
    if (const auto spot = (*this)(places.front())) line.push_back(*spot);
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const auto piece = this->line(places[k], places[k + 1]);
    if (!piece) continue;
    const bool goes_on = !line.empty() && line.back() == piece->from;
    if (!goes_on && !line.empty()) line.emplace_back(NAN, NAN);
    if (!goes_on) line.push_back(piece->from);
    line.push_back(piece->to);
  }
  return line;
}

}  // namespace wander::figure
