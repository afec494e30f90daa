// Bars of a whole, one below the other, each divided into the shares of its parts.  Shades and
// hatches differ, and the shares are written into the bar where they fit.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "draw/figure/block.h"
#include "draw/figure/hatching.h"

namespace wander::figure {

// The fill is the same in every bar.
struct Part {
  std::string key;
  Fill fill{};
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

// Outcome -> how often; those that never occur have no part.
std::vector<Part> outcome_parts(const std::map<std::string, double>& counts);

}  // namespace wander::figure
