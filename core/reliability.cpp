#include "core/reliability.h"

#include <algorithm>
#include <optional>
#include <span>

namespace wander {

namespace {

constexpr double fewest_around = 3 * fewest_effective_samples / 4;
constexpr double fewest_own = 3 * fewest_effective_samples / 5, fewest_alone = 2 * fewest_around;
constexpr double most_own_to_around = 3;
constexpr double enough_around = 20 * fewest_effective_samples;

// A film as rows of places; those of one channel lie `channels` apart.
struct Grid {
  explicit Grid(std::span<const int> shape)
      : rows(shape.size() > 1 ? shape[0] : 1),
        columns(shape.size() > 1 ? shape[1] : shape[0]),
        channels(shape.size() > 2 ? shape[2] : 1),
        reach(shape.size() > 1 ? 1 : bins_to_each_side) {}

  int rows, columns, channels, reach;
};

// What an event weighs by the bin's own claim; none where the bin is dark or that cannot be told.
std::optional<double> own_weight(const FilmEstimate& film, std::size_t bin,
                                 const EventWeight& weight) {
  const double value = film.value[bin];
  const double own = value > 0 ? weight(value, film.standard_error[bin]) : not_known;
  return own >= 0 ? std::optional(own) : std::nullopt;
}

// Of the lit bins around one that is lit: what an event weighs there, itself among them, and the mean value of the others; of
// itself, if none of them is lit.
struct Around {
  double weight, value;
};
Around around(const FilmEstimate& film, const EventWeight& weight, const Grid& grid,
              std::size_t bin) {
  const auto channels = static_cast<std::size_t>(grid.channels);
  const auto columns = static_cast<std::size_t>(grid.columns), place = bin / channels;
  const auto row = static_cast<int>(place / columns), column = static_cast<int>(place % columns);
  Around sum{0, 0};
  int count = 0;
  for (int r = std::max(0, row - grid.reach); r <= std::min(grid.rows - 1, row + grid.reach); ++r)
    for (int c = std::max(0, column - grid.reach);
         c <= std::min(grid.columns - 1, column + grid.reach); ++c) {
      const auto there =
          (static_cast<std::size_t>(r) * columns + static_cast<std::size_t>(c)) * channels +
          bin % channels;
      if (const auto w = own_weight(film, there, weight)) {
        sum.weight += *w;
        if (there != bin) sum.value += film.value[there];
        ++count;
      }
    }
  return {sum.weight / count, count > 1 ? sum.value / (count - 1) : film.value[bin]};
}

}  // namespace

std::vector<bool> reliability(const FilmEstimate& film, const EventWeight& weight) {
  std::vector<bool> reliable(film.value.size());
  const Grid grid(film.shape);
  for (std::size_t bin = 0; bin < film.value.size(); ++bin) {
    const auto own = own_weight(film, bin, weight);
    if (!own) continue;
    const double value = film.value[bin];
    const auto [w, v] = around(film, weight, grid, bin);
    const bool is_known_around = v >= fewest_around * w && value >= fewest_own * w;
    reliable[bin] = value >= fewest_claimed_events * *own &&
                    (is_known_around || value >= fewest_alone * w) &&
                    (w <= most_own_to_around * *own || value >= enough_around * w);
  }
  return reliable;
}

}  // namespace wander
