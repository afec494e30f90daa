#include "mlt/functionals.h"

#include <algorithm>

namespace wander {

std::uint64_t ChainDraws::stride() const {
  std::uint64_t stride = 1;
  for (const ThinnedDraws* chain : chains_) stride = std::max(stride, chain->stride());
  return stride;
}

Draws ChainDraws::of(std::size_t functional) const {
  Draws draws{chains_.size(), chains_.empty() ? 0 : ThinnedDraws::capacity, {}};
  const std::uint64_t stride = this->stride();
  for (const ThinnedDraws* chain : chains_) {
    const std::size_t every = stride / chain->stride();
    draws.length = std::min(draws.length, (chain->size() + every - 1) / every);
  }
  draws.values.reserve(draws.chains * draws.length);
  for (const ThinnedDraws* chain : chains_) {
    const std::size_t every = stride / chain->stride();
    for (std::size_t i = 0; i < draws.length; ++i)
      draws.values.push_back((*chain)[i * every][functional]);
  }
  return draws;
}

ChainsRecord diagnostics(const ChainDraws& draws) {
  ChainsRecord record;
  record.stride = draws.stride();
  for (std::size_t k = 0; k < functional_names.size(); ++k) {
    const Draws of = draws.of(k);
    record.draws = of.length;
    record.functionals.push_back({std::string(functional_names[k]), rank_r_hat(of), ess_bulk(of),
                                  ess_tail(of),
                                  autocorrelation_time(of) * static_cast<double>(record.stride)});
  }
  return record;
}

}  // namespace wander
