#include "records/bin_maps.h"

#include <stdexcept>

#include "core/film_layout.h"

namespace wander {

std::vector<double> on_bins(const std::vector<double>& map, const FilmEstimate& film) {
  if (map.empty() || map.size() == film.value.size()) return map;
  const Raster raster = FilmLayout{}.raster(film.shape);
  if (map.size() != raster.cells()) throw std::logic_error("a map does not fit the film");
  std::vector<double> spread(film.value.size());
  for (std::size_t j = 0; j < spread.size(); ++j) spread[j] = map[raster.cell(static_cast<int>(j))];
  return spread;
}
std::vector<double> shared_by_bins(std::vector<double> counts, const FilmEstimate& film) {
  if (counts.empty() || counts.size() == film.value.size()) return counts;
  const Raster raster = FilmLayout{}.raster(film.shape);
  std::vector<double> bins(counts.size());
  for (std::size_t j = 0; j < film.value.size(); ++j) ++bins.at(raster.cell(static_cast<int>(j)));
  for (std::size_t c = 0; c < counts.size(); ++c) counts[c] /= bins[c];
  return on_bins(counts, film);
}

}  // namespace wander
