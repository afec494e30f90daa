#include "mlt/check/path_functions.h"

namespace wander {

namespace {

std::string part_of_film(std::size_t part, std::size_t parts) {
  return "part " + std::to_string(part + 1) + " of " + std::to_string(parts) + " of the film";
}
std::string vertices(std::size_t length_class) {
  return "paths of " + std::to_string(length_class + 2) +
         (length_class + 1 == length_classes ? " and more vertices" : " vertices");
}

}  // namespace

std::string name_of_function(std::size_t k) {
  if (k < film_stripes * length_classes)
    return vertices(k / film_stripes) + " on " + part_of_film(k % film_stripes, film_stripes);
  k -= film_stripes * length_classes;
  if (k < 3 * waves) {
    constexpr std::array places{"on the light", "before the sensor", "in the middle"};
    return std::string("place of the vertex ") + places[k / waves];
  }
  constexpr std::array rest{
      "direction at the light",          "obliqueness at the light",   "direction at the sensor",
      "obliqueness at the sensor",       "very short edges",           "short edges",
      "number of vertices of the paths", "number of specular vertices"};
  return rest[k - 3 * waves];
}

std::string name_of_cell(std::size_t k) {
  return vertices(k / 2 % length_classes) + " on " + part_of_film(k / 2 / length_classes, 2) +
         (k % 2 == 0 ? " from one half of the light" : " from the other half of the light");
}

}  // namespace wander
