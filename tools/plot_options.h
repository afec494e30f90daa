// What the command line of `wander plot` says, and the kinds of plots that it chooses from.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/description.h"
#include "draw/figure/film_figure.h"
#include "tools/verb.h"
#include "work/session.h"

namespace wander {

inline constexpr std::array<std::string_view, 3> layout_words{"auto", "overlay", "panels"};
inline constexpr std::array<std::string_view, 6> figure_words{
    "paths", "trace", "acceptance", "autocorrelation", "density", "all"};

enum class TrajectoryFigure { all, paths, trace, acceptance, autocorrelation, density };

// Draws A:B are those from A up to, not including, B.
struct DrawRange {
  int first = 0, end = std::numeric_limits<int>::max();
};

struct TrajectoryPlotOptions {
  std::optional<TrajectoryFigure> figure;  // none: all
  std::optional<DrawRange> draws;
  std::optional<int> chain;
  std::string mutation, path_class;  // empty: any

  bool is_empty() const {
    return !figure && !draws && !chain && mutation.empty() && path_class.empty();
  }
};

struct FluencePlotOptions {
  bool wanted = false;
  std::optional<Budget> budget;
  std::optional<int> resolution;  // cells across
};

struct PlotOptions {
  std::vector<std::string> files;
  std::string reference;
  std::optional<std::string> title;  // none: the name of the scene
  std::optional<double> width;       // points; none: as wide as its kind of figure is
  std::optional<double> dpi;         // of PNG
  figure::Layout layout = figure::Layout::automatic;
  figure::Spacing values = figure::Spacing::linear;  // of the axis of films
  std::optional<double> exposure;                    // of images, in stops
  bool parts = false;                                // of a pooled film
  TrajectoryPlotOptions trajectory;
  FluencePlotOptions fluence;
};

}  // namespace wander
