// Numbers of the program as arrays of NumPy, without a copy: what holds them lives as long as an
// array does.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <memory>
#include <span>
#include <vector>

namespace wander::python {

using Array = nanobind::ndarray<nanobind::numpy, const double>;
using Flags = nanobind::ndarray<nanobind::numpy, bool>;

template <class Owner>
nanobind::capsule kept_alive(std::shared_ptr<const Owner> owner) {
  using Kept = std::shared_ptr<const Owner>;
  return {new Kept(std::move(owner)), [](void* kept) noexcept { delete static_cast<Kept*>(kept); }};
}

inline std::vector<std::size_t> extents(std::span<const int> shape) {
  return {shape.begin(), shape.end()};
}

// Of a part of what `owner` holds.
template <class Owner>
Array array_of(std::span<const double> numbers, std::span<const int> shape,
               const std::shared_ptr<const Owner>& owner) {
  const std::vector<std::size_t> sizes = extents(shape);
  return {numbers.data(), sizes.size(), sizes.data(), kept_alive(owner)};
}

// Bits are packed in C++, so these are copied.
inline Flags flags_of(const std::vector<bool>& bits, std::span<const int> shape) {
  auto bytes = std::make_shared<std::unique_ptr<bool[]>>(std::make_unique<bool[]>(bits.size()));
  for (std::size_t i = 0; i < bits.size(); ++i) (*bytes)[i] = bits[i];
  const std::vector<std::size_t> sizes = extents(shape);
  return {bytes->get(), sizes.size(), sizes.data(),
          kept_alive<std::unique_ptr<bool[]>>(std::move(bytes))};
}

}  // namespace wander::python
