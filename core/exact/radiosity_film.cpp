#include "core/exact/radiosity_film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wander::exact {

namespace {

// Points per stretch of a bin.  Stretches are bisected until an order changes its bin by less than
// this part: kinks of light that was reflected before are in no mesh.  What falls between the points is
// missed by all of them; that shows in the flux (radiosity_refinement.cpp), and then there is a least depth.
constexpr std::size_t film_points = 7;
constexpr double film_accuracy = 1e-9;
constexpr int film_depth = 30;

double brightest(const RadiosityScene& scene) {
  double radiance = 0;
  for (const Wall& wall : scene.walls) radiance = std::max(radiance, wall.radiance);
  return radiance;
}

}  // namespace

// The integral of every order over a stretch of the sensor, by positions in [0, 1].
FilmIntegral::Orders FilmIntegral::gauss(std::size_t wall, Stretch stretch) const {
  Orders sum(series_.radiance.size(), 0.0);
  for (const Node& node : nodes_on(wall, Side::front, stretch, film_points)) {
    const TransportRow row = transport_.row(receiver_at(scene_, node));
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += node.weight * row.irradiance(series_.radiance[k]);
  }
  return sum;
}

// The sum over both halves, each refined in turn unless it agrees with the estimate in every order.
FilmIntegral::Orders FilmIntegral::refined(const BinIntegral& bin, Stretch stretch,
                                           const Orders& estimate, int depth) const {
  const double middle = std::midpoint(stretch.from, stretch.to);
  const Stretch left{stretch.from, middle}, right{middle, stretch.to};
  const Orders a = gauss(bin.wall, left), b = gauss(bin.wall, right);
  Orders sum(a.size());
  double change = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k] = a[k] + b[k];
    change = std::max(change, std::abs(sum[k] - estimate[k]));
  }
  if (depth == 0) return sum;
  if (change <= bin.tolerance && depth <= film_depth - bin.least_depth) return sum;
  const Orders fine_a = refined(bin, left, a, depth - 1);
  const Orders fine_b = refined(bin, right, b, depth - 1);
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = fine_a[k] + fine_b[k];
  return sum;
}

// The tolerance is a part of what a first look finds in the bin, with rounding as its floor: a dark
// bin is not refined for ever.
SensorFilm FilmIntegral::film_of(std::size_t wall, int least_depth) const {
  const std::size_t bins = scene_.walls[wall].bins;
  const auto count = static_cast<double>(bins);
  std::vector<double> edges, scale(bins, 0.0);
  for (std::size_t b = 1; b < bins; ++b) edges.push_back(static_cast<double>(b) / count);
  const std::vector<Stretch> stretches = mesher_.stretches(wall, edges);
  const auto bin_of = [&](Stretch s) {
    return static_cast<std::size_t>(std::midpoint(s.from, s.to) * count);
  };
  std::vector<Orders> estimates;
  for (const Stretch s : stretches) {
    estimates.push_back(gauss(wall, s));
    for (const double e : estimates.back()) scale[bin_of(s)] += e;
  }
  const double rounding = 1e-14 * brightest(scene_) / count;
  SensorFilm film{.wall = wall, .by_vertices = {}, .mean_irradiance = {}, .error = {}};
  film.by_vertices.assign(series_.radiance.size(), std::vector<double>(bins, 0.0));
  film.mean_irradiance.assign(bins, 0.0);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const std::size_t b = bin_of(stretches[i]);
    const BinIntegral integral{wall, film_accuracy * scale[b] + rounding, least_depth};
    const Orders orders = refined(integral, stretches[i], estimates[i], film_depth);
    for (std::size_t k = 0; k < orders.size(); ++k) film.by_vertices[k][b] += count * orders[k];
  }
  // What rounding leaves of light that is not there is none.
  const double nothing = std::numeric_limits<double>::epsilon() * brightest(scene_);
  for (std::vector<double>& order : film.by_vertices)
    for (std::size_t b = 0; b < bins; ++b) {
      if (order[b] < nothing) order[b] = 0;
      film.mean_irradiance[b] += order[b];
    }
  return film;
}

}  // namespace wander::exact
