#include "tests/fuzz/netcdf_file.h"

#include <string>

#include "records/netcdf.h"
#include "records/seal.h"
#include "tests/fuzz/netcdf_text.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

bool write_netcdf(const std::filesystem::path& file, std::string_view input, std::string_view end) {
  if (input.starts_with("\x89HDF")) {
    write_bytes(file, input);
    return true;
  }
  try {
    write_bytes(file, sealed(netcdf_of(input) + std::string(end)));
    return true;
  } catch (const netcdf::Error&) {
    return false;
  }
}

}  // namespace wander::fuzz
