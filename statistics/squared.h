#pragma once

namespace wander {

constexpr double squared(double x) { return x * x; }

}  // namespace wander
