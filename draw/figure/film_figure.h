// Films of two-dimensional scenes as a figure: value over position with 95 % intervals, one film
// over the other or each in a panel of its own, beside a drawing of the scene.
//
// One column wide; two columns with the scene, which stands above the films where there is no room
// for it beside them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/description.h"
#include "draw/figure/chart.h"
#include "draw/figure/film_series.h"
#include "records/rendering.h"

namespace wander::figure {

struct LabelledFilm {
  std::string label;
  Rendering rendering;
};

// `automatic` lays two films over one another as long as their lines can be told apart; otherwise,
// and when there are more, each has its panel.
enum class Layout { automatic, overlay, panels };

struct FilmFigureOptions {
  std::string title;
  FilmAxes axes;                            // film_axes(scene)
  std::optional<description::Scene> inset;  // drawn at the left
  std::optional<LabelledFilm> reference;    // a thin black line
  Layout layout = Layout::automatic;
  std::optional<double> width{};  // of the page, in points
  Spacing values = Spacing::linear;
};

// An SVG document.  At least one film.
std::string film_figure(const std::vector<LabelledFilm>& films, const FilmFigureOptions& options);

}  // namespace wander::figure
