#include "core/exact/radiosity_transport.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/exact/gauss.h"

namespace wander::exact {

namespace {

// Points of the rule on a piece no longer than its distance: the nearest singularity of 1/r then
// lies on a Bernstein ellipse of 2 + √5, and the error is below (2 + √5)^-20 = 3e-13.
constexpr std::size_t piece_points = 10;

// 1 / Π_{b≠a} (t_a - t_b).
std::vector<double> lagrange_scale(const std::vector<double>& nodes) {
  std::vector<double> scale(nodes.size(), 1.0);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = 0; b < nodes.size(); ++b)
      if (a != b) scale[a] /= nodes[a] - nodes[b];
  return scale;
}

struct Basis {
  std::vector<double> nodes, scale;
};

// Without a lock, unlike gauss_rule().
const Basis& basis_of(std::size_t nodes) {
  thread_local std::vector<Basis> known;
  if (known.size() <= nodes) known.resize(nodes + 1);
  if (known[nodes].nodes.empty())
    known[nodes] = {gauss_rule(nodes).nodes, lagrange_scale(gauss_rule(nodes).nodes)};
  return known[nodes];
}

// sin of the angle between the receiver's normal and the direction to p; rises to the right.
double sine_towards(const Receiver& receiver, PlanePoint p) {
  const PlanePoint d = p - receiver.position;
  return -cross(receiver.normal, d) / length(d);
}

// A receiver and the element whose row entries it adds to.
struct Coupling {
  const Receiver& receiver;
  const PlaneSegment& wall;
  const Element& element;
  double* entries;
};

// ∫ over the piece, which is no longer than its distance.
void add_near_rule(const Coupling& c, Stretch piece) {
  const PlaneSegment ends{c.wall.at(piece.from), c.wall.at(piece.to)};
  // cos θy / r = |(y - x) × (to - from)| / |to - from| / r²; the numerator is the same for all y.
  const double offset = std::abs(cross(ends.from - c.receiver.position, ends.to - ends.from));
  const GaussRule& rule = gauss_rule(piece_points);
  const double stretch = c.element.stretch.to - c.element.stretch.from;
  for (std::size_t q = 0; q < piece_points; ++q) {
    const PlanePoint d = ends.at(rule.nodes[q]) - c.receiver.position;
    const double r2 = dot(d, d);
    const double cosine = std::max(0.0, dot(c.receiver.normal, d));  // times r
    const double g = cosine * offset / (r2 * std::sqrt(r2));         // times |to - from| from dl
    const double position = std::lerp(piece.from, piece.to, rule.nodes[q]);
    const double t = (position - c.element.stretch.from) / stretch;
    add_lagrange(c.entries, c.element.nodes, t, rule.weights[q] * g);
  }
}

void add_piece(const Coupling& c, Stretch piece) {
  const PlaneSegment ends{c.wall.at(piece.from), c.wall.at(piece.to)};
  const double middle = std::midpoint(piece.from, piece.to);
  const bool divisible = middle > piece.from && middle < piece.to;
  if (divisible && length(ends) > distance(c.receiver.position, ends)) {
    add_piece(c, {piece.from, middle});
    add_piece(c, {middle, piece.to});
  } else if (divisible) {
    add_near_rule(c, piece);
  }
}

void add_part(const Coupling& c, Stretch part) {
  if (c.element.nodes > 1) {
    add_piece(c, part);
    return;
  }
  // A constant radiance: E = L |sin θ2 - sin θ1|.
  *c.entries += std::abs(sine_towards(c.receiver, c.wall.at(part.to)) -
                         sine_towards(c.receiver, c.wall.at(part.from)));
}

}  // namespace

// By products of differences.
void add_lagrange(double* entries, std::size_t nodes, double t, double weight) {
  const auto& [at, scale] = basis_of(nodes);
  double before = weight;
  for (std::size_t a = 0; a < nodes; ++a) {
    double product = before * scale[a];
    for (std::size_t b = a + 1; b < nodes; ++b) product *= t - at[b];
    entries[a] += product;
    before *= t - at[a];
  }
}

double TransportRow::irradiance(const std::vector<double>& radiance) const {
  double sum = 0;
  const double* weight = weights_.data();
  for (const Block& block : blocks_)
    for (std::size_t a = 0; a < block.nodes; ++a) sum += *weight++ * radiance[block.first + a];
  return sum;
}

double* TransportRow::append(const Element& element) {
  blocks_.push_back({element.first, element.nodes});
  weights_.resize(weights_.size() + element.nodes, 0.0);
  return weights_.data() + (weights_.size() - element.nodes);
}

TransportRow Transport::row(const Receiver& receiver) const {
  TransportRow result;
  for (const VisibleInterval& visible : visibility_.from(receiver)) {
    const auto [low, high] = std::minmax(visible.at_from, visible.at_to);
    const Wall& wall = scene_.walls[visible.segment];
    const PlaneSegment line{wall.from, wall.to};
    const std::vector<Element>& row = elements_.of(visible.segment, visible.side);
    auto element = std::partition_point(
        row.begin(), row.end(), [low = low](const Element& e) { return e.stretch.to <= low; });
    for (; element != row.end() && element->stretch.from < high; ++element) {
      const Stretch part{std::max(low, element->stretch.from), std::min(high, element->stretch.to)};
      add_part({receiver, line, *element, result.append(*element)}, part);
    }
  }
  return result;
}

}  // namespace wander::exact
