#include "tools/plot_parts.h"

#include <fmt/format.h>

#include "draw/figure/parts_figure.h"
#include "lab/failure.h"
#include "tools/plot_film.h"
#include "tools/plot_image.h"

namespace wander {

namespace {

void require_options_of_parts(const PlotOptions& options) {
  if (options.files.size() > 1 || !options.reference.empty())
    throw UsageError("--parts is of one run, and without --reference");
  if (options.values == figure::Spacing::logarithmic || options.layout != figure::Layout::automatic)
    throw UsageError("--parts goes without --log-y and --layout");
  if (!options.trajectory.is_empty())
    throw UsageError(
        "--parts is of a run; --figure, --draws, --chain, --mutation and --class are of a "
        "trajectory");
}

bool says_its_parts(const Rendering& run) {
  return run.pooling && run.pooling->samples > 0 &&
         run.pooling->film_of_samples.size() == run.film.value.size();
}

}  // namespace

std::string parts_svg(const PlotOptions& options) {
  require_options_of_parts(options);
  const std::string& path = options.files.front();
  const std::optional<Film> film = find_film(path);
  if (!film) throw UsageError(fmt::format("--parts is of a run, and {} is none", path));
  const Rendering& run = film->run.rendering;
  if (!says_its_parts(run))
    throw UsageError(
        path +
        ": its film is not pooled of samples and chains, or it does not say what each "
        "carries; name the directory of a run of mlt, pssmlt or mmlt with --film pooled");
  if (options.exposure && !film->is_image())
    throw UsageError("--exposure is for images, and " + path + " is a row of bins");
  const figure::PartsFigureOptions how{
      .title = options.title.value_or(film->run.provenance.scene_name),
      .axes = film->axes(),
      .value = value_of(film->run),
      .exposure = options.exposure.value_or(0),
      .width = options.width};
  return film->is_image() ? figure::parts_of_image(run, how) : figure::parts_of_film(run, how);
}

}  // namespace wander
