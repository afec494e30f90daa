// A film of which each bin is the mean of those about it: a variance that is estimated bin by bin is known
// better so, where bins that lie side by side have about the same.
#pragma once

#include <span>
#include <vector>

namespace wander {

// The mean over the bins of a film that lie at most two away along each axis; `shape`: fastest axis last.
std::vector<double> smoothed(const std::vector<double>& film, std::span<const int> shape);

}  // namespace wander
