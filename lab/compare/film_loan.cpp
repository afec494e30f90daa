#include "lab/compare/film_loan.h"

#include <utility>

namespace wander::compare {

void shelve(FilmEstimate& film) {
  film = {.shape = std::move(film.shape), .degrees_of_freedom = film.degrees_of_freedom};
}

FilmEstimate film_of(const Runs& runs, const Run& run) {
  return run.film.value.empty() && runs.shelf ? runs.shelf(run) : run.film;
}

FilmLoan::FilmLoan(const FilmShelf& shelf, const std::vector<Run*>& runs) {
  if (!shelf) return;
  for (Run* run : runs) {
    if (!run->film.value.empty()) continue;
    run->film = shelf(*run);
    lent_.push_back(run);
  }
}

FilmLoan::~FilmLoan() {
  for (Run* run : lent_) shelve(run->film);
}

}  // namespace wander::compare
