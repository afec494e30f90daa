// What the writer and the reader of trajectories agree on.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace wander {

inline constexpr const char* trajectory_format = "wanderlight-trajectory/1";

// The names of the film coordinates.
inline std::vector<std::string> film_names(int dimension) {
  if (dimension == 2) return {"sensor_u"};
  return {"raster_x", "raster_y"};
}

// Column `index` of `count` in a table that is laid out row by row.
inline std::vector<double> column_of(const std::vector<double>& table, std::size_t index,
                                     std::size_t count) {
  std::vector<double> column;
  column.reserve(table.size() / count);
  for (std::size_t i = index; i < table.size(); i += count) column.push_back(table[i]);
  return column;
}

}  // namespace wander
