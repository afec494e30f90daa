// The pictures of a page, each of which is there once, however often it is shown: whole, cut off at
// a line, or a part of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/film_estimate.h"
#include "draw/report/html.h"

namespace wander::report {

// How many pixels across are to become one so that so many images of this shape together have at most
// so many bytes before they are compressed: noise hardly is.
std::size_t pixels_to_one(const FilmEstimate& like, std::size_t channels, std::size_t count,
                          std::size_t most_bytes);

// All with one exposure: `white` is that of records/tone.h.
class PictureStore {
 public:
  // Pictures of this shape, of which `count` together are to be no larger than a page can be.
  PictureStore(const FilmEstimate& like, std::size_t count, double white);

  // Writes it into the page, unseen; its number.
  std::size_t add(Html& html, const FilmEstimate& film);
  // Shows it; `words` is what a screen reader says, `over` what else is drawn, in pixels of the film.
  void show(Html& html, std::size_t number, const std::string& words,
            const std::string& over = {}) const;

  double width() const { return width_; }
  double height() const { return height_; }

 private:
  double width_, height_, white_;
  std::size_t per_pixel_;
  std::size_t pictures_ = 0;
};

// One that is shown once, each pixel large.
void write_enlarged(Html& html, const FilmEstimate& film, double white, const std::string& words);

}  // namespace wander::report
