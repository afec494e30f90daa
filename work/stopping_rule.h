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
#include <vector>

namespace wander {

// The number of samples after which to look again, having seen the error e after `samples`.
inline std::uint64_t next_look(std::uint64_t samples, double error, double target) {
  const double ratio = error / target;
  const double growth = std::isfinite(ratio) ? std::clamp(ratio * ratio, 1.1, 2.0) : 2.0;
  return static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * growth));
}

// Is there a part f of the error e that samples do not lessen, and above the target?  Of two looks, the second after g times
// the samples, e² = f² + a/n says
//   f² = (g e₂² - e₁²) / (g - 1).
// That there is one is believed where e₂ lies four standard deviations above e₁ / √g: of an error known by k degrees of
// freedom the logarithm has a standard deviation of 1 / √(2 k), so that of their ratio has 1 / √k, and the false-alarm rate is 3·10⁻⁵ a
// look.
class ErrorThatStays {
 public:
  explicit ErrorThatStays(double target) : target_(target) {}

  // How large it is, if it is seen at a look, each at more samples than the one before.
  std::optional<double> seen(std::uint64_t samples, double error, double degrees_of_freedom) {
    constexpr double deviations = 4, least_growth = 8;
    looks_.push_back({static_cast<double>(samples), error});
    for (const Look& before : looks_ | std::views::reverse) {
      const double growth = static_cast<double>(samples) / before.samples;
      if (growth < least_growth) continue;
      const double by_chance = std::exp(deviations / std::sqrt(degrees_of_freedom)),
                   stays = (growth * error * error - before.error * before.error) / (growth - 1);
      if (error > by_chance * before.error / std::sqrt(growth) && stays > target_ * target_)
        return std::sqrt(stays);
      return {};
    }
    return {};
  }

 private:
  struct Look {
    double samples, error;
  };
  double target_;
  std::vector<Look> looks_;
};

// So many samples that find no light at all are enough to say that there is none.
inline constexpr std::uint64_t samples_in_the_dark = std::uint64_t{1} << 20;

}  // namespace wander
