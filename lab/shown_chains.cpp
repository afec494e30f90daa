#include "lab/shown_chains.h"

namespace wander {

std::vector<ChainPlace> order_of_chains(const std::vector<std::vector<ChainPlace>>& by_stratum,
                                        const std::vector<double>& light) {
  std::size_t chains = 0;
  for (const auto& stratum : by_stratum) chains += stratum.size();
  std::vector<std::size_t> taken(by_stratum.size());
  const auto next_stratum = [&] {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t s = 0; s < by_stratum.size(); ++s) {
      const double claim = light[s] / static_cast<double>(2 * taken[s] + 1);
      if (taken[s] == by_stratum[s].size() || claim <= most) continue;
      most = claim;
      best = s;
    }
    return best;
  };
  std::vector<ChainPlace> order;
  while (order.size() < chains) {
    const std::size_t s = next_stratum();
    order.push_back(by_stratum[s][taken[s]++]);
  }
  return order;
}

}  // namespace wander
