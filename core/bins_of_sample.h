// Which bins of the film the paths of one bidirectional sample show.  Those with two vertices and more from the
// sensor share their walk from it, so they end alike and are looked up once; the others end where one vertex of
// the sensor is connected (path_sampler.h).
#pragma once

#include "core/joined_path.h"

namespace wander {

template <class Space>
class BinsOfSample {
 public:
  using W = typename Space::Universe;

  explicit BinsOfSample(Space space) : space_(space) {}

  void begin() { is_known_ = false; }
  // Of a path that has s vertices from the light.
  int operator()(const JoinedPath<W>& x, int s) {
    if (x.size() - s < 2) return space_.bin(x.ends());
    if (!is_known_) bin_ = space_.bin(x.ends());
    is_known_ = true;
    return bin_;
  }

 private:
  Space space_;
  bool is_known_ = false;
  int bin_ = 0;
};

}  // namespace wander
