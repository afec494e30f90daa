#include "tools/plot_trajectory.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/image_shape.h"
#include "draw/figure/image_maps.h"
#include "draw/figure/image_panel.h"
#include "draw/figure/path_lines.h"
#include "draw/figure/space_figure.h"
#include "draw/figure/style.h"
#include "draw/figure/trajectory_figure.h"
#include "lab/failure.h"
#include "lab/nearest.h"
#include "lab/scene_source.h"
#include "lab/wording.h"
#include "records/tone.h"
#include "records/trajectory_netcdf.h"
#include "tools/plot_film.h"

namespace wander {

namespace {

std::string_view kind_of(std::string_view option) { return option.substr(2); }

std::optional<std::int32_t> index_of(const std::string& word, const std::vector<std::string>& known,
                                     std::string_view option) {
  if (word.empty()) return std::nullopt;
  const auto found = std::ranges::find(known, word);
  if (found != known.end()) return static_cast<std::int32_t>(found - known.begin());
  const std::vector<std::string_view> names(known.begin(), known.end());
  throw UsageError(fmt::format("{}: {}", option, unknown_word(kind_of(option), word, names)));
}

// How many draws have numbers below this one (trajectory.h: first_step, every).
int places_before(int number, const Trajectory& trajectory) {
  const auto n = static_cast<std::uint64_t>(number);
  if (n <= trajectory.first_step) return 0;
  const std::uint64_t places = (n - trajectory.first_step - 1) / trajectory.every + 1;
  return static_cast<int>(std::min(places, static_cast<std::uint64_t>(trajectory.draws)));
}

std::string draws_in_words(const Trajectory& trajectory) {
  if (trajectory.draws == 0) return "no draws";
  const std::uint64_t last =
      trajectory.first_step + static_cast<std::uint64_t>(trajectory.draws - 1) * trajectory.every;
  return fmt::format("the draws {} to {}{}", trajectory.first_step, last,
                     trajectory.every > 1 ? fmt::format(", one of {}", trajectory.every) : "");
}

// The course of a chain is that of all its steps.
void require_whole_chains(const TrajectoryPlotOptions& wanted) {
  using enum TrajectoryFigure;
  if (wanted.figure != trace && wanted.figure != autocorrelation) return;
  for (const auto& [option, word] :
       {std::pair("--mutation", &wanted.mutation), std::pair("--class", &wanted.path_class)})
    if (!word->empty())
      throw UsageError(fmt::format(
          "{} {}: it narrows paths, acceptance and density; the figures trace and autocorrelation "
          "are of all steps of a chain",
          option, *word));
}

void require_drawable(const TrajectoryRecord& record, const PlotOptions& options) {
  const std::string& file = options.files.front();
  const bool in_space = record.trajectory.dimension == 3;
  require_whole_chains(options.trajectory);
  if (options.files.size() > (in_space ? 2u : 1u))
    throw UsageError(file + " is a trajectory; trajectories are drawn one at a time");
  if (!options.reference.empty())
    throw UsageError("--reference is drawn into films, and " + file + " is a trajectory");
  if (options.exposure && options.files.size() < 2)
    throw UsageError("--exposure is for images, and " + file + " is a trajectory");
  if (in_space && options.trajectory.figure == TrajectoryFigure::density)
    throw UsageError("--figure density is of the plane, and " + file +
                     " is a trajectory in space; paths, trace, acceptance and autocorrelation are "
                     "drawn of it");
}

figure::StepFilter filter_of(const Trajectory& trajectory, const PlotOptions& options) {
  const TrajectoryPlotOptions& wanted = options.trajectory;
  figure::StepFilter filter;
  if (wanted.chain) {
    if (*wanted.chain >= trajectory.chains)
      throw UsageError(fmt::format("--chain {}: {} has the chains 0 to {}", *wanted.chain,
                                   options.files.front(), trajectory.chains - 1));
    filter.chains = {*wanted.chain};
  }
  if (wanted.draws) {
    filter.first = places_before(wanted.draws->first, trajectory);
    filter.end = places_before(wanted.draws->end, trajectory);
    if (filter.first >= std::min(filter.end, trajectory.draws))
      throw UsageError(fmt::format("--draws {}:{}: {} has {}", wanted.draws->first,
                                   wanted.draws->end, options.files.front(),
                                   draws_in_words(trajectory)));
  }
  filter.mutation = index_of(wanted.mutation, trajectory.mutations, "--mutation");
  filter.path_class = index_of(wanted.path_class, trajectory.classes, "--class");
  return filter;
}

std::string drawn(const figure::TrajectoryPage& page, TrajectoryFigure wanted) {
  switch (wanted) {
    case TrajectoryFigure::paths:
      return page.paths();
    case TrajectoryFigure::trace:
      return page.trace();
    case TrajectoryFigure::acceptance:
      return page.acceptance();
    case TrajectoryFigure::autocorrelation:
      return page.autocorrelation();
    case TrajectoryFigure::density:
      return page.density();
    case TrajectoryFigure::all:
      break;
  }
  return page.overview();
}

// The geometry is that of the file of the trajectory: no mesh is read for it, and no texture.
description::Scene scene_without_files(const TrajectoryRecord& record, const std::string& file) {
  const auto any_mesh = [](const std::string&, MeshWants) {
    return Triangles{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {{0, 0, 1}}, {{0, 0, 0}}};
  };
  const auto any_texture = [](const std::string&) {
    return std::make_shared<const Texture>(Texture::Picture{1, 1, 1, {0}, {}, {0.5}});
  };
  return parse_scene(record.provenance.scene_text, file, {any_mesh, any_texture}).scene;
}

// The film that the paths are drawn over, of the same camera.
std::string backdrop(const TrajectoryRecord& record, const description::Scene& scene,
                     const PlotOptions& options) {
  const std::string& file = options.files.back();
  const std::optional<Film> film = find_film(file);
  if (!film || !film->is_image())
    throw UsageError(
        fmt::format("{} is no image, over which {} could be drawn", file, options.files.front()));
  const FilmEstimate& image = film->run.rendering.film;
  if (!scene.camera)
    throw UsageError(fmt::format("{} is of a scene without a camera: it is drawn over no image",
                                 options.files.front()));
  const std::vector<int>& resolution = scene.camera->resolution;
  if (std::int64_t{image.shape[1]} * resolution[1] != std::int64_t{image.shape[0]} * resolution[0])
    throw UsageError(fmt::format("{} has {}, and the camera of {} {} x {}: their pictures differ",
                                 file, extent_in_words(image.shape), options.files.front(),
                                 resolution[0], resolution[1]));
  if (!may_be_the_same(film->run.provenance.scene_digest, record.provenance.scene_digest))
    spdlog::warn("{} is of another scene than {}, whose paths are drawn over it", file,
                 options.files.front());
  const FilmEstimate shown = figure::averaged(image);
  const ImageShape size(shown.shape);
  const double white = white_of(image) / std::exp2(options.exposure.value_or(0));
  return figure::picture_png(srgb_bytes(shown.value, white), size.width, size.height,
                             size.channels);
}

figure::Stage stage_of(const TrajectoryRecord& record, const description::Scene& scene,
                       const PlotOptions& options) {
  if (record.trajectory.dimension == 2) return figure::plane_stage(scene);
  const SceneFaces faces = read_faces(options.files.front());
  const figure::View view = figure::view_of(scene, faces);
  return figure::space_stage(view, figure::wireframe(faces, view.eye()),
                             options.files.size() > 1 ? backdrop(record, scene, options) : "");
}

}  // namespace

std::string trajectory_obj(const TrajectoryRecord& record, const PlotOptions& options) {
  require_drawable(record, options);
  const std::string& file = options.files.front();
  if (record.trajectory.dimension != 3)
    throw UsageError(file + " is a trajectory in the plane; FILE.obj is for those in space");
  if (options.files.size() > 1 || options.trajectory.figure || options.width || options.title)
    throw UsageError("FILE.obj has the lines of one trajectory: " + file +
                     " alone, without --figure, --width and --title");
  return figure::path_lines(
      figure::Steps(record.trajectory, filter_of(record.trajectory, options)));
}

std::string trajectory_svg(const TrajectoryRecord& record, const PlotOptions& options) {
  require_drawable(record, options);
  const description::Scene scene = scene_without_files(record, options.files.front());
  const figure::TrajectoryPage page(record.trajectory, stage_of(record, scene, options),
                                    filter_of(record.trajectory, options),
                                    options.title.value_or(record.provenance.scene_name),
                                    options.width.value_or(figure::style::page_width));
  return drawn(page, options.trajectory.figure.value_or(TrajectoryFigure::all));
}

}  // namespace wander
