// How the ratio l = f / p̄ of paths is distributed, in memory that does not grow with their number.
//
// Bins are 1/32 of an octave wide, cut out of the bits of the double: a factor of 2^k shifts them
// and changes nothing else.  A bin keeps its count and Σ l, so that a smooth function of l is
// summed with a relative error of the second order in the width of a bin, below 1e-5.
#pragma once

#include <algorithm>
#include <bit>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <vector>

namespace wander {

class RatioHistogram {
 public:
  static constexpr int bits_per_octave = 5;

  struct Bin {
    double count = 0, sum = 0;  // of l
  };

  // A positive number; the histogram grows to hold it.
  void add(double ratio, double weight = 1) {
    const int i = index_of(ratio);
    if (i < first_ || i >= end()) [[unlikely]]
      grow_to(i);
    put(i, ratio, weight);
  }

  // Room for what another histogram holds, and for so many octaves on either side.
  void make_room(const RatioHistogram& other, int octaves) {
    if (other.bins_.empty()) return;
    const int margin = octaves << bits_per_octave;
    first_ = std::max(0, other.first_ - margin);
    bins_.assign(static_cast<std::size_t>(other.end() + margin - first_), Bin{});
  }
  // Without growing: what is beyond the room goes to its edge.
  void add_within(double ratio, double weight = 1) {
    if (bins_.empty()) return;
    put(std::clamp(index_of(ratio), first_, end() - 1), ratio, weight);
  }

  void add(const RatioHistogram& other, double weight) {
    if (other.bins_.empty()) return;
    const int low = bins_.empty() ? other.first_ : std::min(first_, other.first_);
    const int high = bins_.empty() ? other.end() : std::max(end(), other.end());
    std::vector<Bin> bins(static_cast<std::size_t>(high - low));
    std::ranges::copy(bins_, bins.begin() + (bins_.empty() ? 0 : first_ - low));
    bins_ = std::move(bins);
    first_ = low;
    for (int i = other.first_; i < other.end(); ++i) {
      bins_[static_cast<std::size_t>(i - first_)].count += weight * other[i].count;
      bins_[static_cast<std::size_t>(i - first_)].sum += weight * other[i].sum;
    }
  }

  // All but the largest, or one of the last bin's.
  RatioHistogram without_largest() const {
    RatioHistogram rest = *this;
    while (!rest.bins_.empty() && !(rest.bins_.back().count > 0)) rest.bins_.pop_back();
    if (rest.bins_.empty()) return rest;
    Bin& last = rest.bins_.back();
    const double left = std::max(0.0, 1 - 1 / last.count);
    last = {left * last.count, left * last.sum};
    return rest;
  }

  // Bins are numbered alike in all histograms: first() ≤ i < end().
  int first() const { return first_; }
  int end() const { return first_ + static_cast<int>(bins_.size()); }
  // Empty beyond the ends.
  Bin operator[](int i) const {
    return i < first_ || i >= end() ? Bin{} : bins_[static_cast<std::size_t>(i - first_)];
  }
  static double middle(int i) {
    return std::bit_cast<double>((2 * static_cast<std::uint64_t>(i) + 1) << (51 - bits_per_octave));
  }
  double count() const {
    double sum = 0;
    for (const Bin& bin : bins_) sum += bin.count;
    return sum;
  }

  // Of a run with long paths there are tens of thousands, with few bins that hold anything.
  template <class Archive>
  void save(Archive& archive) const {
    std::vector<std::uint32_t> places;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      if (bins_[i].count == 0) continue;
      places.push_back(static_cast<std::uint32_t>(i));
      numbers.insert(numbers.end(), {bins_[i].count, bins_[i].sum});
    }
    archive(first_, bins_.size(), places, numbers);
  }
  template <class Archive>
  void load(Archive& archive) {
    std::size_t size = 0;
    std::vector<std::uint32_t> places;
    std::vector<double> numbers;
    archive(first_, size, places, numbers);
    bins_.assign(size, Bin{});
    for (std::size_t i = 0; i < places.size(); ++i)
      bins_[places[i]] = {numbers[2 * i], numbers[2 * i + 1]};
  }

 private:
  static int index_of(double ratio) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(ratio) >> (52 - bits_per_octave));
  }
  [[gnu::cold]] void grow_to(int i) {
    if (bins_.empty()) first_ = i;
    if (i < first_) {
      bins_.insert(bins_.begin(), static_cast<std::size_t>(first_ - i), Bin{});
      first_ = i;
    }
    if (i >= end()) bins_.resize(static_cast<std::size_t>(i - first_) + 1);
  }
  void put(int i, double ratio, double weight) {
    Bin& bin = bins_[static_cast<std::size_t>(i - first_)];
    bin.count += weight;
    bin.sum += weight * ratio;
  }

  int first_ = 0;
  std::vector<Bin> bins_;
};

}  // namespace wander
