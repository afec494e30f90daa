#include "lab/seldom_seen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "core/film_statistics.h"
#include "lab/wording.h"

namespace wander {

SeldomSeen seldom_seen(const TechniqueTally& techniques, const FilmEstimate& film,
                       std::uint64_t samples) {
  constexpr std::size_t most_named = 3;
  double light = 0;
  std::vector<std::string> names;
  for (const RareTechnique& technique : techniques.rare(fewest_on_film(film.shape))) {
    light += technique.light;
    if (names.size() < most_named)
      names.push_back(fmt::format("({}, {})", technique.vertices, technique.technique));
  }
  light /= static_cast<double>(samples);  // of the mean of the film
  return {fmt::format("{}", fmt::join(names, ", ")), percent(light / mean_value(film))};
}

}  // namespace wander
