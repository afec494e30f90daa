#include "draw/figure/trajectory_figure.h"

#include "draw/figure/acceptance_chart.h"
#include "draw/figure/autocorrelation.h"
#include "draw/figure/coordinate_trace.h"
#include "draw/figure/path_density.h"
#include "draw/figure/path_sequence.h"

namespace wander::figure {
namespace {

// On a page of its own, and in the overview.
constexpr int most_steps = 24, most_steps_of_many = 8;
constexpr int most_chains = 12, most_chains_of_many = 4;

StepFilter of_first_chain(StepFilter filter) {
  filter.chains = {filter.chains.empty() ? 0 : filter.chains.front()};
  return filter;
}

StepFilter of_any_kind(StepFilter filter) {
  filter.mutation.reset();
  filter.path_class.reset();
  return filter;
}

}  // namespace

TrajectoryPage::TrajectoryPage(const Trajectory& trajectory, Stage stage, const StepFilter& filter,
                               std::string title, double page_width)
    : stage_(std::move(stage)),
      chosen_(trajectory, filter),
      sequence_(trajectory, of_first_chain(filter), stage_.projection),
      whole_(trajectory, of_any_kind(filter)),
      title_(std::move(title)),
      page_width_(page_width) {}

double TrajectoryPage::width() const { return block_width(page_width_); }

std::string TrajectoryPage::single(const char* what, Block block) const {
  return page(title_, what, page_width_, {std::move(block)});
}

std::string TrajectoryPage::paths() const {
  return single("a sequence of mutated light paths",
                path_sequence(sequence_, stage_, width(), most_steps));
}

std::string TrajectoryPage::trace() const {
  return single("the position on the sensor of each chain, step by step",
                coordinate_trace(whole_, width(), most_chains));
}

std::string TrajectoryPage::acceptance() const {
  return single("acceptance by mutation and reason", acceptance_chart(chosen_, width()));
}

std::string TrajectoryPage::autocorrelation() const {
  return single("autocorrelation of the chains", autocorrelation_chart(whole_, width()));
}

std::string TrajectoryPage::density() const {
  return single("density of visited paths", density_picture(chosen_, *stage_.plane, width()));
}

std::string TrajectoryPage::overview() const {
  std::vector<Block> blocks{path_sequence(sequence_, stage_, width(), most_steps_of_many),
                            coordinate_trace(whole_, width(), most_chains_of_many),
                            acceptance_chart(chosen_, width()),
                            autocorrelation_chart(whole_, width())};
  if (stage_.plane != nullptr) blocks.push_back(density_picture(chosen_, *stage_.plane, width()));
  return page(title_, "overview of a trajectory", page_width_, blocks);
}

}  // namespace wander::figure
