#include "mlt/run/reliability.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "core/film.h"
#include "mlt/run/deposit.h"

namespace wander {

namespace {

constexpr int most_around = 2 * bins_to_each_side + 1;

// A film as rows of places; those of one channel lie `channels` apart.
struct Grid {
  explicit Grid(std::span<const int> shape)
      : rows(shape.size() > 1 ? shape[0] : 1),
        columns(shape.size() > 1 ? shape[1] : shape[0]),
        channels(shape.size() > 2 ? shape[2] : 1),
        reach(shape.size() > 1 ? 1 : bins_to_each_side) {}

  int rows, columns, channels, reach;
};

// As how many independent events know the bin; none if it is dark or its error cannot be told.
double events(const FilmEstimate& film, std::size_t bin) {
  const double value = film.value[bin], error = film.standard_error[bin];
  if (!(value > 0 && error >= 0)) return 0;
  return error > 0 ? value / error * (value / error) : std::numeric_limits<double>::infinity();
}

// The median over the lit bins around; of an even number the greater of the two in the middle.
double events_around(const FilmEstimate& film, const Grid& grid, std::size_t bin) {
  const auto channels = static_cast<std::size_t>(grid.channels);
  const auto columns = static_cast<std::size_t>(grid.columns), place = bin / channels;
  const auto row = static_cast<int>(place / columns), column = static_cast<int>(place % columns);
  std::array<double, most_around> found{};
  std::size_t lit = 0;
  for (int r = std::max(0, row - grid.reach); r <= std::min(grid.rows - 1, row + grid.reach); ++r)
    for (int c = std::max(0, column - grid.reach);
         c <= std::min(grid.columns - 1, column + grid.reach); ++c) {
      const auto there =
          (static_cast<std::size_t>(r) * columns + static_cast<std::size_t>(c)) * channels +
          bin % channels;
      if (film.value[there] > 0) found[lit++] = events(film, there);
    }
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(lit / 2);
  std::nth_element(found.begin(), middle, found.begin() + static_cast<std::ptrdiff_t>(lit));
  return *middle;
}

}  // namespace

void tell_reliable(FilmEstimate& film, std::size_t groups) {
  film.reliable.assign(film.value.size(), false);
  if (groups < static_cast<std::size_t>(GroupsFilm::fewest_groups)) return;
  const Grid grid(film.shape);
  for (std::size_t bin = 0; bin < film.value.size(); ++bin) {
    const double own = events(film, bin);
    if (own < fewest_effective_samples / 2) continue;
    film.reliable[bin] = own >= 4 * fewest_effective_samples ||
                         events_around(film, grid, bin) >= fewest_effective_samples;
  }
}

}  // namespace wander
