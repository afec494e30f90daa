// A film as it is estimated: value and error of each bin.
//
// Units: mean irradiance per bin (W/m in two dimensions) or mean radiance (camera).
#pragma once

#include <limits>
#include <map>
#include <vector>

namespace wander {

// A number that cannot be told.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

struct Estimate {
  double value = 0;
  double standard_error = 0;  // one standard deviation of `value`; NaN when it cannot be told
};

struct FilmEstimate {
  std::vector<int> shape{};              // {bins} in 2D, {height, width} in 3D
  std::vector<double> value{};           // per bin
  std::vector<double> standard_error{};  // per bin; NaN when it cannot be told
  std::vector<bool> reliable{};   // per bin: its interval holds what it promises (reliability.h)
  double degrees_of_freedom = 0;  // of the t-intervals around every bin
  double degrees_of_error = 0;    // of the error of all bins together, where few may decide it
  std::map<int, std::vector<double>>
      by_length{};  // number of vertices -> film of those paths alone
};

}  // namespace wander
