#include "tools/figure/trajectory_figure.h"

#include "tools/figure/acceptance_chart.h"
#include "tools/figure/autocorrelation.h"
#include "tools/figure/coordinate_trace.h"
#include "tools/figure/path_density.h"
#include "tools/figure/path_sequence.h"
#include "tools/figure/style.h"

namespace wander::figure {
namespace {

// On a page of its own, and in the overview.
constexpr int most_steps = 24, most_steps_of_many = 8;
constexpr int most_chains = 12, most_chains_of_many = 4;

double width() { return block_width(style::page_width); }

Block sequence_of(const TrajectoryPage& p, int most) {
  // A sequence is of one chain.
  return path_sequence(p.chosen, p.scene, width(), most);
}

std::string single(const TrajectoryPage& p, const char* what, Block block) {
  return page(p.title, what, style::page_width, {std::move(block)});
}

}  // namespace

std::string paths_figure(const TrajectoryPage& p) {
  return single(p, "a sequence of mutated light paths", sequence_of(p, most_steps));
}

std::string trace_figure(const TrajectoryPage& p) {
  return single(p, "the film coordinate of each chain, step by step",
                coordinate_trace(p.whole, width(), most_chains));
}

std::string acceptance_figure(const TrajectoryPage& p) {
  return single(p, "acceptance by mutation and reason", acceptance_chart(p.chosen, width()));
}

std::string autocorrelation_figure(const TrajectoryPage& p) {
  return single(p, "autocorrelation of the chains", autocorrelation_chart(p.whole, width()));
}

std::string density_figure(const TrajectoryPage& p) {
  return single(p, "density of visited paths", density_picture(p.chosen, p.scene, width()));
}

std::string overview(const TrajectoryPage& p) {
  return page(
      p.title, "overview of a trajectory", style::page_width,
      {sequence_of(p, most_steps_of_many), coordinate_trace(p.whole, width(), most_chains_of_many),
       acceptance_chart(p.chosen, width()), autocorrelation_chart(p.whole, width()),
       density_picture(p.chosen, p.scene, width())});
}

}  // namespace wander::figure
