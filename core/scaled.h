// Products of many contributions and densities: a mantissa and an integer exponent.
//
// Nothing underflows on long paths, and a scene multiplied by a power of two leaves every mantissa,
// hence every decision and every bit of a film, as it was; a logarithm would spoil both.  Multiply
// plain doubles within a vertex, and `Scaled` once per vertex.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace wander {

class Scaled {
 public:
  constexpr Scaled() = default;
  constexpr Scaled(double value) : mantissa_(value) { normalize(); }

  static constexpr Scaled of(double mantissa, std::int64_t exponent) {
    Scaled s(mantissa);
    if (s.mantissa_ != 0) s.exponent_ += exponent;
    return s;
  }

  double mantissa() const { return mantissa_; }  // 0, or ±[1, 2), or not finite
  std::int64_t exponent() const { return exponent_; }
  bool is_zero() const { return mantissa_ == 0; }
  bool is_finite() const { return std::isfinite(mantissa_); }
  bool is_positive() const { return mantissa_ > 0 && is_finite(); }

  // The nearest double; 0 or infinity beyond its range.
  double value() const {
    if (exponent_ > -1000 && exponent_ < 1000) return mantissa_ * power_of_two(exponent_);
    if (exponent_ > 4000) return mantissa_ == 0 ? 0 : mantissa_ * infinity();
    if (exponent_ < -4000) return 0 * mantissa_;
    return std::ldexp(mantissa_, static_cast<int>(exponent_));
  }
  double log() const {
    return std::log(mantissa_) + static_cast<double>(exponent_) * 0x1.62e42fefa39efp-1;
  }

  Scaled& operator*=(Scaled other) {
    mantissa_ *= other.mantissa_;
    exponent_ += other.exponent_;
    normalize();
    return *this;
  }
  Scaled& operator/=(Scaled other) {
    mantissa_ /= other.mantissa_;
    exponent_ -= other.exponent_;
    normalize();
    return *this;
  }
  Scaled& operator+=(Scaled other) { return *this = *this + other; }
  friend Scaled operator*(Scaled a, Scaled b) { return a *= b; }
  friend Scaled operator/(Scaled a, Scaled b) { return a /= b; }
  friend Scaled operator+(Scaled a, Scaled b) {
    if (!a.is_finite() || !b.is_finite()) return Scaled(a.mantissa_ + b.mantissa_);
    if (a.mantissa_ == 0) return b;
    if (b.mantissa_ == 0) return a;
    if (a.exponent_ < b.exponent_) std::swap(a, b);
    const std::int64_t shift = a.exponent_ - b.exponent_;
    if (shift < 128) a.mantissa_ += b.mantissa_ * power_of_two(-shift);
    a.normalize();
    return a;
  }
  friend bool operator==(Scaled a, Scaled b) = default;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(mantissa_, exponent_);
  }

 private:
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }
  static constexpr double power_of_two(std::int64_t e) {  // -1022 <= e <= 1023
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  }

  // Moves the exponent field of the mantissa into `exponent_`.
  constexpr void normalize() {
    const auto bits = std::bit_cast<std::uint64_t>(mantissa_);
    const auto field = static_cast<std::int64_t>((bits >> 52) & 0x7ff);
    if (field == 0x7ff) return;  // infinity and NaN stay what they are
    if (field == 0) {
      if (mantissa_ == 0) {
        exponent_ = 0;
        return;
      }
      mantissa_ *= 0x1p64;  // a denormal number
      exponent_ -= 64;
      normalize();
      return;
    }
    exponent_ += field - 1023;
    mantissa_ =
        std::bit_cast<double>((bits & ~(std::uint64_t{0x7ff} << 52)) | (std::uint64_t{1023} << 52));
  }

  double mantissa_ = 0;
  std::int64_t exponent_ = 0;
};

}  // namespace wander
