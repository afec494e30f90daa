#include "mlt/watch/functionals.h"

#include <algorithm>
#include <functional>

#include "work/parallel.h"

namespace wander {

void ChainDraws::add(const ChainDraws& others, std::size_t count, std::size_t step) {
  for (std::size_t c = 0; c < others.chains_.size(); ++c)
    if (c % step < count) chains_.push_back(others.chains_[c]);
}

std::uint64_t ChainDraws::stride() const {
  std::uint64_t stride = 1;
  for (const ThinnedDraws& chain : chains_) stride = std::max(stride, chain.stride());
  return stride;
}

std::size_t ChainDraws::length() const {
  std::size_t length = chains_.empty() ? 0 : ThinnedDraws::capacity;
  const std::uint64_t stride = this->stride();
  for (const ThinnedDraws& chain : chains_) {
    const std::size_t every = stride / chain.stride();
    length = std::min(length, (chain.size() + every - 1) / every);
  }
  return length;
}

Draws ChainDraws::of(std::size_t functional) const {
  Draws draws{chains_.size(), length(), {}};
  const std::uint64_t stride = this->stride();
  draws.values.reserve(draws.chains * draws.length);
  for (const ThinnedDraws& chain : chains_) {
    const std::size_t every = stride / chain.stride();
    for (std::size_t i = 0; i < draws.length; ++i)
      draws.values.push_back(chain[i * every][functional]);
  }
  return draws;
}

ChainsRecord diagnostics(const ChainDraws& draws) {
  ChainsRecord record;
  record.stride = draws.stride();
  record.functionals.resize(functional_names.size());
  in_parallel(functional_names.size(), [&](std::size_t k) {
    const Draws of = draws.of(k);
    FunctionalRecord& f = record.functionals[k];
    f.name = functional_names[k];
    const std::array<std::function<void()>, 4> parts{
        [&] { f.r_hat = rank_r_hat(of); }, [&] { f.ess_bulk = ess_bulk(of); },
        [&] { f.ess_tail = ess_tail(of); },
        [&] { f.autocorrelation_time = autocorrelation_time(of) * double(record.stride); }};
    in_parallel(parts.size(), [&](std::size_t i) { parts[i](); });
  });
  record.draws = draws.length();
  return record;
}

}  // namespace wander
