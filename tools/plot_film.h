// `wander plot` of runs: films of two-dimensional scenes in one figure, and what all films share.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "records/run_record.h"
#include "tools/plot_options.h"

namespace wander {

// A run with what its figure needs to know of its scene.
struct Film {
  std::string path;
  RunRecord run;
  std::optional<description::Scene>
      scene;  // none if the run does not hold its text, or of an image

  bool is_image() const { return run.provenance.dimension == 3; }
  figure::FilmAxes axes() const { return scene ? figure::film_axes(*scene) : figure::FilmAxes{}; }
};

// None if the file is no run.  Throws where it is one that cannot be drawn.
std::optional<Film> find_film(const std::string& path);

// One of several that are drawn together with the first.  Throws where it is no run, or if one is a
// row of bins and the other an image.
Film require_film(const std::string& path, const Film& first);
// The method, with the name of the run where two runs share a method.
std::string label_of(const Film& film, const std::vector<Film>& films);
// Warnings: what is to be doubted (lab/reference_doubts.h) where films are held against one, or drawn together.
void warn_of_reference(const Film& reference, std::span<const Film> films);
void warn_of_scenes(std::span<const Film> films);
// The name of their scene, or of all their scenes.
std::string title_of(std::span<const Film> films);
// Beside `others`, which are held against it.
figure::LabelledFilm reference_film(const Film& film, std::span<const Film> others);

// All files of the command line; `first` is the first of them.
std::string film_svg(const Film& first, const PlotOptions& options);

}  // namespace wander
