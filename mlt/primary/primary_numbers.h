// A point of primary sample space [Kelemen et al. 2002]: the uniform numbers u in [0,1)^m that a
// sampler turns into paths, each at a fixed coordinate, and which of them the sampler asked for.
// Measure: du.
//
// Every vertex owns as many coordinates as it could ever need, so that a small step that makes one
// vertex take more numbers, or fewer, leaves the numbers of all others where they were.
#pragma once

#include <algorithm>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <vector>

#include "core/random_place.h"

namespace wander {

// Memory is allocated once; clearing takes no time.
class PrimaryNumbers {
 public:
  explicit PrimaryNumbers(std::size_t coordinates) : slots_(coordinates) {}

  void clear() { ++round_; }
  bool holds(std::size_t k) const { return slots_[k].round == round_; }
  double operator[](std::size_t k) const { return slots_[k].value; }
  void set(std::size_t k, double u) { slots_[k] = {u, round_}; }
  std::size_t size() const { return slots_.size(); }
  bool is_empty() const {
    return std::ranges::none_of(slots_, [this](const Slot& slot) { return slot.round == round_; });
  }

  // What it holds, into numbers of the same size.
  template <class Archive>
  void save(Archive& archive) const {
    std::vector<std::uint32_t> places;
    std::vector<double> values;
    for (std::size_t k = 0; k < size(); ++k) {
      if (!holds(k)) continue;
      places.push_back(static_cast<std::uint32_t>(k));
      values.push_back((*this)[k]);
    }
    archive(places, values);
  }
  template <class Archive>
  void load(Archive& archive) {
    std::vector<std::uint32_t> places;
    std::vector<double> values;
    archive(places, values);
    clear();
    for (std::size_t i = 0; i < places.size(); ++i) set(places[i], values[i]);
  }

 private:
  struct Slot {
    double value = 0;
    std::uint64_t round = 0;  // in which it was set
  };
  std::vector<Slot> slots_;
  std::uint64_t round_ = 1;
};

// Which coordinates belong to which vertex, for walks of up to so many vertices.  Coordinate 0 is
// no vertex's: a sampler that chooses a technique does it there, before it seeks any place.
template <class W>
class PrimaryLayout {
 public:
  // A direction (D - 1), a lobe and the roulette; or a position (D - 1) and a light.
  static constexpr std::size_t stride = W::dimension + 1;

  explicit PrimaryLayout(int vertices) : vertices_(static_cast<std::size_t>(vertices)) {}

  // For both walks; for the ends of connections, too.
  std::size_t of_walks() const { return first({Subpath::light_end, 0}); }
  std::size_t of_samples() const { return first({Subpath::sensor_end, 0}) + vertices_ * stride; }

  std::size_t first(RandomPlace place) const {
    const auto subpath = static_cast<std::size_t>(place.subpath);
    return 1 + (subpath * vertices_ + static_cast<std::size_t>(place.vertex)) * stride;
  }

 private:
  std::size_t vertices_;
};

// A source of random numbers for a sampler: number(k) is what it finds at coordinate k.
template <class W, class Number>
class PrimarySource {
 public:
  PrimarySource(const PrimaryLayout<W>& layout, Number number)
      : layout_(layout), number_(std::move(number)) {}

  void seek(RandomPlace place) { next_ = layout_.first(place); }
  double uniform() { return number_(next_++); }
  int choose(int count) { return static_cast<int>(uniform() * count); }

 private:
  const PrimaryLayout<W>& layout_;
  Number number_;
  std::size_t next_ = 0;
};

}  // namespace wander
