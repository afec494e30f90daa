// Bars of a whole, one below the other, each divided into the shares of its parts.  Shades and
// hatches differ, and the shares are written into the bar where they fit.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/figure/block.h"

namespace wander::figure {

// The hatch (hatching.h) is the same in every bar; none: the plain colour of accepted proposals.
struct Part {
  std::string key;
  std::optional<std::size_t> hatch{};
  std::string legend{};
};

struct ShareBar {
  std::string label, note;                 // above the bar: bold at the left, plain at the right
  std::map<std::string, double> shares{};  // key -> in [0, 1]
};

// Parts in the order in which they are stacked.
Block share_bars(std::string heading, std::vector<ShareBar> bars, std::vector<Part> parts,
                 double width);

// Names in words: without underlines.
std::string spoken(std::string name);

// What became of proposals, in words; the parts of a bar are accepted first, then the refusals by
// the acceptance test, then failures.
inline constexpr std::string_view accepted_word = "accepted", refused_word = "metropolis";
std::string spoken_outcome(const std::string& outcome);

}  // namespace wander::figure
