// The discrete transport operator of the radiosity solver: rows are receivers, columns the unknown
// radiances of a mesh, entries ∫ ℓ(y) V cos θx cos θy / r dl(y) with ℓ the Lagrange polynomial of
// the column's node.
#pragma once

#include <cstddef>
#include <vector>

#include "core/exact/radiosity_mesh.h"
#include "core/exact/visibility.h"

namespace wander::exact {

// entries[a] += weight · ℓ_a(t), for the Lagrange polynomials ℓ of the Gauss points in [0, 1].
void add_lagrange(double* entries, std::size_t nodes, double t, double weight);

// One receiver's row: what it gathers of each unknown.
class TransportRow {
 public:
  // The irradiance due to these radiances.
  double irradiance(const std::vector<double>& radiance) const;

  // Room for the entries of one more element, all zero; valid until the next call.
  double* append(const Element& element);

 private:
  struct Block {
    std::size_t first, nodes;  // columns
  };
  std::vector<Block> blocks_;
  std::vector<double> weights_;  // of the blocks, one after the other
};

class Transport {
 public:
  Transport(const RadiosityScene& scene, const Visibility& visibility,
            const RadiosityElements& elements)
      : scene_(scene), visibility_(visibility), elements_(elements) {}

  TransportRow row(const Receiver& receiver) const;

 private:
  const RadiosityScene& scene_;
  const Visibility& visibility_;
  const RadiosityElements& elements_;
};

}  // namespace wander::exact
