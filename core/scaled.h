// Products of many contributions and densities: a mantissa and an integer exponent.
//
// Nothing underflows on long paths, and a scene multiplied by a power of two leaves every mantissa,
// hence every decision and every bit of a film, as it was; a logarithm would spoil both.
//
// A product costs little more than one of plain doubles: the exponent is touched only when the
// mantissa leaves a wide range, within which no product is rounded otherwise than in [1, 2).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace wander {

class Scaled {
 public:
  constexpr Scaled() = default;
  constexpr Scaled(double value) : mantissa_(value) { keep_in_range(); }

  static constexpr Scaled of(double mantissa, std::int64_t exponent) {
    Scaled s(mantissa);
    if (s.mantissa_ != 0) s.exponent_ += exponent;
    return s;
  }

  double mantissa() const { return normalized().mantissa_; }  // 0, or ±[1, 2), or not finite
  std::int64_t exponent() const { return normalized().exponent_; }
  bool is_zero() const { return mantissa_ == 0; }
  bool is_finite() const { return std::isfinite(mantissa_); }
  bool is_positive() const { return mantissa_ > 0 && is_finite(); }

  // The nearest double; 0 or infinity beyond its range.
  double value() const {
    if (exponent_ == 0) return mantissa_;
    const Scaled s = normalized();
    if (s.exponent_ > -1000 && s.exponent_ < 1000) return s.mantissa_ * power_of_two(s.exponent_);
    if (s.exponent_ > 4000) return s.mantissa_ == 0 ? 0 : s.mantissa_ * infinity();
    if (s.exponent_ < -4000) return 0 * s.mantissa_;
    return std::ldexp(s.mantissa_, static_cast<int>(s.exponent_));
  }
  double log() const {
    const Scaled s = normalized();
    return std::log(s.mantissa_) + static_cast<double>(s.exponent_) * 0x1.62e42fefa39efp-1;
  }

  Scaled& operator*=(Scaled other) {
    mantissa_ *= other.mantissa_;
    exponent_ += other.exponent_;
    keep_in_range();
    return *this;
  }
  Scaled& operator/=(Scaled other) {
    mantissa_ /= other.mantissa_;
    exponent_ -= other.exponent_;
    keep_in_range();
    return *this;
  }
  Scaled& operator+=(Scaled other) { return *this = *this + other; }
  friend Scaled operator*(Scaled a, Scaled b) { return a *= b; }
  friend Scaled operator/(Scaled a, Scaled b) { return a /= b; }
  friend Scaled operator+(Scaled a, Scaled b) {
    if (a.exponent_ != b.exponent_) return sum_of_normalized(a.normalized(), b.normalized());
    a.mantissa_ += b.mantissa_;
    a.keep_in_range();
    return a;
  }
  friend bool operator==(Scaled a, Scaled b) {
    return a.mantissa() == b.mantissa() && a.exponent() == b.exponent();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    *this = normalized();
    archive(mantissa_, exponent_);
  }

 private:
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }
  static constexpr double power_of_two(std::int64_t e) {  // -1022 <= e <= 1023
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  }
  static constexpr std::int64_t exponent_field(double x) {
    return static_cast<std::int64_t>((std::bit_cast<std::uint64_t>(x) >> 52) & 0x7ff);
  }

  // Of a mantissa, as a power of two either way: two of them have a product and a quotient.
  static constexpr std::int64_t range = 256;

  constexpr void keep_in_range() {
    const std::int64_t e = exponent_field(mantissa_) - 1023;
    if (e < -range || e > range) [[unlikely]]
      *this = normalized();
  }

  // The same number, with the exponent field of the mantissa moved into the exponent.
  constexpr Scaled normalized() const {
    Scaled s = *this;
    std::int64_t field = exponent_field(s.mantissa_);
    if (field == 0x7ff) return s;  // infinity and NaN stay what they are
    if (s.mantissa_ == 0) {
      s.exponent_ = 0;
      return s;
    }
    if (field == 0) {
      s.mantissa_ *= 0x1p64;  // a denormal number
      s.exponent_ -= 64;
      field = exponent_field(s.mantissa_);
    }
    s.exponent_ += field - 1023;
    s.mantissa_ = std::bit_cast<double>(
        (std::bit_cast<std::uint64_t>(s.mantissa_) & ~(std::uint64_t{0x7ff} << 52)) |
        (std::uint64_t{1023} << 52));
    return s;
  }

  static Scaled sum_of_normalized(Scaled a, Scaled b) {
    if (!a.is_finite() || !b.is_finite()) return Scaled(a.mantissa_ + b.mantissa_);
    if (a.mantissa_ == 0) return b;
    if (b.mantissa_ == 0) return a;
    if (a.exponent_ < b.exponent_) std::swap(a, b);
    const std::int64_t shift = a.exponent_ - b.exponent_;
    if (shift < 128) a.mantissa_ += b.mantissa_ * power_of_two(-shift);
    a.keep_in_range();
    return a;
  }

  double mantissa_ = 0;
  std::int64_t exponent_ = 0;
};

}  // namespace wander
