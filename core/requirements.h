// What a scene requires of the program: which kinds of transport and geometry it can use.  A scene
// pays only for what is listed here.
#pragma once

#include <string>
#include <vector>

#include "core/description.h"

namespace wander {

struct Requirements {
  int dimension = 2;
  int colour_channels = 1;  // 3 when some number that describes light is coloured
  std::vector<std::string> materials, shapes;  // types present on shapes, each once, sorted
  bool specular = false;                       // some surface reflects or refracts as a mirror does
  double narrowest_lobe =
      1;  // about that direction, a share of all: α^(D-1); 0 where one is specular
  bool caustic_paths_possible = false;  // light, then specular, then a surface it can fall on
  bool scatters = false;                // some surface reflects or refracts into many directions
  bool glossy = false;                  // of these, some are rough mirrors or rough glass
  bool smooth_normals = false;          // some mesh is shaded by normals that are not its own
  bool textures = false;                // some surface reflects what a picture says
  int max_vertices = 0;
};

Requirements requires_of(const description::Scene& scene);

// Of the film, without its channels: the number of bins, or height and width.
std::vector<int> film_resolution(const description::Scene& scene);
// How its values are laid out (tint.h): the same, and three channels where there is colour.
std::vector<int> film_shape(const description::Scene& scene);

// As scene files call it: "segment", "arc", ...; "diffuse", "mirror", ...
std::string type_of(const description::ShapeKind& kind);
std::string type_of(const description::MaterialKind& kind);

}  // namespace wander
