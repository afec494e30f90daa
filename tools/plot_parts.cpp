#include "tools/plot_parts.h"

#include "draw/figure/parts_figure.h"
#include "lab/failure.h"
#include "tools/plot_image.h"

namespace wander {

std::string parts_svg(const Film& film, const PlotOptions& options) {
  if (options.files.size() > 1 || !options.reference.empty())
    throw UsageError("--parts is of one run, and without --reference");
  const Rendering& run = film.run.rendering;
  if (!run.pooling || run.pooling->film_of_samples.size() != run.film.value.size())
    throw UsageError(
        film.path +
        ": its film is not pooled of samples and chains, or it does not say what each "
        "carries; name the directory of a run of mlt, pssmlt or mmlt with --film pooled");
  const figure::PartsFigureOptions how{
      .title = options.title.value_or(film.run.provenance.scene_name),
      .axes = film.axes(),
      .value = value_of(film.run),
      .exposure = options.exposure.value_or(0),
      .width = options.width};
  return film.is_image() ? figure::parts_of_image(run, how) : figure::parts_of_film(run, how);
}

}  // namespace wander
