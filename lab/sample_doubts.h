// Doubts about what independent samples found, each with its remedy, where what was seen is no evidence of what was
// not (core/film.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/film.h"
#include "core/scene.h"
#include "records/rendering.h"

namespace wander {

// No mirror can be connected to, so a path that has nothing else next to one of its ends is found only by a subpath that meets
// this end by chance: the lamp (the sensor subpaths of pt), the sensor (the light subpaths of lt), or where subpaths begin
// at both, either of them.  A camera no light subpath meets.  `nowhere`: there is no such light.
enum class MetByChance { nowhere, lights, sensors, either, camera };

// What a method that finds it so has to meet in a scene, unless its connections find it.  Of those to a surface that is nearly
// smooth a share of about `lobe` (Scene::narrowest_lobe) arrives in the lobe, and carries all.
struct FoundByChance {
  MetByChance end = MetByChance::nowhere;
  double lobe = 0;
};

// Of connections to a surface with such a lobe next to none arrive in it, of ten million ten.
inline constexpr double lobe_of_hardly_any = 1e-6;

// What a method never finds, or hardly ever, is said elsewhere (Method::why_blind).
template <World W>
FoundByChance found_by_chance(const Scene<W>& scene, MetByChance of_method) {
  const double lobe = scene.narrowest_lobe();
  if (lobe == 1 || scene.max_vertices() < 3) return {};
  if (!scene.camera() || of_method == MetByChance::lights) return {of_method, lobe};
  if (of_method == MetByChance::sensors && lobe > lobe_of_hardly_any)
    return {MetByChance::camera, lobe};
  return {};
}

// Of bins that samples enough have found, those that are not reliable for light that techniques seldom find (without_rare_light()).
struct DoubtedBins {
  std::size_t seen = 0, doubtful = 0;
};
DoubtedBins doubted_bins(const FilmEstimate& film, const TechniqueTally& techniques,
                         std::uint64_t samples);

// Why they are called unreliable.  Empty where most have no such doubt.
std::string rare_techniques(const TechniqueTally& techniques, const FilmEstimate& film,
                            std::uint64_t samples);

// Of a film whose samples met the ends that light needs to be met by chance so often: if that is hardly ever, and hardly any
// connection can have found it, no bin of it is reliable, and it says so.
void doubt_what_was_not_met(Rendering& rendering, const FoundByChance& what, const BinSums& met,
                            std::uint64_t samples);

// What there is to say against a film of independent samples.
void add_doubts(Rendering& rendering, const TechniqueTally& techniques, const FoundByChance& what);

}  // namespace wander
