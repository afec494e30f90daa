// What a proposal that failed came to.  A mutation answers with a reason alone; here it proposes
// once more, with the same random numbers, in a space that watches what it does.
//
// Recorded are the walks, each from the vertex where it begins, kept or new, to the last one that
// it reached; a ray that met nothing, as far as the scene is wide; and the connection that was
// tried.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/transport.h"

namespace wander {

class Attempt {
 public:
  using Point = std::array<double, 3>;
  static constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  static constexpr Point nowhere{no_number, no_number, no_number};
  // Of paths up to this long: both walks, a ray and a connection, and what is between them.
  static constexpr std::size_t most_points(int max_vertices) {
    return 2 * static_cast<std::size_t>(max_vertices) + 8;
  }

  void clear() {
    points_.clear();
    failure_ = nowhere;
    tip_ = -1;
  }
  // A walk begins at vertex i of its path, and goes on.
  void begin(Point p, int i) {
    if (!points_.empty()) points_.push_back(nowhere);
    points_.push_back(failure_ = p);
    tip_ = i;
  }
  void extend(Point p, int i) {
    points_.push_back(failure_ = p);
    tip_ = i;
  }
  bool is_at(int i) const { return tip_ == i; }
  // What is looked at last before a proposal fails is where it fails.
  void look_at(Point p) { failure_ = p; }
  // Nothing failed on the way: the whole path was weighed, and refused.
  void was_complete() { failure_ = nowhere; }

  const std::vector<Point>& points() const { return points_; }  // `nowhere` between walks
  Point failure() const { return failure_; }

 private:
  std::vector<Point> points_;
  Point failure_ = nowhere;
  int tip_ = -1;  // index of the last vertex of the walk
};

// The vocabulary of a space (core/transport.h), written down.
template <class Space>
class WatchedSpace : public Space {
 public:
  using W = typename Space::Universe;

  WatchedSpace(const Space& space, Attempt& attempt)
      : Space(space), attempt_(&attempt), size_(size_of(space.scene().bounds())) {}

  template <class Numbers>
  void begin_light(Path<W>& x, int i, Numbers&& numbers) const {
    Space::begin_light(x, i, numbers);
    attempt_->begin(point(x, i), i);
  }
  template <class Numbers>
  void begin_sensor(Path<W>& x, int i, Numbers&& numbers) const {
    Space::begin_sensor(x, i, numbers);
    attempt_->begin(point(x, i), i);
  }
  void move_end(Path<W>& x, int i, typename W::Square u) const {
    Space::move_end(x, i, u);
    attempt_->begin(point(x, i), i);
  }
  template <class Numbers>
  bool extend(Path<W>& x, int i, Toward toward, Numbers&& numbers) const {
    return watch(x, i, toward, [&] { return Space::extend(x, i, toward, numbers); });
  }
  bool shoot(Path<W>& x, int i, Toward toward, typename W::Direction direction) const {
    return watch(x, i, toward, [&] { return Space::shoot(x, i, toward, direction); });
  }
  bool aim_film(Path<W>& x, int i, typename W::Square film) const {
    return watch(x, i, Toward::light, [&] { return Space::aim_film(x, i, film); });
  }
  bool follow(Path<W>& x, int i, Toward toward, Event event) const {
    return watch(x, i, toward, [&] { return Space::follow(x, i, toward, event); });
  }
  Connection connect(Path<W>& x, int i) const {
    const Connection connection = Space::connect(x, i);
    attempt_->begin(point(x, i), i);
    attempt_->extend(point(x, i + 1), i + 1);
    if (connection != Connection::open) attempt_->look_at(obstacle(x, i));
    return connection;
  }
  void evaluate(Path<W>& x, int i) const {
    Space::evaluate(x, i);
    attempt_->look_at(point(x, i));
  }
  bool can_connect(const Vertex<W>& v) const { return see(v, Space::can_connect(v)); }
  bool is_light(const Vertex<W>& v) const { return see(v, Space::is_light(v)); }
  bool is_sensor(const Vertex<W>& v) const { return see(v, Space::is_sensor(v)); }
  typename W::Square end_parameter(const Path<W>& x, int i) const {
    attempt_->look_at(point(x, i));
    return Space::end_parameter(x, i);
  }
  typename W::Square film_position(const Path<W>& x) const {
    attempt_->look_at(point(x, x.size() - 1));
    return Space::film_position(x);
  }

 private:
  using Position = typename W::Point;

  static double size_of(const Box<W>& box) {
    return static_cast<double>(glm::distance(box.low, box.high));
  }
  static Attempt::Point point(const Position& p) {
    Attempt::Point q = Attempt::nowhere;
    for (int k = 0; k < W::dimension; ++k) q[static_cast<std::size_t>(k)] = double(p[k]);
    return q;
  }
  static Attempt::Point point(const Path<W>& x, int i) { return point(x[i].place.position); }

  bool see(const Vertex<W>& v, bool answer) const {
    if (!answer) attempt_->look_at(point(v.place.position));
    return answer;
  }

  // A ray leaves its direction with the edge even if it meets nothing.
  template <class Shot>
  bool watch(Path<W>& x, int i, Toward toward, Shot&& shot) const {
    using Length = typename W::Length;
    const int step = toward == Toward::sensor ? 1 : -1;
    if (!attempt_->is_at(i)) attempt_->begin(point(x, i), i);
    auto& edge = x[std::min(i, i + step)].place.to_sensor;
    edge = typename W::Direction(std::numeric_limits<Length>::quiet_NaN());
    const bool met = shot();
    if (met)
      attempt_->extend(point(x, i + step), i + step);
    else if (std::isfinite(edge[0]))
      attempt_->extend(point(x[i].place.position + edge * static_cast<Length>(step * size_)),
                       i + step);
    else
      attempt_->look_at(point(x, i));
    return met;
  }

  // What blocks the connection; the middle of one whose ends face away from each other.
  Attempt::Point obstacle(const Path<W>& x, int i) const {
    const auto &a = x[i].place, &b = x[i + 1].place;
    const auto offset = b.position - a.position;
    const Ray<W> ray{.origin = a.position,
                     .direction = offset,
                     .from = a.element(),
                     .to = b.element(),
                     .limit = 1};
    const Hit<W> hit = this->scene().closest(ray);
    const auto share =
        static_cast<typename W::Length>(hit && hit.distance < 1 ? hit.distance : 0.5);
    return point(a.position + offset * share);
  }

  Attempt* attempt_;
  double size_;
};

}  // namespace wander
