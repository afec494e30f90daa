#include "lab/sample_doubts.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "core/film_statistics.h"
#include "core/reliability.h"
#include "lab/seldom_seen.h"

namespace wander {

namespace {

constexpr double fewest_meetings = 5;  // in effective samples

struct Words {
  const char *where, *remedy;
};
Words words_of(MetByChance end) {
  if (end == MetByChance::lights)
    return {"only where it meets a lamp by chance",
            "a larger budget; or bdpt, if that light is scattered on its way to the sensor"};
  if (end == MetByChance::sensors)
    return {"only where it meets a sensor by chance",
            "a larger budget; or bdpt, if that light is scattered on its way from the lamp"};
  return {"next to lamp and sensor only where it meets one of them by chance",
          "a larger budget, or larger lamps or sensors"};
}

}  // namespace

// By its own claim alone a bin was seen: where those around it say otherwise, that is for such light too.
DoubtedBins doubted_bins(const FilmEstimate& film, const TechniqueTally& techniques,
                         std::uint64_t samples) {
  const EventWeight weight = EventWeight::of_samples(samples);
  const std::vector<bool> without = without_rare_light(film, techniques, samples);
  DoubtedBins bins;
  for (std::size_t i = 0; i < without.size(); ++i) {
    const double value = film.value[i];
    const double of_sample = weight(value, film.standard_error[i]);
    if (!(value > 0 && value >= fewest_effective_samples * of_sample)) continue;
    ++bins.seen;
    bins.doubtful += without[i] ? 0 : 1;
  }
  return bins;
}

std::string rare_techniques(const TechniqueTally& techniques, const FilmEstimate& film,
                            std::uint64_t samples) {
  const DoubtedBins bins = doubted_bins(film, techniques, samples);
  if (2 * bins.doubtful <= bins.seen) return "";
  const SeldomSeen rare = seldom_seen(techniques, film, samples);
  return fmt::format(
      "{} of {} bins that samples enough have found cannot be called reliable: techniques (n, s) "
      "that found light in few samples, most of it {}, carry {} of the film, and what they did not "
      "find is in no error bar; a larger budget finds more of it, and so may mlt",
      bins.doubtful, bins.seen, rare.names, rare.share);
}

void doubt_what_was_not_met(Rendering& rendering, MetByChance end, const BinSums& met) {
  if (end == MetByChance::nowhere || met.effective_samples() >= fewest_meetings) return;
  rendering.film.reliable.assign(rendering.film.reliable.size(), false);
  rendering.warnings.push_back(fmt::format(
      "{} finds light that comes by mirrors or smooth glass {}, and it hardly met one: what it may "
      "have missed is in no error bar; {}",
      rendering.method, words_of(end).where, words_of(end).remedy));
}

void add_doubts(Rendering& rendering, const TechniqueTally& techniques, MetByChance end) {
  BinSums met;
  if (end != MetByChance::sensors) met.merge(techniques.lights_met());
  if (end != MetByChance::lights) met.merge(techniques.sensors_met());
  const std::size_t before = rendering.warnings.size();
  doubt_what_was_not_met(rendering, end, met);
  if (rendering.warnings.size() > before) return;
  std::string rare = rare_techniques(techniques, rendering.film, rendering.samples);
  if (!rare.empty()) rendering.warnings.push_back(std::move(rare));
}

}  // namespace wander
