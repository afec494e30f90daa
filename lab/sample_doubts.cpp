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
constexpr double fewest_connections =
    10;  // into a lobe, were all samples to connect to it: then rare techniques tell

struct Words {
  const char *where, *remedy;
};
Words words_of(MetByChance end) {
  if (end == MetByChance::lights)
    return {"only where it meets a lamp by chance, and it hardly met one",
            "a larger budget; or bdpt, if that light is scattered on its way to the sensor"};
  if (end == MetByChance::sensors)
    return {"only where it meets a sensor by chance, and it hardly met one",
            "a larger budget; or bdpt, if that light is scattered on its way from the lamp"};
  if (end == MetByChance::camera)
    return {
        "only where a connection to the camera falls into their narrow lobes, "
        "and hardly any does",
        "pt or bdpt"};
  return {
      "next to lamp and sensor only where it meets one of them by chance, and it hardly met one",
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

void doubt_what_was_not_met(Rendering& rendering, const FoundByChance& what, const BinSums& met,
                            std::uint64_t samples) {
  if (what.end == MetByChance::nowhere || met.effective_samples() >= fewest_meetings) return;
  if (what.lobe * static_cast<double>(samples) >= fewest_connections) return;
  rendering.film.reliable.assign(rendering.film.reliable.size(), false);
  const Words words = words_of(what.end);
  rendering.warnings.push_back(fmt::format(
      "{} finds light that comes by {} {}: what it may have missed is in no error bar; {}",
      rendering.method,
      what.lobe > 0 ? "surfaces that are nearly smooth" : "mirrors or smooth glass", words.where,
      words.remedy));
}

void add_doubts(Rendering& rendering, const TechniqueTally& techniques, const FoundByChance& what) {
  BinSums met;
  if (what.end == MetByChance::lights || what.end == MetByChance::either)
    met.merge(techniques.lights_met());
  if (what.end == MetByChance::sensors || what.end == MetByChance::either)
    met.merge(techniques.sensors_met());
  const std::size_t before = rendering.warnings.size();
  doubt_what_was_not_met(rendering, what, met, rendering.samples);
  if (rendering.warnings.size() > before) return;
  std::string rare = rare_techniques(techniques, rendering.film, rendering.samples);
  if (!rare.empty()) rendering.warnings.push_back(std::move(rare));
}

}  // namespace wander
