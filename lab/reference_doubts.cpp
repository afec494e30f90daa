#include "lab/reference_doubts.h"

#include <fmt/format.h>

#include <algorithm>

#include "lab/method.h"

namespace wander {

namespace {

// Samples of a seed pass have numbers of their own (rng.h: Purpose).
bool has_seed_pass(const Rendering& rendering) {
  return std::ranges::any_of(methods(), [&](const Method& m) {
    return m.name == rendering.method && m.is_markov_chain();
  });
}

}  // namespace

std::vector<std::uint64_t> seeds_of(const Rendering& rendering) {
  if (rendering.samples == 0) return {};
  if (rendering.merged.empty()) return {rendering.seed};
  std::vector<std::uint64_t> seeds;
  for (const MergedRun& run : rendering.merged) seeds.push_back(run.seed);
  return seeds;
}

bool may_share_samples(const RunRecord& run, const RunRecord& reference) {
  const std::vector<std::uint64_t> seeds = seeds_of(run.rendering),
                                   others = seeds_of(reference.rendering);
  return may_be_the_same(run.provenance.scene_digest, reference.provenance.scene_digest) &&
         has_seed_pass(run.rendering) == has_seed_pass(reference.rendering) &&
         std::ranges::find_first_of(seeds, others) != seeds.end();
}

bool has_other_lengths(const Rendering& reference, int max_vertices) {
  return reference.max_vertices > 0 && max_vertices > 0 && reference.max_vertices != max_vertices;
}

std::string words_of_lengths(const Rendering& reference, int max_vertices) {
  return fmt::format(
      "paths of up to {} vertices, not of up to {} as the film held against it: the light of the "
      "others counts as error",
      reference.max_vertices, max_vertices);
}

std::vector<std::string> doubts_of(const RunRecord& reference, const RunRecord& run) {
  std::vector<std::string> doubts;
  if (!may_be_the_same(run.provenance.scene_digest, reference.provenance.scene_digest))
    doubts.push_back(fmt::format("the reference {}", doubt_of_another_scene));
  if (has_other_lengths(reference.rendering, run.rendering.max_vertices))
    doubts.push_back(fmt::format(
        "the reference has {}", words_of_lengths(reference.rendering, run.rendering.max_vertices)));
  if (may_share_samples(run, reference)) doubts.emplace_back(doubt_of_one_seed);
  return doubts;
}

}  // namespace wander
