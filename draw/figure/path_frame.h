// One step of a chain as a drawing: the path before it, the proposal or what there is of it, and
// where it failed.  path_sequence.h puts many of them on a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/description.h"
#include "draw/figure/clip.h"
#include "draw/figure/curve.h"
#include "draw/figure/steps.h"
#include "draw/figure/style.h"

namespace wander::figure {

// A vertex that is no number parts what does not hang together (steps.h).
using PolyLine = std::vector<Vector>;

struct PathFrame {
  PolyLine current, proposed;     // in the scene; empty: none
  std::vector<PolyLine> attempt;  // of a proposal that failed
  std::optional<Vector> failure;  // where
  std::string reason;             // in words
  bool accepted = false;
  std::string title, outcome, classes;
};

PathFrame path_frame(const Steps& steps, const Step& step);

// Lines of the paths; a rejected proposal is dashed, a failed one dotted.
enum class PathKind { current, accepted, rejected, failed };
PathKind proposal_kind(const PathFrame& frame);
double width_of(PathKind kind);
void draw_line(Svg& svg, PathKind kind, std::string_view name, std::string_view data);

// What lies in the window of all lines and vertices of a step.
void draw_paths(Svg& svg, const PathFrame& frame, const PageMap& map, const Window& window);
// The spot where a proposal failed, with the reason in words beside it.
void draw_failure(Svg& svg, const PathFrame& frame, const PageMap& map, const Window& window);

}  // namespace wander::figure
