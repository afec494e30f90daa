// Where in a bidirectional sample random numbers are consumed.  A walk takes as many as its
// vertices need; a source that keeps its numbers by place gives every vertex its own, however many
// the vertices before it took.
#pragma once

namespace wander {

// The two walks, and the ends that are sampled anew for a connection: x_0 of a technique (1, t),
// and x_{n-1} of a technique (s, 1).
enum class Subpath { light, sensor, light_end, sensor_end };

// The numbers that make one vertex: the roulette before it, its direction or position, and which
// lobe or light.
struct RandomPlace {
  Subpath subpath;
  int vertex;  // counted from the subpath's beginning; for an end, that of the other walk's
               // vertices
};

// Says that the next numbers are those of `place`; a plain generator need not know.
template <class Random>
void seek(Random& random, RandomPlace place) {
  if constexpr (requires { random.seek(place); }) random.seek(place);
}

}  // namespace wander
