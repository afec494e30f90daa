// Sums of many terms that keep their last bits (Neumaier 1974).
#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace wander {

class Sum {
 public:
  void operator+=(double x) {
    const double t = total_ + x;
    lost_ += std::abs(total_) >= std::abs(x) ? (total_ - t) + x : (x - t) + total_;
    total_ = t;
  }
  void operator+=(const Sum& other) {
    *this += other.total_;
    *this += other.lost_;
  }
  double value() const { return total_ + lost_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(total_, lost_);
  }

 private:
  double total_ = 0, lost_ = 0;
};

// What each of them is.
inline std::vector<double> values(std::span<const Sum> sums) {
  std::vector<double> result;
  result.reserve(sums.size());
  for (const Sum& sum : sums) result.push_back(sum.value());
  return result;
}

}  // namespace wander
