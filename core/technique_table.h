// A number for each technique (s, n - s) of short paths.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace wander {

// Rows of n = 2 … most vertices hold s = 0 … n; longer paths have none, so that memory stays small.
class TechniqueTable {
 public:
  static constexpr int most_vertices = 32;

  // For paths of up to `longest` vertices.
  explicit TechniqueTable(int longest)
      : most_(std::min(longest, most_vertices)),
        values_(static_cast<std::size_t>(begin(most_ + 1))) {}

  bool has(int n) const { return n <= most_; }
  int most() const { return most_; }
  std::span<double> row(int n) { return std::span(values_).subspan(offset(n), width(n)); }
  std::span<const double> row(int n) const {
    return std::span(values_).subspan(offset(n), width(n));
  }
  std::span<double> values() { return values_; }
  std::span<const double> values() const { return values_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(most_, values_);
  }

 private:
  static int begin(int n) { return n * (n + 1) / 2 - 3; }  // Σ_{k=2}^{n-1} (k + 1)
  static std::size_t offset(int n) { return static_cast<std::size_t>(begin(n)); }
  static std::size_t width(int n) { return static_cast<std::size_t>(n) + 1; }

  int most_;
  std::vector<double> values_;
};

}  // namespace wander
