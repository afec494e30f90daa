// The density that a perturbation claims, against the density with which it proposes, computed from
// the mutation as a map of random numbers onto paths and from nothing else:
//   T(x→y) = 1 / |det ∂y/∂u|,   u: its random numbers, y: the areas of the moved vertices
// (in the plane a side is no number but a choice, of probability 1/2).  A specular vertex is no
// coordinate: T is a coefficient of Π δ(c_i), where
//   c_i = tangential part of w + w'         at a reflection
//         tangential part of n w + n' w'    at a transmission (Snell; ∫ δ n'^(D-1) dσ⊥ = 1)
// and what the δ leave of the area of the specular vertices is 1 / |det ∂c/∂A|.
//
// Derivatives are central differences, taken with two steps; where those disagree, as near an
// edge, there is no answer.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "core/transport.h"
#include "mlt/proposal.h"

namespace wander::test {

// Numbers of a generator, written down; and numbers that were written down.
template <class Random>
struct Recording {
  Random& random;
  std::vector<double> drawn{};
  double uniform() { return drawn.emplace_back(random.uniform()); }
};
struct Script {
  std::vector<double> numbers;
  std::size_t next = 0;
  double uniform() { return numbers.at(next++); }
};

template <class W>
struct Move {
  Path<W> y;
  Proposal claim;
};
// What the mutation makes of these numbers; none: a failure.
template <class Space, class Mutation, class W>
std::optional<Move<W>> move_by(const Space& space, const Mutation& mutation, const Path<W>& x,
                               const std::vector<double>& numbers) {
  Script script{numbers};
  Path<W> y(space.max_vertices());
  const Proposed proposed = mutation.propose(space, x, y, script);
  if (const Proposal* p = std::get_if<Proposal>(&proposed)) return Move<W>{y, *p};
  return {};
}

// The vertices that differ between x and y, specular or not.
template <class W>
std::vector<int> moved_vertices(const Path<W>& x, const Path<W>& y, bool (*which)(Event)) {
  std::vector<int> moved;
  for (int i = 0; i < x.size(); ++i)
    if (x[i].place.position != y[i].place.position && which(x[i].event)) moved.push_back(i);
  return moved;
}
inline bool not_specular(Event e) { return !is_specular(e); }

template <World W>
class DensityOfMoves {
 public:
  explicit DensityOfMoves(const Transport<W>& space) : space_(space) {}

  // T(x→y) by differences, as the coefficient that the mutation claims.
  template <class Mutation>
  std::optional<double> of(const Mutation& mutation, const Path<W>& x, const Path<W>& y,
                           const std::vector<double>& numbers) const {
    const auto coarse = by_step(mutation, x, y, numbers, 2e-5);
    const auto fine = by_step(mutation, x, y, numbers, 1e-5);
    if (!coarse || !fine || !(std::abs(*coarse / *fine - 1) < 1e-5)) return {};
    return fine;
  }
  // |det ∂c/∂A| over the specular vertices that moved; 1 if there are none.
  double constraint(const Path<W>& x, const Path<W>& y, double step = 1e-6) const {
    return std::abs(imbalance_by_area(y, moved_vertices(x, y, is_specular), step).determinant());
  }

 private:
  static constexpr int across = W::dimension - 1;
  using Point = typename W::Point;

  template <class Mutation>
  std::optional<double> by_step(const Mutation& mutation, const Path<W>& x, const Path<W>& y,
                                const std::vector<double>& numbers, double step) const {
    const std::vector<int> moved = moved_vertices(x, y, not_specular);
    const auto n = static_cast<Eigen::Index>(moved.size()) * across;
    Eigen::MatrixXd areas_by_numbers(n, n);
    double sides = 1;
    Eigen::Index column = 0;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (W::dimension == 2 && k % 2 == 1) {
        sides /= 2;
        continue;
      }
      if (column == n) return {};
      std::vector<double> more = numbers, less = numbers;
      more[k] += step;
      less[k] -= step;
      const auto ahead = move_by(space_, mutation, x, more),
                 behind = move_by(space_, mutation, x, less);
      if (!ahead || !behind || !alike(ahead->y, y) || !alike(behind->y, y)) return {};
      areas_by_numbers.col(column++) =
          (parameters(ahead->y, moved) - parameters(behind->y, moved)) / (2 * step);
    }
    if (column != n) return {};
    double measure = 1;
    for (const int i : moved) measure *= measure_at(y[i]);
    const double reached = sides / (std::abs(areas_by_numbers.determinant()) * measure);
    return reached * constraint(x, y, step);
  }

  // On the same surfaces, with the same events.
  static bool alike(const Path<W>& a, const Path<W>& b) {
    for (int i = 0; i < a.size(); ++i)
      if (a[i].place.shape != b[i].place.shape || a[i].event != b[i].event) return false;
    return true;
  }
  Eigen::VectorXd parameters(const Path<W>& y, const std::vector<int>& vertices) const {
    Eigen::VectorXd all(static_cast<Eigen::Index>(vertices.size()) * across);
    Eigen::Index k = 0;
    for (const int i : vertices)
      for (const double u : space_.end_parameter(y, i)) all[k++] = u;
    return all;
  }
  double measure_at(const Vertex<W>& v) const {
    if (space_.is_camera(v)) return 1 / space_.scene().camera()->lens_density();
    return visit_shape([](const auto& s) { return s.measure(); },
                       space_.scene().shape(v.place.shape));
  }

  Eigen::MatrixXd imbalance_by_area(const Path<W>& y, const std::vector<int>& specular,
                                    double step) const {
    const auto n = static_cast<Eigen::Index>(specular.size()) * across;
    Eigen::MatrixXd matrix(n, n);
    Eigen::Index column = 0;
    for (const int j : specular) {
      const double side = std::pow(measure_at(y[j]), 1.0 / across);
      for (std::size_t k = 0; k < across; ++k) {
        const Path<W> ahead = shifted(y, j, k, step), behind = shifted(y, j, k, -step);
        matrix.col(column++) =
            (imbalance(ahead, specular) - imbalance(behind, specular)) / (2 * step * side);
      }
    }
    return matrix;
  }
  Path<W> shifted(Path<W> y, int j, std::size_t k, double step) const {
    auto u = space_.end_parameter(y, j);
    u[k] += step;
    const auto point = visit_shape([&](const auto& s) { return s.sample(u); },
                                   space_.scene().shape(y[j].place.shape));
    y[j].place.position = point.position;
    y[j].place.normal = point.normal;
    return y;
  }
  Eigen::VectorXd imbalance(const Path<W>& y, const std::vector<int>& specular) const {
    Eigen::VectorXd all(static_cast<Eigen::Index>(specular.size()) * across);
    Eigen::Index row = 0;
    for (const int i : specular) {
      const Frame<W::dimension, double> frame{y[i].place.normal};
      typename W::Local sum(0);
      for (const int j : {i - 1, i + 1}) {
        const auto w = frame.to_local(glm::normalize(y[j].place.position - y[i].place.position));
        sum += index_at(y[i], w) * w;
      }
      for (int k = 0; k < across; ++k) all[row++] = sum[k];
    }
    return all;
  }
  double index_at(const Vertex<W>& v, typename W::Local w) const {
    if (v.event == Event::reflection) return 1;
    const auto& glass = std::get<Dielectric<W>>(*space_.scene().surface(v.place.shape).material);
    return W::Dimension::cosine(w) > 0 ? glass.exterior : glass.interior;
  }

  const Transport<W>& space_;
};

}  // namespace wander::test
