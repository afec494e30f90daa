// Figures of a recorded trajectory, each on a page of its own, and all of them on one page.
#pragma once

#include <string>
#include <utility>

#include "core/description.h"
#include "draw/figure/block.h"
#include "draw/figure/stage.h"
#include "draw/figure/steps.h"
#include "draw/figure/style.h"

namespace wander::figure {

class TrajectoryPage {
 public:
  // Trajectory and scene outlive this; what the filter names exists.
  TrajectoryPage(const Trajectory& trajectory, const description::Scene& scene,
                 const StepFilter& filter, std::string title, double page_width = style::page_width)
      : TrajectoryPage(trajectory, plane_stage(scene), filter, std::move(title), page_width) {}
  TrajectoryPage(const Trajectory& trajectory, Stage stage, const StepFilter& filter,
                 std::string title, double page_width = style::page_width);

  // SVG documents.
  std::string paths() const;
  std::string trace() const;
  std::string acceptance() const;
  std::string autocorrelation() const;
  std::string density() const;  // of a scene of the plane
  std::string overview() const;

 private:
  Stage stage_;
  Steps chosen_;
  Steps sequence_;  // of the chosen steps those of the first chain
  Steps whole_;     // all steps of the same chains and draws, for what needs a series without gaps
  std::string title_;
  double page_width_;

  double width() const;
  std::string single(const char* what, Block block) const;
};

}  // namespace wander::figure
