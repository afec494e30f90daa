// Images as a figure: each as it looks, and beside it what is known of its error.
//
// All pictures have one exposure, and all maps of a kind one scale.  Beside an image stands its
// relative error, or, where there is another to hold it against, the difference of the two in units
// of the error of both: of N(0, 1), and without structure, if they agree.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/figure/axis.h"
#include "draw/figure/film_figure.h"

namespace wander::figure {

struct ImageFigureOptions {
  std::string title;
  Quantity value{"value", ""};              // of a pixel
  std::optional<LabelledFilm> reference{};  // which all are held against, and which is drawn last
  double exposure = 0;                      // in stops (records/tone.h)
  std::optional<double> width{};            // of the page, in points
};

// An SVG document.  At least one image, all of one shape; the first of two without a reference is
// held against the second.
std::string image_figure(const std::vector<LabelledFilm>& images,
                         const ImageFigureOptions& options);

}  // namespace wander::figure
