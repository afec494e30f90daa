// Bidirectional path sampling [Veach 1997, ch. 10]: one subpath from a light, one from the sensor,
// and every connection of the two that a set of techniques allows.  With other sets the same text
// is path tracing (s <= 1), light tracing (t <= 1), their naive forms (s = 0, t = 0) and each
// single technique.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/random_place.h"
#include "core/techniques.h"
#include "core/transport.h"

namespace wander {

template <class Space>
class PathSampler {
 public:
  using W = typename Space::Universe;

  PathSampler(Space space, TechniqueSet set, Heuristic heuristic)
      : space_(space),
        set_(set),
        heuristic_(heuristic),
        longest_(space.max_vertices()),
        light_(longest_),
        sensor_(longest_),
        light_end_(longest_),
        sensor_end_(longest_),
        joined_(longest_) {
    light_.resize(longest_);
    sensor_.resize(longest_);
  }

  // Segments of subpaths and connections that were tried, of all samples: what they cost.
  std::uint64_t rays() const { return rays_; }

  // Calls sink(path, s, w f / p) for every path of one pair of subpaths that contributes.  The sum
  // over a sample has the expectation b = ∫ f.
  template <class Random, class Sink>
  void sample(Random& random, Sink&& sink) {
    walk_from_light(random);
    walk_from_sensor(random);
    for (int t = std::max(2, set_.fewest_sensor); t <= sensor_count_; ++t) hit_light(t, sink);
    for (int s = std::max(2, set_.fewest_light); s <= light_count_; ++s) hit_sensor(s, sink);
    for (int t = 1; t <= sensor_count_; ++t) {
      if (!space_.can_connect(sensor_[sensor_index(t)])) continue;
      const int most = std::min(light_count_, longest_ - t);
      for (int s = 1; s <= most; ++s)
        if (set_.holds(s, t) && space_.can_connect(light_[s - 1])) connect(s, t, random, sink);
    }
  }

 private:
  int sensor_index(int t) const { return longest_ - t; }  // of the t-th vertex from the sensor

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
    light_count_ = std::min({set_.most_light, longest_});
    if (light_count_ == 0) return;
    seek(random, {Subpath::light, 0});
    space_.begin_light(light_, 0, random);
    // Only a technique without sensor vertices needs the last one.
    if (set_.fewest_sensor > 0)
      light_count_ = std::min(light_count_, longest_ - set_.fewest_sensor);
    light_count_ = walk(light_, 0, Toward::sensor, light_count_, random);
  }
  template <class Random>
  void walk_from_sensor(Random& random) {
    sensor_count_ = std::min(set_.most_sensor, longest_);
    if (sensor_count_ == 0) return;
    seek(random, {Subpath::sensor, 0});
    space_.begin_sensor(sensor_, sensor_index(1), random);
    if (set_.fewest_light > 0)
      sensor_count_ = std::min(sensor_count_, longest_ - set_.fewest_light);
    sensor_count_ = walk(sensor_, sensor_index(1), Toward::light, sensor_count_, random);
  }

  template <class Sink>
  void hit_light(int t, Sink&& sink) {
    if (!set_.holds(0, t) || !space_.is_light(sensor_[sensor_index(t)])) return;
    joined_.resize(t);
    joined_.copy(sensor_, sensor_index(t), t, 0);
    joined_[0].event = Event::emission;
    space_.evaluate(joined_, 0);
    deliver(0, sink);
  }
  template <class Sink>
  void hit_sensor(int s, Sink&& sink) {
    if (!set_.holds(s, 0) || !space_.is_sensor(light_[s - 1])) return;
    joined_.resize(s);
    joined_.copy(light_, 0, s, 0);
    joined_[s - 1].event = Event::detection;
    space_.evaluate(joined_, s - 1);
    deliver(s, sink);
  }
  // The only vertex of a subpath is sampled anew for each partner: its samples are as good, and
  // independent.
  template <class Random, class Sink>
  void connect(int s, int t, Random& random, Sink&& sink) {
    const int of_light = s - 1, of_sensor = sensor_index(t);
    if (s == 1 && t > 1) {
      seek(random, {Subpath::light_end, t});
      space_.begin_light(light_end_, 0, random);
    }
    if (t == 1 && s > 1) {
      seek(random, {Subpath::sensor_end, s});
      space_.begin_sensor(sensor_end_, of_sensor, random);
    }
    const Path<W>& light = s == 1 && t > 1 ? light_end_ : light_;
    const Path<W>& sensor = t == 1 && s > 1 ? sensor_end_ : sensor_;
    if (!space_.may_connect(light, of_light, sensor, of_sensor)) return;
    joined_.resize(s + t);
    joined_[s - 1] = light[of_light];
    joined_[s] = sensor[of_sensor];
    ++rays_;
    if (space_.connect(joined_, s - 1) != Connection::open) return;
    joined_.copy(light_, 0, s - 1, 0);
    joined_.copy(sensor_, sensor_index(t - 1), t - 1, s + 1);
    space_.evaluate(joined_, s - 1);
    space_.evaluate(joined_, s);
    deliver(s, sink);
  }
  template <class Sink>
  void deliver(int s, Sink&& sink) {
    const double weighted = weighted_contribution(space_, joined_, s, set_, heuristic_);
    if (weighted > 0) sink(std::as_const(joined_), s, weighted);
  }

  Space space_;
  TechniqueSet set_;
  Heuristic heuristic_;
  int longest_;
  Path<W> light_, sensor_, light_end_, sensor_end_, joined_;
  int light_count_ = 0, sensor_count_ = 0;
  std::uint64_t rays_ = 0;
};

}  // namespace wander
