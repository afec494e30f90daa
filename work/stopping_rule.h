// When to stop, if the budget is an error: the film is looked at after so many samples as would
// reach the target by what was seen last, for the error falls with the square root of their number,
//   n' = n · clamp((e / E)², 1.1, 2).
// So there are few looks, and each would be the last but for chance: stopping at the first estimate
// below E picks those that are too low, the more looks the worse [Wald 1947; Glynn and Whitt 1992].
// The samples alone decide, never the clock.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wander {

// The number of samples after which to look again, having seen the error e after `samples`.
inline std::uint64_t next_look(std::uint64_t samples, double error, double target) {
  const double ratio = error / target;
  const double growth = std::isfinite(ratio) ? std::clamp(ratio * ratio, 1.1, 2.0) : 2.0;
  return static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * growth));
}

// So many samples that find no light at all are enough to say that there is none.
inline constexpr std::uint64_t samples_in_the_dark = std::uint64_t{1} << 20;

}  // namespace wander
