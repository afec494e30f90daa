// How many vertices the bidirectional mutation deletes and adds [Veach 1997, 11.4], as tables: a
// mutation asks six times.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace wander {

// No more vertices than this are deleted or added at once.
inline constexpr int most_replaced = 16;

// A pmf over 0 … most_replaced.
struct LengthPmf {
  std::array<double, most_replaced + 1> p{};
  std::span<const double> span() const { return p; }
  double operator[](int k) const { return k <= most_replaced ? p[static_cast<std::size_t>(k)] : 0; }

  // Weights of the numbers least … most; if there is none, no number has a probability.
  template <class Weight>
  static constexpr LengthPmf of(int least, int most, Weight weight) {
    LengthPmf pmf;
    double total = 0;
    for (int k = least; k <= most; ++k) total += pmf.p[static_cast<std::size_t>(k)] = weight(k);
    if (total > 0)
      for (double& q : pmf.p) q /= total;
    return pmf;
  }
};

class LengthPmfs {
 public:
  constexpr LengthPmfs() {
    for (int n = 0; n <= most_replaced; ++n) {
      deletion_[index(n)] = LengthPmf::of(0, n, deletion_weight);
      for (int least = 0; least < ends; ++least)
        for (int deleted = 0; deleted <= most_replaced; ++deleted)
          addition_[index(least)][index(n)][index(deleted)] = LengthPmf::of(
              least, n, [deleted](int added) { return addition_weight(added - deleted); });
    }
  }

  // How many of n vertices are deleted.
  constexpr const LengthPmf& deletion(int n) const {
    return deletion_[index(n < most_replaced ? n : most_replaced)];
  }
  // How many are added, least … most, where so many were deleted.
  constexpr const LengthPmf& addition(int least, int most, int deleted) const {
    return addition_[index(least)][index(most < most_replaced ? most : most_replaced)]
                    [index(deleted)];
  }

 private:
  static constexpr int ends = 3;  // 0, 1 or 2 ends of the path must be added
  static constexpr std::size_t index(int k) { return static_cast<std::size_t>(k); }
  static constexpr double halved(double q, int times) {
    for (; times > 0; --times) q /= 2;
    return q;
  }

  // 1/4 for none, 1/2 for one, then halving, where what can be deleted makes the sum 1.
  static constexpr double deletion_weight(int d) { return d == 0 ? 0.25 : halved(1, d); }
  // 1/2 for as many as were deleted, 0.15 for one more or less, then 0.2 / 2^j.
  static constexpr double addition_weight(int difference) {
    const int j = difference < 0 ? -difference : difference;
    return j == 0 ? 0.5 : j == 1 ? 0.15 : halved(0.2, j);
  }

  std::array<LengthPmf, most_replaced + 1> deletion_{};
  std::array<std::array<std::array<LengthPmf, most_replaced + 1>, most_replaced + 1>, ends>
      addition_{};
};

inline constexpr LengthPmfs length_pmfs;

}  // namespace wander
