#include "lab/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/image_shape.h"
#include "lab/method.h"
#include "statistics/number_text.h"

namespace wander {

std::string count_in_words(double count) {
  // Three digits: from 999.5 of one unit on, rounding gives the next.
  if (count >= 999.5e6) return number_text(count / 1e9) + " G";
  if (count >= 999.5e3) return number_text(count / 1e6) + " M";
  if (count >= 1e4) return number_text(count / 1e3) + " k";
  return fmt::format("{:.0f}", count);
}

std::string duration_in_words(double seconds) {
  if (seconds < 10) return number_text(seconds, 2) + " s";
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  const double minutes = std::floor(seconds / 60);
  if (minutes < 60)
    return fmt::format("{:.0f} min {:.0f} s", minutes, std::floor(seconds - 60 * minutes));
  const double hours = std::floor(minutes / 60);
  return fmt::format("{:.0f} h {:.0f} min", hours, minutes - 60 * hours);
}

std::string counted_in_words(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count_in_words(static_cast<double>(count)), noun,
                     count == 1 ? "" : "s");
}

std::string steps_in_words(std::uint64_t mutations, std::uint64_t samples) {
  std::string text = counted_in_words(mutations, "mutation");
  if (samples > 0) text += ", " + counted_in_words(samples, "sample");
  return text;
}

std::string work_in_words(const Rendering& rendering) {
  // A film read from film.exr or film.nc does not say how many chains made it.
  const bool has_chains = std::ranges::any_of(methods(), [&](const Method& method) {
    return method.name == rendering.method && method.is_markov_chain();
  });
  if (has_chains)
    return steps_in_words(rendering.samples, rendering.pooling ? rendering.pooling->samples : 0);
  return counted_in_words(rendering.samples, "sample");
}

std::string percent(double share) {
  return std::isfinite(share) ? number_text(100 * share) + " %" : "unknown";
}

std::string extent_in_words(std::span<const int> film_shape) {
  if (film_shape.size() < 2)
    return fmt::format("{} bins", film_shape.empty() ? 0 : film_shape.front());
  return fmt::format("{} x {} pixels{}", film_shape[1], film_shape[0],
                     film_shape.size() > 2 ? " in colour" : "");
}

std::string place_in_words(std::span<const int> film_shape, std::size_t index) {
  if (film_shape.size() < 2) return fmt::format("bin {}", index);
  constexpr std::array colours{"red", "green", "blue"};
  const std::size_t channels = ImageShape(film_shape).channels, pixel = index / channels;
  const auto width = static_cast<std::size_t>(film_shape[1]);
  const std::string place = fmt::format("pixel ({}, {})", pixel % width, pixel / width);
  return channels == 1 ? place : fmt::format("{}, {}", place, colours.at(index % channels));
}

std::string with_error(const Estimate& estimate) {
  if (!std::isfinite(estimate.standard_error))
    return number_text(estimate.value, 6) + " (error unknown)";
  return fmt::format("{} ± {}", number_text(estimate.value, 6),
                     number_text(estimate.standard_error, 2));
}

}  // namespace wander
