// How far small moves go, chosen before a run.  One factor on all their scales is tried at several
// values, on short chains that are then thrown away, so that what is chosen does not know what it
// moves.  Afterwards it is fixed.
//
// What is asked of a kernel is how much its steps tell of the film.  Let e_i be what step i deposits, as
// shares of the bins, and D the mean of L steps of one chain, a window.  Windows differ by
//   R_L = E|D - E D|² = E|e - E e|² - 1/L² Σ_{i<k≤L} E|e_i - e_k|²:
// the kernel with the least R_L is the one with the largest expected squared jump [Pasarica and Gelman
// 2010] on the bins, over all lags below L.  L R_L / R_1 is τ as far as L steps show it.  A jump measured as
// a distance on the film would not do: moves as long as the film jump far, and seldom.  Steps are taken
// to cost the same: where more of them find light they cost more, by a sixth at the most that was seen.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wander {

// L.
inline constexpr std::uint64_t steps_of_window = 64;

// R_L of windows that are added one by one.
class WindowSpread {
 public:
  explicit WindowSpread(std::size_t bins) : sums_(bins) {}

  void add(std::span<const double> shares);
  // Of two windows or more; of fewer, infinity.
  double value() const;

 private:
  std::vector<double> sums_;
  double squares_ = 0, count_ = 0;
};

// A factor, and R_L of the chains that moved so.
struct TriedKernel {
  double factor = 1, spread = 0;

  bool operator==(const TriedKernel&) const = default;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(factor, spread);
  }
};

// What was chosen, and of what.
struct Adaptation {
  double kernel = 1;
  std::vector<TriedKernel> tried{};

  bool operator==(const Adaptation&) const = default;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(kernel, tried);
  }
};

// The factors that may be chosen are powers of four, from 1/16 to 64.
inline constexpr double ratio_of_kernels = 4, smallest_kernel = 1.0 / 16, largest_kernel = 64;

// Climbs from the usual factor to larger ones as long as each is better than the one before it, or if
// the first is not, to smaller ones.  Better is what lowers the spread by a tenth at least: where the
// chains cannot tell, the usual factor stays.
class KernelSearch {
 public:
  // The factor to be tried; none: the search is over.
  std::optional<double> next() const { return next_; }
  void tell(double spread);
  // As far as it has come.
  const Adaptation& found() const { return found_; }

 private:
  static constexpr double least_gain = 1.1;

  void go_on_from(double factor);

  Adaptation found_;
  double least_ = 0;  // spread, that of found_.kernel
  double ratio_ = ratio_of_kernels;
  std::optional<double> next_ = 1;
};

// The seed of the chains by which a run with this seed adapts.
std::uint64_t seed_of_adaptation(std::uint64_t seed);

}  // namespace wander
