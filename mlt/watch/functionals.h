// Scalars of the states of chains, kept while the chains run, for the diagnostics.
//
// The memory of a chain is fixed: when it is full, every second draw is dropped, and from then on
// half as many are taken.  So the draws of a chain are its states after the steps 0, n, 2n, … with
// n a power of two, whatever the number of steps.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "core/path.h"
#include "mlt/watch/chains_record.h"
#include "mlt/watch/diagnostics.h"
#include "mlt/watch/statistics.h"

namespace wander {

inline constexpr std::array<std::string_view, 4> functional_names{"film", "log_f", "vertices",
                                                                  "specular"};
// Position on the film (of an image its first coordinate), log f, number of vertices, number of specular vertices; and of an
// image the second coordinate.
using Functionals = std::array<double, functional_names.size() + 1>;
inline constexpr std::size_t second_coordinate = functional_names.size();
// What is told of the second coordinate is told of the position.
constexpr std::string_view name_of_functional(std::size_t k) {
  return functional_names[k == second_coordinate ? 0 : k];
}

template <class Space>
Functionals functionals(const Space& space, const Path<typename Space::Universe>& x) {
  int specular = 0;
  for (int i = 0; i < x.size(); ++i) specular += is_specular(x[i].event) ? 1 : 0;
  const std::array<double, 2> film = film_position(space, x);
  return {film[0], x.contribution.log(), static_cast<double>(x.size()),
          static_cast<double>(specular), film[1]};
}

// The same of what stands for a state that is no path, with the logarithm of its target.
inline Functionals functionals(const Features& state, double log_target) {
  const int specular = state.path_class == other_class ? 0 : std::popcount(state.path_class) - 1;
  return {state.film[0], log_target, static_cast<double>(state.vertices),
          static_cast<double>(specular), state.film[1]};
}

// The draws of one chain.
class ThinnedDraws {
 public:
  static constexpr std::size_t capacity = 256;
  // Of each of so many chains of a group: of many a few draws tell as much as many of a few.
  static std::size_t capacity_of(std::size_t chains) {
    constexpr std::size_t fewest = 16, of_all = 2048;
    return std::bit_floor(std::clamp(of_all / std::max<std::size_t>(chains, 1), fewest, capacity));
  }

  explicit ThinnedDraws(std::size_t most = capacity) : most_(most) { draws_.reserve(most); }

  // Once after every step; make() gives the functionals of the state, if they are to be kept.
  template <class Make>
  void offer(Make&& make) {
    if ((steps_++ & (stride_ - 1)) == 0) keep(make());
  }
  std::uint64_t stride() const { return stride_; }
  std::size_t size() const { return draws_.size(); }
  const Functionals& operator[](std::size_t draw) const { return draws_[draw]; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(draws_, steps_, stride_);
  }

 private:
  void keep(const Functionals& draw) {
    draws_.push_back(draw);
    if (draws_.size() < most_) return;
    for (std::size_t i = 0; i < most_ / 2; ++i) draws_[i] = draws_[2 * i];
    draws_.resize(most_ / 2);
    stride_ *= 2;
  }

  std::size_t most_;  // a power of two
  std::vector<Functionals> draws_;
  std::uint64_t steps_ = 0, stride_ = 1;
};

// The draws of all chains of a run, at the stride of the coarsest and of the length of the
// shortest.
class ChainDraws {
 public:
  void add(const ThinnedDraws& chain) { chains_.push_back(chain); }
  // Of every `step` chains the first `count`.
  void add(const ChainDraws& others, std::size_t count, std::size_t step);

  std::size_t chains() const { return chains_.size(); }
  std::uint64_t stride() const;
  std::size_t length() const;  // draws of each
  Draws of(std::size_t functional) const;

 private:
  std::vector<ThinnedDraws> chains_;
};

// R̂ and the effective sample sizes of each functional, of a position those of the coordinate that is known worse;
// autocorrelation times in steps, which are not resolved below the stride.
ChainsRecord diagnostics(const ChainDraws& draws);

}  // namespace wander
