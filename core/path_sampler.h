// Bidirectional path sampling [Veach 1997, ch. 10]: one subpath from a light, one from the sensor,
// and every connection of the two that a set of techniques allows.  With other sets the same text
// is path tracing (s <= 1), light tracing (t <= 1), their naive forms (s = 0, t = 0) and each
// single technique.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/joined_path.h"
#include "core/path_sides.h"
#include "core/random_place.h"
#include "core/transport.h"

namespace wander {

template <class Space>
class PathSampler {
 public:
  using W = typename Space::Universe;

  PathSampler(Space space, TechniqueSet set, Heuristic heuristic)
      : space_(space),
        by_{set, heuristic},
        longest_(space.max_vertices()),
        light_(longest_),
        sensor_(longest_),
        light_end_(longest_),
        sensor_end_(longest_),
        joined_(longest_),
        light_sides_(longest_),
        sensor_sides_(longest_) {
    light_.resize(longest_);
    sensor_.resize(longest_);
  }

  // Segments of subpaths and connections that were tried, of all samples: what they cost.
  std::uint64_t rays() const { return rays_; }

  // Calls sink(path, s, w f / p) with a JoinedPath for every path of one pair of subpaths that contributes.
  // The sum over a sample has the expectation b = ∫ f.
  template <class Random, class Sink>
  void sample(Random& random, Sink&& sink) {
    walk(random);
    for (int t = std::max(2, by_.set.fewest_sensor); t <= sensor_count_; ++t) hit_light(t, sink);
    for (int s = std::max(2, by_.set.fewest_light); s <= light_count_; ++s) hit_sensor(s, sink);
    for (int t = 1; t <= sensor_count_; ++t) {
      if (!space_.can_connect(sensor_[sensor_index(t)])) continue;
      for (int s = 1; s <= most_light(t); ++s) {
        if (!may_join(s, t)) continue;
        draw_end(s, t, random);
        connect(s, t, sink);
      }
    }
  }

  // Of the same sample only the path of technique (s,t), at the cost of its vertices.
  template <class Random, class Sink>
  void sample_only(int s, int t, Random& random, Sink&& sink) {
    walk(random);
    if (t > sensor_count_ || s > light_count_) return;
    if (s == 0) return hit_light(t, sink);
    if (t == 0) return hit_sensor(s, sink);
    if (!may_join(s, t)) return;
    if (draws_end(s, t))
      for_each_end([&](int i, int j) {
        draw_end(i, j, random);
        return i != s || j != t;
      });
    connect(s, t, sink);
  }

  // Takes the numbers of a sample from their source, and connects nothing.
  template <class Random>
  void draw(Random& random) {
    walk(random);
    for_each_end([&](int s, int t) {
      draw_end(s, t, random);
      return true;
    });
  }

 private:
  int sensor_index(int t) const { return longest_ - t; }  // of the t-th vertex from the sensor
  int most_light(int t) const { return std::min(light_count_, longest_ - t); }
  bool may_join(int s, int t) const {
    return by_.set.holds(s, t) && space_.can_connect(light_[s - 1]) &&
           space_.can_connect(sensor_[sensor_index(t)]);
  }

  // ---- subpaths

  template <class Random>
  void walk(Random& random) {
    walk_from_light(random);
    walk_from_sensor(random);
    light_sides_.clear();
    sensor_sides_.clear();
  }

  // Extends the subpath from x_i as long as the roulette and the scene allow.
  template <class Random>
  int walk(Path<W>& x, int i, Toward toward, int most, Random& random) {
    const int step = toward == Toward::sensor ? 1 : -1;
    const Subpath subpath = toward == Toward::sensor ? Subpath::light : Subpath::sensor;
    int count = 1;
    for (; count < most; ++count, i += step) {
      seek(random, {subpath, count});
      const double q = space_.survival(x[i]);
      if (q < 1 && !(random.uniform() < q)) break;
      ++rays_;
      if (!space_.extend(x, i, toward, random)) break;
      space_.evaluate(x, i);
      if (!(x[i].value > 0)) break;
    }
    return count;
  }
  template <class Random>
  void walk_from_light(Random& random) {
    light_count_ = std::min({by_.set.most_light, longest_});
    if (light_count_ == 0) return;
    seek(random, {Subpath::light, 0});
    space_.begin_light(light_, 0, random);
    // Only a technique without sensor vertices needs the last one.
    if (by_.set.fewest_sensor > 0)
      light_count_ = std::min(light_count_, longest_ - by_.set.fewest_sensor);
    light_count_ = walk(light_, 0, Toward::sensor, light_count_, random);
  }
  template <class Random>
  void walk_from_sensor(Random& random) {
    sensor_count_ = std::min(by_.set.most_sensor, longest_);
    if (sensor_count_ == 0) return;
    seek(random, {Subpath::sensor, 0});
    space_.begin_sensor(sensor_, sensor_index(1), random);
    if (by_.set.fewest_light > 0)
      sensor_count_ = std::min(sensor_count_, longest_ - by_.set.fewest_light);
    sensor_count_ = walk(sensor_, sensor_index(1), Toward::light, sensor_count_, random);
  }

  // ---- ends of connections
  //
  // The only vertex of a subpath is sampled anew for each partner: its samples are as good, and independent.

  static bool draws_end(int s, int t) { return (s == 1) != (t == 1); }
  template <class Random>
  void draw_end(int s, int t, Random& random) {
    if (s == 1 && t > 1) {
      seek(random, {Subpath::light_end, t});
      space_.begin_light(light_end_, 0, random);
    }
    if (t == 1 && s > 1) {
      seek(random, {Subpath::sensor_end, s});
      space_.begin_sensor(sensor_end_, sensor_index(1), random);
    }
  }
  // f(s,t) for the connections of a sample that draw an end, in their order, as long as it says so.
  template <class F>
  void for_each_end(F&& f) const {
    if (sensor_count_ > 0)
      for (int s = 2; s <= most_light(1); ++s)
        if (may_join(s, 1) && !f(s, 1)) return;
    for (int t = 2; t <= sensor_count_ && most_light(t) > 0; ++t)
      if (may_join(1, t) && !f(1, t)) return;
  }

  // ---- paths

  template <class Sink>
  void hit_light(int t, Sink&& sink) {
    if (!by_.set.holds(0, t) || !space_.is_light(sensor_[sensor_index(t)])) return;
    joined_.resize(t);
    take_neighbours(0, t);
    joined_[0] = sensor_[sensor_index(t)];
    joined_[0].event = Event::emission;
    deliver(0, t, sink);
  }
  template <class Sink>
  void hit_sensor(int s, Sink&& sink) {
    if (!by_.set.holds(s, 0) || !space_.is_sensor(light_[s - 1])) return;
    joined_.resize(s);
    take_neighbours(s, 0);
    joined_[s - 1] = light_[s - 1];
    joined_[s - 1].event = Event::detection;
    deliver(s, 0, sink);
  }
  template <class Sink>
  void connect(int s, int t, Sink&& sink) {
    const int of_light = s - 1, of_sensor = sensor_index(t);
    const Path<W>& light = s == 1 && t > 1 ? light_end_ : light_;
    const Path<W>& sensor = t == 1 && s > 1 ? sensor_end_ : sensor_;
    if (!space_.may_connect(light, of_light, sensor, of_sensor)) return;
    joined_.resize(s + t);
    joined_[s - 1] = light[of_light];
    joined_[s] = sensor[of_sensor];
    ++rays_;
    if (space_.connect(joined_, s - 1) != Connection::open) return;
    take_neighbours(s, t);
    deliver(s, t, sink);
  }
  // Beside x_{s-1} and x_s, the ends of an edge, so much of both subpaths that their sides can be measured,
  // and what the film sees.
  static constexpr int beside = 3;  // with the end itself
  int begin_beside(int s) const { return std::max(s - beside, 0); }
  int end_beside(int s, int t) const { return s + std::min(t, beside); }
  void take_neighbours(int s, int t) {
    const int n = s + t, begin = begin_beside(s), end = end_beside(s, t);
    if (s > 1) joined_.copy(light_, begin, s - 1 - begin, begin);
    if (t > 1) joined_.copy(sensor_, sensor_index(t - 1), end - s - 1, s + 1);
    for (int i = std::max(end, n - 2); i < n; ++i) joined_[i] = sensor_[sensor_index(n - i)];
  }
  // The path, once the ends of its edge and their neighbours are there.
  template <class Sink>
  void deliver(int s, int t, Sink&& sink) {
    if (s > 0) space_.evaluate(joined_, s - 1);
    if (t > 0) space_.evaluate(joined_, s);

    JoinedPath<W> path(joined_, light_, begin_beside(s), sensor_, end_beside(s, t));
    // What both neighbours of are on a subpath does not depend on the edge, unless how many techniques
    // there are does.
    const bool is_known = by_.set == all_techniques;
    if (!is_known) path.whole();
    const int of_light = is_known ? std::max(s - 2, 0) : 0;
    const int of_sensor = is_known ? std::max(t - 2, 0) : 0;
    PathSides<W> sides{light_sides_.first(of_light,
                                          [&](PathSide<W>& side, int i) {
                                            add_light_vertex(side, space_, light_, i, by_);
                                          }),
                       sensor_sides_.first(of_sensor, [&](PathSide<W>& side, int k) {
                         add_sensor_vertex(side, space_, sensor_, sensor_index(k + 1), by_);
                       })};
    for (int i = of_light; i < s; ++i) add_light_vertex(sides.light, space_, joined_, i, by_);
    for (int i = s + t - 1 - of_sensor; i >= s; --i)
      add_sensor_vertex(sides.sensor, space_, joined_, i, by_);
    const double weighted = weighted_contribution(joined_, s, sides);
    if (!(weighted > 0)) return;
    path.shows(sides.tint());
    sink(std::as_const(path), s, weighted);
  }

  Space space_;
  Weighing by_;
  int longest_;
  Path<W> light_, sensor_, light_end_, sensor_end_, joined_;
  KnownPathSides<W> light_sides_, sensor_sides_;
  int light_count_ = 0, sensor_count_ = 0;
  std::uint64_t rays_ = 0;
};

}  // namespace wander
