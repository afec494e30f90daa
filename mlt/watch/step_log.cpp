#include "mlt/watch/step_log.h"

#include <algorithm>

namespace wander {

namespace {

// Doubles at least, so that many calls copy little.
template <class T>
void make_room(std::vector<T>& column, std::size_t more) {
  const std::size_t needed = column.size() + more;
  if (column.capacity() < needed) column.reserve(std::max(needed, 2 * column.size()));
}

}  // namespace

void StepLog::reserve(std::uint64_t steps, int max_vertices, int dimension) {
  const std::size_t vertices = 2 * steps * static_cast<std::size_t>(max_vertices);
  make_room(steps_, steps);
  make_room(events_, vertices);
  make_room(attempts_, steps * Attempt::most_points(max_vertices));
  make_room(positions_, vertices * static_cast<std::size_t>(dimension));
}

}  // namespace wander
