// What samples and what chains carry of a pooled film (mlt/run/partition.h): where on the film, and in
// which classes of path.  What is left to chains is what independent samples seldom find: a map of
// what is hard in the scene.
#pragma once

#include <optional>
#include <string>

#include "draw/figure/film_series.h"
#include "records/rendering.h"

namespace wander::figure {

struct PartsFigureOptions {
  std::string title;
  FilmAxes axes{};                // of a row of bins: film_axes(scene)
  Quantity value{"value", ""};    // of a pixel of an image
  double exposure = 0;            // of an image, in stops (records/tone.h)
  std::optional<double> width{};  // of the page, in points
};

// SVG documents, of a run whose film is pooled and that says what samples carry of it.
std::string parts_of_film(const Rendering& run, const PartsFigureOptions& options);
std::string parts_of_image(const Rendering& run, const PartsFigureOptions& options);

}  // namespace wander::figure
