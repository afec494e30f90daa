#include "mlt/watch/functionals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

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

namespace {

FunctionalRecord diagnostics(const Draws& draws, std::uint64_t stride) {
  FunctionalRecord f;
  const std::array<std::function<void()>, 4> parts{
      [&] { f.r_hat = rank_r_hat(draws); }, [&] { f.ess_bulk = ess_bulk(draws); },
      [&] { f.ess_tail = ess_tail(draws); },
      [&] { f.autocorrelation_time = autocorrelation_time(draws) * double(stride); }};
  in_parallel(parts.size(), [&](std::size_t i) { parts[i](); });
  return f;
}

// Of two coordinates each number of that which is known worse; what tells nothing is NaN, which fmax and fmin pass over.
FunctionalRecord worse(const FunctionalRecord& a, const FunctionalRecord& b) {
  return {.r_hat = std::fmax(a.r_hat, b.r_hat),
          .ess_bulk = std::fmin(a.ess_bulk, b.ess_bulk),
          .ess_tail = std::fmin(a.ess_tail, b.ess_tail),
          .autocorrelation_time = std::fmax(a.autocorrelation_time, b.autocorrelation_time)};
}

}  // namespace

ChainsRecord diagnostics(const ChainDraws& draws) {
  std::array<FunctionalRecord, std::tuple_size_v<Functionals>> all;
  in_parallel(all.size(),
              [&](std::size_t k) { all[k] = diagnostics(draws.of(k), draws.stride()); });
  all[0] = worse(all[0], all[second_coordinate]);
  ChainsRecord record{.draws = draws.length(), .stride = draws.stride()};
  for (std::size_t k = 0; k < functional_names.size(); ++k) {
    record.functionals.push_back(std::move(all[k]));
    record.functionals.back().name = functional_names[k];
  }
  return record;
}

}  // namespace wander
