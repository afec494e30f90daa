// What happens to light at a vertex of a path.
#pragma once

#include <cstdint>

namespace wander {

enum class Event : std::uint8_t {
  emission,      // the first vertex, on a light
  scattering,    // not specular: a density over directions
  reflection,    // specular
  transmission,  // specular
  detection,     // the last vertex, on the sensor
};

constexpr bool is_specular(Event e) { return e == Event::reflection || e == Event::transmission; }

// Letter of the event in the class of a path, such as LDSE (Heckbert's notation, light first).
constexpr char letter(Event e) {
  switch (e) {
    case Event::emission:
      return 'L';
    case Event::scattering:
      return 'D';
    case Event::detection:
      return 'E';
    default:
      return 'S';
  }
}

// The end of a path that a subpath walks towards.
enum class Toward : std::uint8_t { sensor, light };

}  // namespace wander
