#include "tools/plot_trajectory.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/figure/style.h"
#include "draw/figure/trajectory_figure.h"
#include "lab/failure.h"
#include "lab/nearest.h"
#include "lab/scene_source.h"

namespace wander {

namespace {

void require_drawable(const TrajectoryRecord& record, const PlotOptions& options) {
  const std::string& file = options.files.front();
  if (options.files.size() > 1)
    throw UsageError(file + " is a trajectory; trajectories are drawn one at a time");
  if (!options.reference.empty())
    throw UsageError("--reference is drawn into films, and " + file + " is a trajectory");
  if (record.trajectory.dimension != 2)
    throw UsageError(file +
                     ": plot draws trajectories in two-dimensional scenes; FILE.csv of "
                     "`wander trace` has the numbers of others");
}

std::string_view kind_of(std::string_view option) { return option.substr(2); }

std::optional<std::int32_t> index_of(const std::string& word, const std::vector<std::string>& known,
                                     std::string_view option) {
  if (word.empty()) return std::nullopt;
  const auto found = std::ranges::find(known, word);
  if (found != known.end()) return static_cast<std::int32_t>(found - known.begin());
  const std::vector<std::string_view> names(known.begin(), known.end());
  throw UsageError(fmt::format("{}: {}", option, unknown_word(kind_of(option), word, names)));
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
    if (wanted.draws->first >= trajectory.draws)
      throw UsageError(fmt::format("--draws {}:…: {} has the draws 0 to {}", wanted.draws->first,
                                   options.files.front(), trajectory.draws - 1));
    filter.first = wanted.draws->first;
    filter.end = wanted.draws->end;
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

}  // namespace

std::string trajectory_svg(const TrajectoryRecord& record, const PlotOptions& options) {
  require_drawable(record, options);
  const description::Scene scene =
      parse_scene(record.provenance.scene_text, options.files.front()).scene;
  const figure::TrajectoryPage page(record.trajectory, scene, filter_of(record.trajectory, options),
                                    options.title.value_or(record.provenance.scene_name),
                                    options.width.value_or(figure::style::page_width));
  return drawn(page, options.trajectory.figure.value_or(TrajectoryFigure::all));
}

}  // namespace wander
