// A rectangle of the plane divided into cells, and the walk of a straight line through them
// [Amanatides and Woo 1987].
//
// Cells are numbered row by row from the top (largest y) left, as the pixels of an image are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/vector.h"

namespace wander {

class PlaneGrid {
 public:
  using Point = Vec<2, double>;

  // As many rows as make the cells nearly square; low < high in both coordinates.
  PlaneGrid(Point low, Point high, int columns)
      : low_(low),
        columns_(columns),
        rows_(std::max(
            1, static_cast<int>(std::round((high.y - low.y) / (high.x - low.x) * columns)))),
        cell_((high - low) / Point(columns_, rows_)) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t size() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }
  Point low() const { return low_; }
  Point high() const { return low_ + cell_ * Point(columns_, rows_); }
  Point cell() const { return cell_; }  // width and height
  double cell_area() const { return cell_.x * cell_.y; }
  Point center(std::size_t index) const {
    const auto row = static_cast<int>(index) / columns_,
               column = static_cast<int>(index) % columns_;
    return low_ + cell_ * Point(column + 0.5, rows_ - 1 - row + 0.5);
  }

  // Calls visit(cell, length) along the line from a to b, for each cell that it crosses, with the
  // length that lies within.  What is outside the grid is left out.
  template <class Visitor>
  void cross(Point a, Point b, Visitor&& visit) const {
    const Point p = (a - low_) / cell_, step = (b - low_) / cell_ - p;
    double t = 0, end = 1;  // of the part inside, in units of the line
    if (!clip(p.x, step.x, columns_, t, end) || !clip(p.y, step.y, rows_, t, end)) return;
    const double length = glm::distance(a, b);
    if (!(length > 0)) return;
    int x = cell_at(p.x + t * step.x, columns_), y = cell_at(p.y + t * step.y, rows_);
    while (t < end) {
      const double next_x = leaves_at(p.x, step.x, x), next_y = leaves_at(p.y, step.y, y);
      const double next = std::clamp(std::min(next_x, next_y), t, end);
      if (next > t) visit(index(x, y), (next - t) * length);
      t = next;
      int& moving = next_x < next_y ? x : y;
      moving += (next_x < next_y ? step.x : step.y) > 0 ? 1 : -1;
      if (x < 0 || x >= columns_ || y < 0 || y >= rows_) return;
    }
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(rows_ - 1 - y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }
  static int cell_at(double coordinate, int count) {
    return std::clamp(static_cast<int>(coordinate), 0, count - 1);
  }
  static double leaves_at(double start, double step, int cell) {
    return step == 0 ? INFINITY : (cell + (step > 0 ? 1 : 0) - start) / step;
  }
  // Cuts [t, end] down to where 0 <= start + t step <= count [Liang and Barsky 1984].
  static bool clip(double start, double step, int count, double& t, double& end) {
    if (step == 0) return start >= 0 && start <= count;
    const double enter = ((step > 0 ? 0 : count) - start) / step;
    const double leave = ((step > 0 ? count : 0) - start) / step;
    t = std::max(t, enter);
    end = std::min(end, leave);
    return t < end;
  }

  Point low_;
  int columns_, rows_;
  Point cell_;
};

}  // namespace wander
