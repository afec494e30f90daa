#include "mlt/run/coarse_films.h"

namespace wander {

namespace {

using Film = std::vector<double>;

// Along the axis of this extent, whose neighbours are `stride` apart.
Film paired(const Film& film, int extent, std::size_t stride) {
  const auto in = static_cast<std::size_t>(extent), out = (in + 1) / 2;
  Film sums(film.size() / in * out);
  for (std::size_t j = 0; j < film.size(); ++j) {
    const std::size_t outer = j / (stride * in), at = j / stride % in, inner = j % stride;
    sums[(outer * out + at / 2) * stride + inner] += film[j];
  }
  return sums;
}

}  // namespace

void CoarseFilms::halve() {
  std::size_t stride = 1;
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    for (FilmFitGroup& group : groups) {
      group.found = paired(group.found, shape[axis], stride);
      group.deposits = paired(group.deposits, shape[axis], stride);
    }
    shape[axis] = (shape[axis] + 1) / 2;
    stride *= static_cast<std::size_t>(shape[axis]);
  }
}

}  // namespace wander
