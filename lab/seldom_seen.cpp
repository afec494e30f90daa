#include "lab/seldom_seen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "core/film_statistics.h"
#include "core/tint.h"
#include "lab/wording.h"

namespace wander {

SeldomSeen seldom_seen(const TechniqueTally& techniques, const FilmEstimate& film,
                       std::uint64_t samples) {
  constexpr std::size_t most_named = 3;
  const double pixels = static_cast<double>(film.value.size()) / channels_of(film.shape);
  double light = 0;
  std::vector<std::string> names;
  for (const RareTechnique& technique : techniques.rare(fewest_technique_samples * pixels)) {
    light += technique.light;
    if (names.size() < most_named)
      names.push_back(fmt::format("({}, {})", technique.vertices, technique.technique));
  }
  light /= static_cast<double>(samples);  // of the mean of the film
  return {fmt::format("{}", fmt::join(names, ", ")), percent(light / mean_value(film))};
}

}  // namespace wander
