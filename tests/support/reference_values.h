// Exact answers of six small scenes of the plane, verified by programs of their own and by particle
// tracing: the numbers that every oracle and every method has to reproduce.
//
// Radiance in W/(m rad), irradiance in W/m; Lambert ρ/2, G = cos cos / r.  Film values are mean
// irradiances over bins.  Segments run so that their normal, the direction turned left, is the side
// that emits or listens.  Except in E, everything but mirror and interface is black.
#pragma once

#include <array>
#include <limits>

#include "core/exact/plane.h"

namespace wander::test::reference {

using namespace exact;

// A. An emitter parallel to the sensor's line; direct light.
namespace parallel_emitter {
inline constexpr PlaneSegment emitter{{1, 1}, {-1, 1}};
inline constexpr double radiance = 1;
inline constexpr PlaneSegment sensor{{0, 0}, {2, 0}};
inline constexpr std::array<double, 4> film{1.3694832979641998, 1.1026526570353798,
                                            0.6769608746351343, 0.34703136595585526};
inline constexpr PlanePoint point{0.25, 0};
inline constexpr double point_irradiance = 1.38086880944303;
inline constexpr double tolerance = 1e-13;
}  // namespace parallel_emitter

// B. The same with a black blocker half way; direct light.
namespace blocker {
inline constexpr PlaneSegment emitter{{1, 2}, {-1, 2}};
inline constexpr double radiance = 1;
inline constexpr PlaneSegment obstacle{{-0.25, 1}, {0.5, 1}};
inline constexpr PlaneSegment sensor{{-1, 0}, {1, 0}};
inline constexpr std::array<double, 8> film{0.590121793299, 0.532983832319, 0.420898119700,
                                            0.277162539064, 0.191916727975, 0.212841691408,
                                            0.307059128554, 0.411288077680};
inline constexpr double tolerance = 6e-13;
}  // namespace blocker

// C. A mirror below a sensor that looks down, and an emitter between them that faces the mirror.
// The sensor's bins are listed by rising x, against its direction: bin i of a film of `sensor` is
// film[7 - i].
namespace mirror {
inline constexpr PlaneSegment reflector{{-0.5, -1}, {0.5, -1}};
inline constexpr double reflectance = 0.9;
inline constexpr PlaneSegment emitter{{0.75, -0.5}, {0.25, -0.5}};
inline constexpr double radiance = 1;
inline constexpr PlaneSegment sensor{{1, 0}, {-1, 0}};
inline constexpr std::array<double, 8> film{
    0.121604362268, 0.154919771913, 0.193948661534, 0.234995245551, 0.137974902481, 0, 0, 0};
inline constexpr double tolerance = 6e-13;
}  // namespace mirror

// D. A sensor inside glass, an emitter outside.  `without_index_factor` is what a gather that
// forgets the radiance factor η_t/η_i would read: a wrong answer, to be told apart.
namespace refraction {
inline constexpr PlaneSegment interface {
  {-5, 0}, { 5, 0 }
};
inline constexpr double index_above = 1, index_below = 1.5;
inline constexpr PlaneSegment emitter{{1, 1}, {-1, 1}};
inline constexpr double radiance = 1;
inline constexpr PlaneSegment sensor{{0, -1}, {2, -1}};
inline constexpr std::array<double, 4> film{0.99219692255, 0.86583548641, 0.66287042584,
                                            0.45342726144};
inline constexpr std::array<double, 4> without_index_factor{0.661465, 0.577224, 0.441914, 0.302285};
inline constexpr double tolerance = 6e-12;
}  // namespace refraction

// E. The unit square, closed; the floor also emits.  Mean irradiance of each wall by the largest
// number of edges of a path (vertices - 1); walls in the order floor, right, ceiling, left, each
// with its front inside.
namespace cavity {
inline constexpr std::array<PlaneSegment, 4> walls{
    PlaneSegment{{0, 0}, {1, 0}}, PlaneSegment{{1, 0}, {1, 1}}, PlaneSegment{{1, 1}, {0, 1}},
    PlaneSegment{{0, 1}, {0, 0}}};
inline constexpr double floor_radiance = 1;
inline constexpr double tolerance = 2e-10;
inline constexpr int unlimited = std::numeric_limits<int>::max();

struct Row {
  int max_edges;
  double floor, side, ceiling;
};
inline constexpr std::array<double, 4> grey{0.5, 0.5, 0.5, 0.5};  // reflectances
inline constexpr std::array<Row, 7> grey_irradiance{{
    {1, 0, 0.5857864376, 0.8284271247},
    {2, 0.3654719845, 0.8276153714, 0.9792972727},
    {3, 0.4642750129, 0.9534765737, 1.1287718396},
    {4, 0.5332752901, 1.0158758880, 1.1849729339},
    {8, 0.5906192496, 1.0744810516, 1.2447936473},
    {16, 0.5945055064, 1.0783720493, 1.2486893598},
    {unlimited, 0.5945207652, 1.0783873081, 1.2487046187},
}};
inline constexpr std::array<double, 4> mixed{0.2, 0.8, 0.5, 0.8};
inline constexpr std::array<Row, 7> mixed_irradiance{{
    {1, 0, 0.5857864376, 0.8284271247},
    {2, 0.4813243980, 0.9001640515, 1.0698193615},
    {3, 0.6740165088, 1.0681352810, 1.2611499719},
    {4, 0.7917618212, 1.1632372645, 1.3561583872},
    {8, 0.9208826112, 1.2700173098, 1.4680181451},
    {16, 0.9343971570, 1.2811715336, 1.4796408902},
    {unlimited, 0.9345210075, 1.2812737502, 1.4797473878},
}};
}  // namespace cavity

// F. A floor and an emitting wall that share a corner, where G diverges and the irradiance does
// not.
namespace corner {
inline constexpr PlaneSegment emitter{{0, 1}, {0, 0}};  // faces +x
inline constexpr double radiance = 1;
struct Bin {
  double from, to, mean_irradiance;
};
inline constexpr std::array<Bin, 4> floor_bins{{{0, 1e-6, 0.9999995},
                                                {0, 0.125, 0.9377422517014503},
                                                {0.125, 0.25, 0.8160464970632286},
                                                {0.875, 1, 0.31643731374988915}}};
inline constexpr double tolerance = 1e-13;
}  // namespace corner

}  // namespace wander::test::reference
