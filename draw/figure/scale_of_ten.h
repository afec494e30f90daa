// The power of ten in which an axis labels its numbers, for the axis and for all that is written
// beside it.
#pragma once

namespace wander::figure {

// Ten to this power, a multiple of 3, is taken out of the labels of numbers up to this magnitude.
int common_exponent(double magnitude);

// mantissa · 10^exponent, exact where it can be.
double decimal(double mantissa, int exponent);

}  // namespace wander::figure
