// Light that is reflected again and again, on a mesh: the Neumann series of the radiosity equation
//   L_1 = source,   E_k = T L_k,   L_{k+1} = ρ/2 · E_k,
// with T the transport operator.  Order k is of paths of k + 1 vertices that end at a node.
#pragma once

#include <cstddef>
#include <vector>

#include "core/exact/radiosity_mesh.h"
#include "core/exact/radiosity_transport.h"

namespace wander::exact {

// The place of an unknown.
struct Node {
  std::size_t wall;
  Side side;
  double position, weight;  // on the wall; part of the wall's length
};

// In the order of the unknowns.
std::vector<Node> nodes_of(const RadiosityElements& elements);
// The Gauss points of a stretch of a wall.
std::vector<Node> nodes_on(std::size_t wall, Side side, const Stretch& stretch, std::size_t nodes);

Receiver receiver_at(const RadiosityScene& scene, const Node& node);

// What each node gathers; rows of walls that reflect nothing are empty.
std::vector<TransportRow> rows_of(const RadiosityScene& scene, const Transport& transport,
                                  const std::vector<Node>& nodes);

// What the light sources emit, per unknown.
std::vector<double> emission(const RadiosityScene& scene, const std::vector<Node>& nodes);

struct Series {
  std::vector<std::vector<double>> radiance, irradiance;  // [order - 1][unknown]
};

Series neumann_series(const RadiosityScene& scene, const std::vector<Node>& nodes,
                      const std::vector<TransportRow>& rows, std::vector<double> source);

}  // namespace wander::exact
