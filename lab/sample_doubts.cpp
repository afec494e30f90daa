#include "lab/sample_doubts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "core/film_statistics.h"
#include "core/tint.h"
#include "lab/wording.h"

namespace wander {

std::string rare_techniques(const TechniqueTally& techniques, const FilmEstimate& film,
                            std::uint64_t samples) {
  constexpr std::size_t most_named = 3;
  const double pixels = static_cast<double>(film.value.size()) / channels_of(film.shape);
  const std::vector<RareTechnique> rare = techniques.rare(fewest_technique_samples * pixels);
  double light = 0;
  for (const RareTechnique& technique : rare) light += technique.light;
  light /= static_cast<double>(samples);  // of the mean of the film
  std::size_t lit = 0, doubtful = 0;
  for (std::size_t i = 0; i < film.value.size(); ++i) {
    if (!(film.value[i] > 0)) continue;
    ++lit;
    doubtful += light > most_rare_light * film.standard_error[i] ? 1 : 0;
  }
  if (2 * doubtful <= lit) return "";
  std::vector<std::string> names;
  for (const RareTechnique& technique : rare)
    if (names.size() < most_named)
      names.push_back(fmt::format("({}, {})", technique.vertices, technique.technique));
  return fmt::format(
      "{} of {} lit bins cannot be called reliable: techniques (n, s) that found light in few "
      "samples, most of it {}, carry {} of the film, and what they did not find is in no error "
      "bar; a larger budget finds more of it, and so may mlt",
      doubtful, lit, fmt::join(names, ", "), percent(light / mean_value(film)));
}

void add_doubts(Rendering& rendering, const TechniqueTally& techniques, LightByMirrors mirrors) {
  if (mirrors == LightByMirrors::by_chance &&
      techniques.effective_hits() < fewest_technique_samples) {
    rendering.film.reliable.assign(rendering.film.reliable.size(), false);
    rendering.warnings.push_back(fmt::format(
        "{} finds light that comes by mirrors or smooth glass only where it meets a lamp by "
        "chance, and it hardly met one: what it may have missed is in no error bar; a larger "
        "budget, or bdpt",
        rendering.method));
    return;
  }
  std::string rare = rare_techniques(techniques, rendering.film, rendering.samples);
  if (!rare.empty()) rendering.warnings.push_back(std::move(rare));
}

}  // namespace wander
