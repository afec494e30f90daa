// Which dials there are (dials.h says what each does), and sets of them.
#pragma once

#include <initializer_list>

namespace wander {

enum class DialId {
  mutations,
  estimator,
  max_vertices,
  chains,
  seed_share,
  film,
  target,
  normalization,
  precision,
  large_step,
  kernel,
  by_length,
  maps
};

class DialSet {
 public:
  constexpr DialSet(std::initializer_list<DialId> dials) {
    for (const DialId dial : dials) bits_ |= bit(dial);
  }
  constexpr DialSet operator|(DialSet other) const {
    other.bits_ |= bits_;
    return other;
  }
  constexpr bool has(DialId dial) const { return (bits_ & bit(dial)) != 0; }

 private:
  static constexpr unsigned bit(DialId dial) { return 1U << static_cast<unsigned>(dial); }

  unsigned bits_ = 0;
};

}  // namespace wander
