#include "core/light_walks.h"

#include <boost/random/sobol.hpp>
#include <boost/random/uniform_01.hpp>

namespace wander {

EvenPoints::EvenPoints(std::uint64_t count) : points_(count) {
  boost::random::sobol sequence(dimensions);
  boost::random::uniform_01<double> unit;
  for (Point& point : points_)
    for (double& coordinate : point) coordinate = unit(sequence);
}

}  // namespace wander
