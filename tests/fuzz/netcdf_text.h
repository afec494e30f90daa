// netCDF as text, so that what is changed is what the program reads and not how HDF5 packs it: that library
// trusts its files, and the program hands it only those whose seal is whole.  A line is one of
//
//   dimension NAME LENGTH        text NAME REST OF THE LINE      group NAME      (until the next one)
//   whole NAME NUMBER            number NAME NUMBER
//   doubles NAME DIMENSIONS NUMBERS              ints, flags: likewise; NUMBERS are repeated
//   words NAME DIMENSIONS WORDS NUMBERS          lists with commas, - for none
//   empty NAME DIMENSIONS                        a variable to which nothing was written
#pragma once

#include <string>
#include <string_view>

namespace wander::fuzz {

// The bytes of the file; throws netcdf::Error where there is no such file.
std::string netcdf_of(std::string_view text);

}  // namespace wander::fuzz
