#include "core/exact/radiosity_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/exact/radiosity_film.h"
#include "core/exact/radiosity_series.h"

namespace wander::exact {

namespace {

constexpr RadiosityMesh first_mesh{.nodes = 6, .grading = 1, .smallest = 0x1p-10};
// Elements are bisected, the worst first, until the rest has no more than this part of the bound.
constexpr double left_alone = 0.05;
constexpr double shortest = 0x1p-40;  // of a wall

std::size_t sensor_of(const RadiosityScene& scene) {
  std::size_t wall = 0;
  while (scene.walls[wall].bins == 0) ++wall;
  return wall;
}

// The radiance of the sensor if it shone.
std::vector<double> importance(const RadiosityScene& scene, const std::vector<Node>& nodes) {
  const std::size_t sensor = sensor_of(scene);
  std::vector<double> radiance;
  for (const Node& node : nodes)
    radiance.push_back(node.wall == sensor && node.side == Side::front ? 1 : 0);
  return radiance;
}

// Sums of W over its first orders: [j] is of the orders up to j.
std::vector<double> partial_sums(std::vector<double> w) {
  std::partial_sum(w.begin(), w.end(), w.begin());
  return w;
}

// One mesh and what was found on it.
class MeshSolution {
 public:
  MeshSolution(const RadiosityScene& scene, const Visibility& visibility,
               const RadiosityElements& elements)
      : scene_(scene),
        elements_(elements),
        transport_(scene, visibility, elements),
        nodes_(nodes_of(elements)) {
    const std::vector<TransportRow> rows = rows_of(scene, transport_, nodes_);
    light_ = neumann_series(scene, nodes_, rows, emission(scene, nodes_));
    sensor_ = neumann_series(scene, nodes_, rows, importance(scene, nodes_));
  }

  SensorFilm film(const Mesher& mesher, int least_depth) const {
    return FilmIntegral(scene_, mesher, transport_, light_).film_of(sensor_of(scene_), least_depth);
  }
  // Flux on the sensor that was reflected at least once: ∫ ρ/2 E_1 Σ_j W_j dl.
  double reflected_flux() const;
  // Σ |residual| × importance of each element, in the order of the elements.
  std::vector<double> errors() const;

 private:
  int orders() const { return scene_.max_vertices - 2; }  // E_k and W_j with k + j <= orders + 1
  double error_of(std::size_t wall, Side side, const Element& element) const;
  double residual(const Element& element, const Node& node) const;

  const RadiosityScene& scene_;
  const RadiosityElements& elements_;
  Transport transport_;
  std::vector<Node> nodes_;
  Series light_, sensor_;
};

double MeshSolution::reflected_flux() const {
  double flux = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Wall& wall = scene_.walls[nodes_[i].wall];
    double w = 0;
    for (int j = 0; j < orders(); ++j) w += sensor_.irradiance[static_cast<std::size_t>(j)][i];
    flux += nodes_[i].weight * length(wall.to - wall.from) * 0.5 * wall.reflectance *
            light_.irradiance[0][i] * w;
  }
  return flux;
}

// Σ_k |r_k| Σ_j W_j at a point of the element.
double MeshSolution::residual(const Element& element, const Node& node) const {
  const TransportRow row = transport_.row(receiver_at(scene_, node));
  const double t =
      (node.position - element.stretch.from) / (element.stretch.to - element.stretch.from);
  std::vector<double> lagrange(element.nodes, 0.0);
  add_lagrange(lagrange.data(), element.nodes, t, 1);
  std::vector<double> w;
  for (int j = 0; j < orders(); ++j)
    w.push_back(row.irradiance(sensor_.radiance[static_cast<std::size_t>(j)]));
  w = partial_sums(std::move(w));
  double sum = 0;
  for (std::size_t k = 0; k < w.size(); ++k) {
    double interpolated = 0;
    for (std::size_t a = 0; a < element.nodes; ++a)
      interpolated += lagrange[a] * light_.irradiance[k][element.first + a];
    sum += std::abs(row.irradiance(light_.radiance[k]) - interpolated) * w[w.size() - 1 - k];
  }
  return sum;
}

double MeshSolution::error_of(std::size_t wall, Side side, const Element& element) const {
  const Wall& w = scene_.walls[wall];
  if (!(w.reflectance > 0)) return 0;
  const Stretch& s = element.stretch;
  const double middle = std::midpoint(s.from, s.to);
  double sum = 0;
  for (const Stretch& half : {Stretch{s.from, middle}, Stretch{middle, s.to}})
    for (const Node& node : nodes_on(wall, side, half, element.nodes))
      sum += node.weight * residual(element, node);
  return 0.5 * w.reflectance * length(w.to - w.from) * sum;
}

std::vector<double> MeshSolution::errors() const {
  std::vector<double> errors;
  for (std::size_t w = 0; w < scene_.walls.size(); ++w)
    for (const Side side : {Side::front, Side::back})
      for (const Element& element : elements_.of(w, side))
        errors.push_back(error_of(w, side, element));
  return errors;
}

// The same of a film: by its bins.
double reflected_flux(const RadiosityScene& scene, const SensorFilm& film) {
  const Wall& sensor = scene.walls[film.wall];
  double sum = 0;
  for (std::size_t k = 1; k < film.by_vertices.size(); ++k)
    sum += std::accumulate(film.by_vertices[k].begin(), film.by_vertices[k].end(), 0.0);
  return sum / static_cast<double>(sensor.bins) * length(sensor.to - sensor.from);
}

// A film that has the flux which comes to its sensor.  The points of the film may all miss a narrow spot of light
// that was reflected before, on which the mesh of the walls knows that it shines; then the film is made of finer
// stretches.  What is missing in the end is an error of every bin, for it may be in any.
struct CheckedFilm {
  SensorFilm film{};
  int least_depth = 0;
  double missing = 0;  // of the mean irradiance; what is within rounding is none
};
CheckedFilm checked_film(const RadiosityScene& scene, const Mesher& mesher,
                         const MeshSolution& solution, double bound) {
  constexpr std::array least_depths{0, 3, 6, 9};
  constexpr std::size_t most_stretches = 4096;
  constexpr double agreement = 1e-6;
  const Wall& sensor = scene.walls[sensor_of(scene)];
  const double flux = solution.reflected_flux();
  CheckedFilm found;
  for (const int least_depth : least_depths) {
    if (least_depth > 0 && sensor.bins << least_depth > most_stretches) break;
    found.film = solution.film(mesher, found.least_depth = least_depth);
    found.missing = std::abs(reflected_flux(scene, found.film) - flux);
    if (found.missing <= (agreement + 4 * bound) * flux) {
      found.missing = 0;
      return found;
    }
  }
  found.missing /= length(sensor.to - sensor.from);
  return found;
}

// The least error that is large enough for its element to be bisected.
double threshold(std::vector<double> errors, double total) {
  std::ranges::sort(errors);
  double rest = 0;
  for (const double error : errors) {
    rest += error;
    if (rest > left_alone * total) return error;
  }
  return errors.empty() ? 0 : errors.back();
}

RadiosityElements bisected(const RadiosityElements& elements, const std::vector<double>& errors,
                           double least) {
  RadiosityElements result;
  result.sides.resize(elements.sides.size());
  std::size_t index = 0;
  for (std::size_t w = 0; w < elements.sides.size(); ++w)
    for (std::size_t side = 0; side < 2; ++side)
      for (const Element& element : elements.sides[w][side]) {
        const Stretch& s = element.stretch;
        const double middle = std::midpoint(s.from, s.to);
        const bool splits = errors[index++] >= least && s.to - s.from > shortest;
        const auto append = [&](const Stretch& stretch) {
          result.sides[w][side].push_back({stretch, result.unknowns, element.nodes});
          result.unknowns += element.nodes;
        };
        append(splits ? Stretch{s.from, middle} : s);
        if (splits) append({middle, s.to});
      }
  return result;
}

}  // namespace

RadiositySolution solve_radiosity_adaptively(const RadiosityScene& scene,
                                             const Refinement& refinement) {
  require_valid(scene);
  const Visibility visibility(lines_of(scene));
  const Mesher mesher(scene, visibility, first_mesh);
  RadiosityElements elements = make_elements(scene, mesher, first_mesh), coarser = elements;
  if (elements.unknowns > refinement.most_unknowns)
    throw std::invalid_argument("radiosity: " + std::to_string(elements.unknowns) + " unknowns");
  for (;;) {
    const MeshSolution solution(scene, visibility, elements);
    const std::vector<double> errors = solution.errors();
    const double error = std::accumulate(errors.begin(), errors.end(), 0.0);
    const double bound = error > 0 ? error / solution.reflected_flux() : 0;
    RadiosityElements finer = bisected(elements, errors, threshold(errors, error));
    if (!(bound <= refinement.tolerance) && finer.unknowns <= refinement.most_unknowns) {
      coarser = std::exchange(elements, std::move(finer));
      continue;
    }
    auto [film, least_depth, missing] = checked_film(scene, mesher, solution, bound);
    const SensorFilm rough = MeshSolution(scene, visibility, coarser).film(mesher, least_depth);
    for (std::size_t b = 0; b < film.mean_irradiance.size(); ++b)
      film.error.push_back(std::abs(film.mean_irradiance[b] - rough.mean_irradiance[b]) +
                           bound * film.mean_irradiance[b] + missing);
    return {.sensors = {std::move(film)}, .wall_irradiance = {}, .unknowns = elements.unknowns};
  }
}

}  // namespace wander::exact
