// Input of the targets that read netCDF: text of netcdf_text.h becomes a sealed file, other
// bytes are one.
#pragma once

#include <filesystem>
#include <string_view>

namespace wander::fuzz {

// `end` stands between the bytes of the library and the seal.  False if the text is of no such file.
bool write_netcdf(const std::filesystem::path& file, std::string_view input, std::string_view end);

}  // namespace wander::fuzz
