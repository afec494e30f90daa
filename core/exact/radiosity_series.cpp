#include "core/exact/radiosity_series.h"

#include <cmath>
#include <utility>

#include "core/exact/gauss.h"

namespace wander::exact {

std::vector<Node> nodes_on(std::size_t wall, Side side, const Stretch& stretch, std::size_t nodes) {
  std::vector<Node> result;
  const GaussRule& rule = gauss_rule(nodes);
  for (std::size_t a = 0; a < nodes; ++a)
    result.push_back({wall, side, std::lerp(stretch.from, stretch.to, rule.nodes[a]),
                      rule.weights[a] * (stretch.to - stretch.from)});
  return result;
}

std::vector<Node> nodes_of(const RadiosityElements& elements) {
  std::vector<Node> nodes;
  for (std::size_t w = 0; w < elements.sides.size(); ++w)
    for (const Side side : {Side::front, Side::back})
      for (const Element& element : elements.of(w, side)) {
        const std::vector<Node> own = nodes_on(w, side, element.stretch, element.nodes);
        nodes.insert(nodes.end(), own.begin(), own.end());
      }
  return nodes;
}

Receiver receiver_at(const RadiosityScene& scene, const Node& node) {
  const PlaneSegment line{scene.walls[node.wall].from, scene.walls[node.wall].to};
  return {line.at(node.position), sign_of(node.side) * normal(line)};
}

std::vector<TransportRow> rows_of(const RadiosityScene& scene, const Transport& transport,
                                  const std::vector<Node>& nodes) {
  std::vector<TransportRow> rows;
  for (const Node& node : nodes) {
    const bool reflects = scene.walls[node.wall].reflectance > 0;
    rows.push_back(reflects ? transport.row(receiver_at(scene, node)) : TransportRow{});
  }
  return rows;
}

std::vector<double> emission(const RadiosityScene& scene, const std::vector<Node>& nodes) {
  std::vector<double> radiance;
  for (const Node& node : nodes)
    radiance.push_back(node.side == Side::front ? scene.walls[node.wall].radiance : 0);
  return radiance;
}

Series neumann_series(const RadiosityScene& scene, const std::vector<Node>& nodes,
                      const std::vector<TransportRow>& rows, std::vector<double> source) {
  Series series;
  std::vector<double> radiance = std::move(source);
  for (int vertices = 2; vertices <= scene.max_vertices; ++vertices) {
    std::vector<double> irradiance(nodes.size()), next(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      irradiance[i] = rows[i].irradiance(radiance);
      next[i] = 0.5 * scene.walls[nodes[i].wall].reflectance * irradiance[i];
    }
    series.radiance.push_back(std::exchange(radiance, std::move(next)));
    series.irradiance.push_back(std::move(irradiance));
  }
  return series;
}

}  // namespace wander::exact
