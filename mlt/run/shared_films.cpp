#include "mlt/run/shared_films.h"

#include <algorithm>
#include <utility>

namespace wander {

SharedFilms::SharedFilms(std::span<const int> film, int max_vertices, int groups,
                         const FilmLayout& layout)
    : groups_(groups), common_(values_of(film)) {
  if (layout.keeps_lengths(film, max_vertices))
    lengths_.resize(static_cast<std::size_t>(max_vertices) - 1);
  films_.assign(static_cast<std::size_t>(films_of(film, groups, layout)),
                SharedFilm(bins(), static_cast<int>(lengths_.size())));
}

double SharedFilms::share_of_group(int group) const {
  const int of_film = (groups_ - 1 - film_of_group(group)) / count() + 1;
  return static_cast<double>(groups_) / count() / of_film;
}

void SharedFilms::flush() {
  std::vector<std::size_t> full;
  for (SharedFilm& film : films_) {
    full.insert(full.end(), film.full_.begin(), film.full_.end());
    film.full_.clear();
  }
  std::ranges::sort(full);
  full.erase(std::unique(full.begin(), full.end()), full.end());
  for (const std::size_t tile : full) flush(tile);
}

void SharedFilms::flush(std::size_t tile) {
  const std::size_t begin = tile * SharedFilm::tile;
  const std::size_t end = std::min(bins(), begin + SharedFilm::tile);
  for (std::size_t j = begin; j < end; ++j) {
    double mean = 0;
    for (const SharedFilm& film : films_) mean += static_cast<double>(film.own_[j]);
    mean /= count();
    common_[j] += mean;
    for (SharedFilm& film : films_)
      film.own_[j] = static_cast<float>(static_cast<double>(film.own_[j]) - mean);
  }
  for (SharedFilm& film : films_) {
    film.additions_[tile] = 0;
    for (std::size_t n = 0; n < film.lengths_.size(); ++n) {
      std::vector<float>& own = film.lengths_[n];
      if (own.empty()) continue;
      lengths_[n].resize(bins());
      for (std::size_t j = begin; j < end; ++j)
        lengths_[n][j] += static_cast<double>(std::exchange(own[j], 0.F));
    }
  }
}

std::vector<double> SharedFilms::mean_of_length(std::size_t length) const {
  std::vector<double> mean = lengths_[length];
  for (const SharedFilm& film : films_) {
    const std::vector<float>& own = film.lengths_[length];
    if (own.empty()) continue;
    mean.resize(bins());
    for (std::size_t j = 0; j < own.size(); ++j) mean[j] += static_cast<double>(own[j]);
  }
  for (double& value : mean) value /= count();
  return mean;
}

}  // namespace wander
