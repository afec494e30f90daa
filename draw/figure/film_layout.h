// Where the parts of a film figure stand, and whether its films share a panel.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "draw/figure/film_figure.h"
#include "draw/figure/film_panel.h"

namespace wander::figure {

inline constexpr double overlay_height = 122, panel_height = 62;

// How often, of two lines that cross, the next crossing is so near that the eye takes the one for
// the other.
std::size_t tangles(std::span<const Bar> a, std::span<const Bar> b, const Panel& panel);

// What Layout::automatic is for these films, drawn over one another in `panel`.
Layout best_layout(std::span<const Trace> traces, const Panel& panel);

// The width of the panels, short of what the labels of values take; as many bars as it can show.
double panel_room(const FilmFigureOptions& options);
std::size_t bars_in(const FilmFigureOptions& options);

// In points on the page, y downwards.
struct FilmPage {
  Vector size;
  Vector inset, inset_size;  // its upper left corner; no size: none
  double top;                // of the first panel, its header included
  Range x;                   // of the panels
  std::vector<Range> rows;   // of the panels, bottom (the greater y) first
  double header_line;        // from line to line of a header
  Range legend;              // across
  double legend_top;
};

// What takes room: the widest label of values, the lines of a header, the legend across a width.
struct FilmContent {
  std::size_t rows = 1, header_lines = 0;
  double value_labels = 0;
  std::function<double(double width)> legend_height;
};

FilmPage lay_out(const FilmContent& content, const FilmFigureOptions& options);

}  // namespace wander::figure
