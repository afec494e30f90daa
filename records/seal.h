// A digest at the end of a file: libraries that trust what they read then never see a file that was
// cut short or damaged.  HDF5, hence netCDF-4, ignores what follows its own end.
//
//   BYTES "wanderlight-sha256 " DIGEST OF THE BYTES "\n"
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "records/atomic_file.h"

namespace wander {

inline constexpr std::string_view seal_mark = "wanderlight-sha256 ";
inline constexpr std::size_t seal_size = seal_mark.size() + 64 + 1;

std::string sealed(std::string bytes);
// The same piece by piece.
void write_sealed(const FileWriter& bytes, const ByteSink& file);
// The bytes before the seal; none if there is no seal or it is of other bytes.
std::optional<std::string_view> unsealed(std::string_view file);

}  // namespace wander
