// The record of a run of chains, in which every member that a record can have is set.
#pragma once

#include <limits>

#include "records/run_json.h"

namespace wander::test {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

inline RunRecord markov_chain_run() {
  RunRecord run;
  run.provenance = {"box",
                    "{ \"dimension\": 2 } // text \"with\" quotes\n",
                    {"abc123", {{"meshes/a \"b\".obj", "f00d"}, {"ä.png", "0"}}},
                    2,
                    "wander render box.json",
                    "0.1.0",
                    {"c0ffee+changes", "GNU 12.2.0", "Release", "a cpu", "2026-01-02T03:04:05Z"}};
  Rendering& rendering = run.rendering;
  rendering.method = "mlt";
  rendering.samples = 123456789012;
  rendering.seed = std::numeric_limits<std::uint64_t>::max();
  rendering.threads = 3;
  rendering.seconds = 1.25;
  rendering.processor_seconds = 2.125;
  rendering.seed_seconds = 0.25;
  rendering.precision = "float";
  rendering.max_vertices = 9;
  rendering.film.shape = {3};
  rendering.film.value = {0.1, 1e-30, 1 / 3.0};
  rendering.film.standard_error = {0.01, unknown, 1e-3};
  rendering.film.reliable = {true, false, true};
  rendering.film.degrees_of_freedom = 31;
  rendering.film.by_length = {{2, {0.1, 0, 0}}, {5, {0, 1e-30, 1 / 3.0}}};
  rendering.adaptation = Adaptation{4, {{1, 0.5}, {4, 0.25}, {16, unknown}}};
  rendering.pooling = {{{0.125}, 0.5, 16, 3},
                       250'000,
                       0.75,
                       {0.05, 1e-31, 0.25},
                       {{"LE", 0.625, 0.5}, {"LSE", 0.375, 1 / 3.0}}};
  rendering.chains_film = FilmEstimate{
      .shape = {3}, .value = {0.2, 1e-31, 2 / 3.0}, .standard_error = {0.02, unknown, 1e-2}};
  rendering.normalization.emplace();
  rendering.normalization->value = 0.6;
  rendering.normalization->standard_error = 0.002;
  rendering.normalization->method = "bridge";
  NormalizationEstimate direct;
  direct.value = 0.61;
  direct.standard_error = 0.004;
  direct.samples = 100000;
  rendering.normalization->estimates["seed_pass"] = direct;
  LengthShare share;
  share.vertices = 2;
  share.value = 0.2;
  share.standard_error = 0.001;
  rendering.normalization->by_length = {share};
  rendering.chains = 64;
  rendering.groups = 32;
  rendering.mutations = {
      {"primary_small", 1000, 400, 0.41, {{"occluded", 20}}, {500, 0, 500}, {0.5, unknown, 0.32}}};
  MutationRecord& mutation = rendering.mutations[0];
  mutation.seconds = 0.4;
  mutation.squared_jump = 0.01;
  mutation.longest_rejection_run = 77;
  mutation.by_length = {{3, "", 900, 350, 0.39, {{"occluded", 20}}}, {4, "", 100, 50, 0.5, {}}};
  mutation.by_class = {{0, "LSE", 1000, 400, 0.41, {{"occluded", 20}}}};
  rendering.chains_record = {
      300, 8, 99, {{"film", 1.004, 4000, 3000, 25}, {"specular", unknown, unknown, 10, unknown}}};
  rendering.warnings = {"a warning"};
  return run;
}

}  // namespace wander::test
