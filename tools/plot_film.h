// `wander plot` of runs: films of two-dimensional scenes in one figure.
#pragma once

#include <optional>
#include <string>

#include "records/run_record.h"
#include "tools/plot_options.h"

namespace wander {

// A run with what its figure needs to know of its scene.
struct Film {
  std::string path;
  RunRecord run;
  std::optional<description::Scene> scene;  // none if the run does not hold its text

  figure::FilmAxes axes() const { return scene ? figure::film_axes(*scene) : figure::FilmAxes{}; }
};

// None if the file is no run.  Throws where it is one that cannot be drawn.
std::optional<Film> find_film(const std::string& path);

// All files of the command line; `first` is the first of them.
std::string film_svg(const Film& first, const PlotOptions& options);

}  // namespace wander
