// Random numbers: Philox4x32-10 (Salmon et al. 2011), counter-based.
//
// A number is a function of (seed, purpose, stream, step, draw) and of nothing else: streams are
// independent of threads and of the scene, and any step can be drawn again.  Numbers are uniform in
// [0, 1) with 53 bits; 1 never occurs.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace wander {

// What a stream is for; streams of different purposes never share a number.
enum class Purpose : std::uint32_t {
  estimate,
  seed_pass,
  resample,
  chain,
  test,
  lengths,
  test_image
};

std::array<std::uint32_t, 4> inline philox(std::array<std::uint32_t, 4> counter,
                                           std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {
        static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
        static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key = {key[0] + 0x9E3779B9, key[1] + 0xBB67AE85};
  }
  return counter;
}

class Rng {
 public:
  Rng(std::uint64_t seed, Purpose purpose, std::uint32_t stream)
      : key_(mix(seed, static_cast<std::uint32_t>(purpose))), counter_{0, 0, 0, stream} {}

  // Starts the numbers of one step, from its first draw.
  void start(std::uint64_t step) {
    counter_[0] = 0;
    counter_[1] = static_cast<std::uint32_t>(step);
    counter_[2] = static_cast<std::uint32_t>(step >> 32);
    left_ = 0;
  }

  double uniform() {
    if (left_ == 0) refill();
    return numbers_[--left_];
  }

  // One of `count` indices, each with the same probability.
  int choose(int count) { return static_cast<int>(uniform() * count); }

  // Index i with probability pmf[i]; the pmf sums to 1.  Entries of probability zero never occur.
  int choose(std::span<const double> pmf) {
    double u = uniform();
    int last = 0;
    for (int i = 0; i < static_cast<int>(pmf.size()); ++i) {
      const double p = pmf[static_cast<std::size_t>(i)];
      if (p <= 0) continue;
      if (u < p) return i;
      u -= p;
      last = i;
    }
    return last;
  }

 private:
  static std::array<std::uint32_t, 2> mix(std::uint64_t seed, std::uint32_t purpose) {
    std::uint64_t z = seed + 0x9E3779B97F4A7C15 * (purpose + std::uint64_t{1});  // splitmix64
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    z ^= z >> 31;
    return {static_cast<std::uint32_t>(z), static_cast<std::uint32_t>(z >> 32)};
  }
  static double to_unit(std::uint32_t high, std::uint32_t low) {
    const std::uint64_t bits = (std::uint64_t{high} << 32) | low;
    return static_cast<double>(bits >> 11) * 0x1p-53;
  }
  // Two blocks at once, whose rounds the processor does side by side.
  void refill() {
    auto next = counter_;
    ++next[0];
    const auto first = philox(counter_, key_), second = philox(next, key_);
    counter_[0] += 2;
    numbers_ = {to_unit(second[2], second[3]), to_unit(second[0], second[1]),
                to_unit(first[2], first[3]), to_unit(first[0], first[1])};
    left_ = 4;
  }

  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::array<double, 4> numbers_{};  // the next one last
  int left_ = 0;
};

}  // namespace wander
