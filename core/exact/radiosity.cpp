#include "core/exact/radiosity.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/exact/gauss.h"
#include "core/exact/radiosity_transport.h"

namespace wander::exact {

namespace {

// Points per stretch of a bin.  Stretches are bisected until an order changes its bin by less than
// this part: kinks of light that was reflected before are in no mesh, but nothing here misses them.
constexpr std::size_t film_points = 7;
constexpr double film_accuracy = 1e-9;
constexpr int film_depth = 30;

using Orders = std::vector<double>;  // one value per number of vertices, from 2

void require(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument("radiosity: " + what);
}

void require_valid(const RadiosityScene& scene) {
  require(scene.max_vertices >= 2, "a path has at least 2 vertices");
  bool has_sensor = false;
  for (const Wall& wall : scene.walls) {
    require(wall.reflectance >= 0 && wall.reflectance <= 1, "a reflectance lies outside [0, 1]");
    require(wall.radiance >= 0 && std::isfinite(wall.radiance), "a radiance is negative");
    has_sensor = has_sensor || wall.bins > 0;
  }
  require(has_sensor, "no wall is a sensor");
}

std::vector<PlaneSegment> lines_of(const RadiosityScene& scene) {
  std::vector<PlaneSegment> lines;
  for (const Wall& wall : scene.walls) lines.push_back({wall.from, wall.to});
  return lines;
}

double brightest(const RadiosityScene& scene) {
  double radiance = 0;
  for (const Wall& wall : scene.walls) radiance = std::max(radiance, wall.radiance);
  return radiance;
}

Receiver receiver_on(const Wall& wall, Side side, double position) {
  const PlaneSegment line{wall.from, wall.to};
  return {line.at(position), sign_of(side) * normal(line)};
}

// The films, order by order, on one mesh.
class RadiositySolver {
 public:
  RadiositySolver(const RadiosityScene& scene, const RadiosityMesh& mesh)
      : scene_(scene),
        lines_(lines_of(scene)),
        visibility_(lines_),
        mesher_(scene, visibility_, mesh),
        elements_(make_elements(scene, mesher_, mesh)),
        transport_(scene, visibility_, elements_) {}

  RadiositySolution solve() {
    collect_nodes();
    sum_neumann_series();
    RadiositySolution solution;
    for (std::size_t w = 0; w < scene_.walls.size(); ++w)
      if (scene_.walls[w].bins > 0) solution.sensors.push_back(film_of(w));
    solution.wall_irradiance = wall_means();
    solution.unknowns = nodes_.size();
    return solution;
  }

 private:
  struct Node {
    std::size_t wall;
    Side side;
    double position, weight;  // on the wall; part of the wall's length
  };
  struct BinIntegral {
    std::size_t wall;
    double tolerance;  // of the integral over [0, 1] of the wall
  };

  void collect_nodes();
  void sum_neumann_series();
  std::vector<std::array<double, 2>> wall_means() const;
  SensorFilm film_of(std::size_t wall) const;
  Orders gauss(std::size_t wall, Stretch stretch) const;
  Orders refined(const BinIntegral& bin, Stretch stretch, const Orders& estimate, int depth) const;

  const RadiosityScene& scene_;
  std::vector<PlaneSegment> lines_;
  Visibility visibility_;
  Mesher mesher_;
  RadiosityElements elements_;
  Transport transport_;
  std::vector<Node> nodes_;                     // one per unknown
  std::vector<std::vector<double>> radiances_;  // [vertices - 2][unknown]: what makes that order
  std::vector<double> irradiance_;              // of all orders, per unknown
};

// In the order of the unknowns.
void RadiositySolver::collect_nodes() {
  for (std::size_t w = 0; w < scene_.walls.size(); ++w)
    for (const Side side : {Side::front, Side::back})
      for (const Element& element : elements_.of(w, side)) {
        const GaussRule& rule = gauss_rule(element.nodes);
        const Stretch& s = element.stretch;
        for (std::size_t a = 0; a < element.nodes; ++a)
          nodes_.push_back(
              {w, side, std::lerp(s.from, s.to, rule.nodes[a]), rule.weights[a] * (s.to - s.from)});
      }
}

// L_1 = Le, L_{k+1} = ρ/2 · E_k, up to paths of max_vertices.
void RadiositySolver::sum_neumann_series() {
  std::vector<TransportRow> rows;
  std::vector<double> radiance;
  for (const Node& node : nodes_) {
    const Wall& wall = scene_.walls[node.wall];
    const bool reflects = wall.reflectance > 0;
    rows.push_back(reflects ? transport_.row(receiver_on(wall, node.side, node.position))
                            : TransportRow{});
    radiance.push_back(node.side == Side::front ? wall.radiance : 0);
  }
  irradiance_.assign(nodes_.size(), 0.0);
  for (int vertices = 2; vertices <= scene_.max_vertices; ++vertices) {
    radiances_.push_back(radiance);
    std::vector<double> next(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double irradiance = rows[i].irradiance(radiance);
      irradiance_[i] += irradiance;
      next[i] = 0.5 * scene_.walls[nodes_[i].wall].reflectance * irradiance;
    }
    radiance = std::move(next);
  }
}

// Gauss weights turn the irradiance at the nodes into means over each side.
std::vector<std::array<double, 2>> RadiositySolver::wall_means() const {
  std::vector<std::array<double, 2>> means(scene_.walls.size(), {0, 0});
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    means[nodes_[i].wall][nodes_[i].side == Side::front ? 0 : 1] +=
        nodes_[i].weight * irradiance_[i];
  return means;
}

// The integral of every order over a stretch of the sensor, by positions in [0, 1].
Orders RadiositySolver::gauss(std::size_t wall, Stretch stretch) const {
  Orders sum(radiances_.size(), 0.0);
  const GaussRule& rule = gauss_rule(film_points);
  const double width = stretch.to - stretch.from;
  for (std::size_t q = 0; q < film_points; ++q) {
    const double position = std::lerp(stretch.from, stretch.to, rule.nodes[q]);
    const TransportRow row = transport_.row(receiver_on(scene_.walls[wall], Side::front, position));
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += rule.weights[q] * width * row.irradiance(radiances_[k]);
  }
  return sum;
}

// The sum over both halves, each refined in turn unless it agrees with the estimate in every order.
Orders RadiositySolver::refined(const BinIntegral& bin, Stretch stretch, const Orders& estimate,
                                int depth) const {
  const double middle = std::midpoint(stretch.from, stretch.to);
  const Stretch left{stretch.from, middle}, right{middle, stretch.to};
  const Orders a = gauss(bin.wall, left), b = gauss(bin.wall, right);
  Orders sum(a.size());
  double change = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k] = a[k] + b[k];
    change = std::max(change, std::abs(sum[k] - estimate[k]));
  }
  if (change <= bin.tolerance || depth == 0) return sum;
  const Orders fine_a = refined(bin, left, a, depth - 1);
  const Orders fine_b = refined(bin, right, b, depth - 1);
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = fine_a[k] + fine_b[k];
  return sum;
}

// The tolerance is a part of what a first look finds in the bin, with rounding as its floor: a dark
// bin is not refined for ever.
SensorFilm RadiositySolver::film_of(std::size_t wall) const {
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
  film.by_vertices.assign(radiances_.size(), std::vector<double>(bins, 0.0));
  film.mean_irradiance.assign(bins, 0.0);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const std::size_t b = bin_of(stretches[i]);
    const BinIntegral integral{wall, film_accuracy * scale[b] + rounding};
    const Orders orders = refined(integral, stretches[i], estimates[i], film_depth);
    for (std::size_t k = 0; k < orders.size(); ++k) {
      film.by_vertices[k][b] += count * orders[k];
      film.mean_irradiance[b] += count * orders[k];
    }
  }
  return film;
}

}  // namespace

RadiositySolution solve_radiosity_once(const RadiosityScene& scene, const RadiosityMesh& mesh) {
  require_valid(scene);
  require(mesh.nodes >= 2 && mesh.grading > 0 && mesh.smallest > 0, "no such mesh");
  return RadiositySolver(scene, mesh).solve();
}

RadiositySolution solve_radiosity(const RadiosityScene& scene, const RadiosityMesh& mesh) {
  const RadiosityMesh coarse{std::max<std::size_t>(2, mesh.nodes - 1), 2 * mesh.grading,
                             4 * mesh.smallest};
  const RadiositySolution rough = solve_radiosity_once(scene, coarse);
  RadiositySolution solution = solve_radiosity_once(scene, mesh);
  for (std::size_t s = 0; s < solution.sensors.size(); ++s) {
    SensorFilm& film = solution.sensors[s];
    for (std::size_t b = 0; b < film.mean_irradiance.size(); ++b)
      film.error.push_back(std::abs(film.mean_irradiance[b] - rough.sensors[s].mean_irradiance[b]));
  }
  return solution;
}

}  // namespace wander::exact
