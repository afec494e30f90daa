// A path of a bidirectional sample, as it is handed on: two subpaths that stay where they are, and a copy of
// the vertices that the edge between them changes, and of the two that the film sees.  Whoever asks for the
// whole path gets the others copied, too; with many connections most is not asked for.
#pragma once

#include "core/path.h"

namespace wander {

template <class W>
class JoinedPath {
 public:
  // `joined` has its vertices from `begin` to `end` - 1 and the last two; before are those of `light`, and
  // behind those of `sensor`, a path of at least its size that ends alike.
  JoinedPath(Path<W>& joined, const Path<W>& light, int begin, const Path<W>& sensor, int end)
      : joined_(joined), light_(light), sensor_(sensor), begin_(begin), end_(end) {}

  void shows(const typename W::Tint& product) { tint_ = product; }

  int size() const { return joined_.size(); }
  // What a deposit of luminance 1 on behalf of this path shows.
  typename W::Tint colour() const {
    if constexpr (W::Tint::channels == 1)
      return {};
    else
      return W::Tint::of(tint_.colour);
  }
  const Vertex<W>& operator[](int i) const {
    if (i < begin_) return light_[i];
    return i < end_ || i + 2 >= size() ? joined_[i] : sensor_[sensor_.size() - size() + i];
  }
  // Of which the last two vertices can be read.
  const Path<W>& ends() const { return joined_; }
  const Path<W>& whole() const {
    if (is_whole_) return joined_;
    is_whole_ = true;
    joined_.copy(light_, 0, begin_, 0);
    const int count = size() - 2 - end_;
    if (count > 0) joined_.copy(sensor_, sensor_.size() - 2 - count, count, end_);
    return joined_;
  }
  operator const Path<W>&() const { return whole(); }

 private:
  Path<W>& joined_;
  const Path<W>&light_, &sensor_;
  int begin_, end_;
  [[no_unique_address]] typename W::Tint tint_{};  // Π tint_i, but for a factor
  mutable bool is_whole_ = false;
};

}  // namespace wander
