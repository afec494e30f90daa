#include "tests/support/pointland_moves.h"

#include <algorithm>

#include "core/techniques.h"

namespace wander::test {

namespace {

using B = Bidirectional;

double split_count(const Transition& t, const PointPath& z, int added) {
  return B::split_count(t.graph, z, t.move.kept, added);
}

// The part of added_density that belongs to one split of z, the nearest possible to that of the
// move.
Scaled one_split_density(const Transition& t, const PointPath& z, int added) {
  const B::SplitRange splits = B::split_range(t.graph, z, t.move.kept, added);
  const int light = t.move.kept.light,
            s = light + std::min(splits.first + t.move.split, splits.last);
  if (!can_sample(t.graph, z, s, all_techniques)) return 0;
  Scaled p = 1.0 / splits.count();
  for (int i = light; i < light + added; ++i) p *= i < s ? z[i].from_light : z[i].from_sensor;
  return p;
}

// Of a path whose light was chosen uniformly among two.
Scaled with_uniform_light(const Transition& t, PointPath z, int added) {
  z[0].from_light = 0.5;
  return B::added_density(t.graph, z, t.move.kept, added);
}

void forget_deletion(const Transition& t, Proposal& p) {
  p.forward /= length_pmfs.deletion(t.x.size())[t.move.deleted];
  p.reverse /= length_pmfs.deletion(t.y.size())[t.move.added];
}
void forget_placement(const Transition& t, Proposal& p) {
  p.forward /= B::placement_probability(t.x.size(), t.move.deleted, t.move.kept);
  p.reverse /= B::placement_probability(t.y.size(), t.move.added, t.move.kept);
}
void forget_addition(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  p.forward /= B::add_probability(kept, deleted, added, t.graph.max_vertices());
  p.reverse /= B::add_probability(kept, added, deleted, t.graph.max_vertices());
}
void delete_the_same_on_the_way_back(const Transition& t, Proposal& p) {
  const auto pmf = length_pmfs.deletion(t.y.size());
  p.reverse *= pmf[std::min(t.move.deleted, t.y.size())] / pmf[t.move.added];
}
void add_around_the_same_number_on_the_way_back(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  const int longest = t.graph.max_vertices();
  p.reverse *= B::add_probability(kept, deleted, deleted, longest) /
               B::add_probability(kept, added, deleted, longest);
}
void take_one_split(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  p.forward *= one_split_density(t, t.y, added) / B::added_density(t.graph, t.y, kept, added);
  p.reverse *= one_split_density(t, t.x, deleted) / B::added_density(t.graph, t.x, kept, deleted);
}
void forget_split_probability(const Transition& t, Proposal& p) {
  p.forward *= split_count(t, t.y, t.move.added);
  p.reverse *= split_count(t, t.x, t.move.deleted);
}
void count_specular_splits(const Transition& t, Proposal& p) {
  p.forward *= split_count(t, t.y, t.move.added) / (t.move.added + 1);
  p.reverse *= split_count(t, t.x, t.move.deleted) / (t.move.deleted + 1);
}
void take_lights_for_equal(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  if (kept.light > 0) return;
  p.forward *= with_uniform_light(t, t.y, added) / B::added_density(t.graph, t.y, kept, added);
  p.reverse *= with_uniform_light(t, t.x, deleted) / B::added_density(t.graph, t.x, kept, deleted);
}
void swap_densities(const Transition&, Proposal& p) { std::swap(p.forward, p.reverse); }
void forget_densities(const Transition&, Proposal& p) { p = {1, 1}; }

}  // namespace

std::vector<NamedTwin> bidirectional_twins() {
  return {{"deletion pmf ignored", "diffuse", forget_deletion},
          {"placement pmf ignored", "diffuse", forget_placement},
          {"addition pmf ignored", "diffuse", forget_addition},
          {"way back deletes as many", "diffuse", delete_the_same_on_the_way_back},
          {"way back adds around the same number", "diffuse",
           add_around_the_same_number_on_the_way_back},
          {"used split instead of the sum", "diffuse", take_one_split},
          {"split probability missing", "diffuse", forget_split_probability},
          {"splits at a mirror counted", "glass", count_specular_splits},
          {"splits at a pinhole counted", "pinhole", count_specular_splits},
          {"lights taken for equal", "glass", take_lights_for_equal},
          {"ratio inverted", "diffuse", swap_densities},
          {"symmetric Metropolis", "diffuse", forget_densities}};
}

}  // namespace wander::test
