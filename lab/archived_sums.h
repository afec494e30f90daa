// Many sums to and from an archive as one block: the bytes of the same sums one by one.  Films of all groups
// and all lengths of path are most of what a checkpoint writes.
// Whatever archives them includes this header.
#pragma once

#include <cereal/cereal.hpp>
#include <cereal/types/vector.hpp>
#include <concepts>
#include <type_traits>
#include <vector>

#include "core/film.h"
#include "statistics/sum.h"

namespace wander {

// Nothing but two numbers, in the order in which they are archived.
template <class T>
concept PairOfSums = (std::same_as<T, Sum> ||
                      std::same_as<T, BinSums>)&&std::is_trivially_copyable_v<T> &&
                     sizeof(T) == 2 * sizeof(double);

template <class Archive, PairOfSums T>
void CEREAL_SAVE_FUNCTION_NAME(Archive& archive, const std::vector<T>& sums) {
  archive(cereal::make_size_tag(static_cast<cereal::size_type>(sums.size())));
  archive(cereal::binary_data(sums.data(), sums.size() * sizeof(T)));
}
template <class Archive, PairOfSums T>
void CEREAL_LOAD_FUNCTION_NAME(Archive& archive, std::vector<T>& sums) {
  cereal::size_type size = 0;
  archive(cereal::make_size_tag(size));
  sums.resize(static_cast<std::size_t>(size));
  archive(cereal::binary_data(sums.data(), sums.size() * sizeof(T)));
}

}  // namespace wander
