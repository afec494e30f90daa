#include "draw/figure/clip.h"

#include <algorithm>
#include <utility>

namespace wander::figure {
namespace {

// Cuts [t, end] down to where low <= start + t step <= high [Liang and Barsky 1984].
void cut(double start, double step, double low, double high, double& t, double& end) {
  if (step == 0) {
    if (start < low || start > high) end = t - 1;
    return;
  }
  const auto [enter, leave] = std::minmax({(low - start) / step, (high - start) / step});
  t = std::max(t, enter);
  end = std::min(end, leave);
}

}  // namespace

bool holds(const Window& window, Vector p) {
  return p.x >= window.low.x && p.x <= window.high.x && p.y >= window.low.y && p.y <= window.high.y;
}

Vector last_within(Vector a, Vector b, const Window& window) {
  double t = 0, end = 1;
  cut(a.x, b.x - a.x, window.low.x, window.high.x, t, end);
  cut(a.y, b.y - a.y, window.low.y, window.high.y, t, end);
  return a + std::max(end, 0.) * (b - a);
}

std::string clipped(const std::vector<Vector>& line, const Window& window) {
  std::string data;
  bool goes_on = false;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vector a = line[k], step = line[k + 1] - a;
    double t = 0, end = 1;
    cut(a.x, step.x, window.low.x, window.high.x, t, end);
    cut(a.y, step.y, window.low.y, window.high.y, t, end);
    if (!(t <= end)) {
      goes_on = false;
      continue;
    }
    if (!goes_on || t > 0) data += "M" + coordinates(a + t * step);
    data += "L" + coordinates(a + end * step);
    goes_on = end == 1;
  }
  return data;
}

}  // namespace wander::figure
