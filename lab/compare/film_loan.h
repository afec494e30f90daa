// The films of a comparison of images, a few at a time: all of them, each with its error bars, would
// fill the memory.  What is measured of a run is measured while its film is on loan from the shelf.
#pragma once

#include <vector>

#include "lab/compare/runs.h"

namespace wander::compare {

// What a run keeps of a film that is on the shelf: its shape.
void shelve(FilmEstimate& film);

// Of a run, wherever its film is.
FilmEstimate film_of(const Runs& runs, const Run& run);

// These runs have their films for as long as it lives.
class FilmLoan {
 public:
  FilmLoan(const FilmShelf& shelf, const std::vector<Run*>& runs);
  ~FilmLoan();
  FilmLoan(const FilmLoan&) = delete;
  FilmLoan& operator=(const FilmLoan&) = delete;

 private:
  std::vector<Run*> lent_{};
};

}  // namespace wander::compare
