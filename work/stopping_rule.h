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
#include <optional>
#include <ranges>
#include <span>

namespace wander {

// The number of samples after which to look again, having seen the error e after `samples`.
inline std::uint64_t next_look(std::uint64_t samples, double error, double target) {
  const double ratio = error / target;
  const double growth = std::isfinite(ratio) ? std::clamp(ratio * ratio, 1.1, 2.0) : 2.0;
  return static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * growth));
}

// A look at the film: its relative error after so many samples, known by so many degrees of freedom.
struct Look {
  std::uint64_t samples = 0;
  double error = 0, degrees_of_freedom = 0;

  bool operator==(const Look&) const = default;
};

// Is there a part f of the error e that samples do not lessen, and above the target?  Of two looks, the second after g times
// the samples, e² = f² + a/n says
//   f² = (g e₂² - e₁²) / (g - 1).
// That there is one is believed where e₂ lies four standard deviations above e₁ / √g: of an error known by k degrees of
// freedom the logarithm has a standard deviation of 1 / √(2 k), so that of their ratio has √(1 / (2 k₁) + 1 / (2 k₂)).  The last
// look is held against those 8, 64, 512 … times before it, which an error of few degrees of freedom needs; the false-alarm rate is
// 3·10⁻⁵ a pair.  Returned is f.
inline std::optional<double> error_that_stays(std::span<const Look> looks, double target) {
  constexpr double deviations = 4, least_growth = 8;
  if (looks.empty()) return {};
  const Look& last = looks.back();
  double asked_for = least_growth;
  for (const Look& before : looks | std::views::reverse) {
    const double growth = static_cast<double>(last.samples) / static_cast<double>(before.samples);
    if (growth < asked_for) continue;
    asked_for *= least_growth;
    const double deviation =
        std::sqrt(0.5 / before.degrees_of_freedom + 0.5 / last.degrees_of_freedom);
    const double stays =
        (growth * last.error * last.error - before.error * before.error) / (growth - 1);
    if (last.error > std::exp(deviations * deviation) * before.error / std::sqrt(growth) &&
        stays > target * target)
      return std::sqrt(stays);
  }
  return {};
}

// So many samples that find no light at all are enough to say that there is none.
inline constexpr std::uint64_t samples_in_the_dark = std::uint64_t{1} << 20;

}  // namespace wander
