// The autocorrelation function of the position on the sensor, of log f and of the number of
// vertices: a thin line for each chain about its own mean, and a thick one for all together, which stays high where
// chains are apart.
#pragma once

#include <span>
#include <vector>

#include "draw/figure/block.h"
#include "draw/figure/steps.h"

namespace wander::figure {

// ρ_k = Σ_i (x_i - m)(x_{i+k} - m) / Σ_i (x_i - m)², k = 0 … lags, with m the mean of x: the
// estimate that never exceeds 1 [Priestley 1981, 5.3.3].  Empty where x is constant or not finite.
std::vector<double> autocorrelation(std::span<const double> x, int lags);

Block autocorrelation_chart(const Steps& steps, double width);

}  // namespace wander::figure
