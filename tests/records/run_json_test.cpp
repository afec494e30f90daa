// run.json says what is recorded of a run, and null for numbers that are none.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "records/run_json.h"
#include "tests/records/made_record.h"

namespace wander::test {
namespace {

TEST(RunJson, ADocumentSaysWhatTheContractSays) {
  const nlohmann::ordered_json json = to_json(markov_chain_run());
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{
                      "schema",       "complete",      "scene",        "dimension", "method",
                      "samples",      "seed",          "threads",      "seconds",   "cpu_seconds",
                      "seed_seconds", "precision",     "max_vertices", "film",      "adaptation",
                      "pooling",      "normalization", "chains",       "mutations", "command_line",
                      "version",      "provenance",    "warnings"}));
  EXPECT_EQ(json["schema"], "wanderlight-run/1");
  EXPECT_EQ(json["film"]["shape"], nlohmann::ordered_json({3}));
  EXPECT_EQ(json["film"]["value"][2].get<double>(), 1 / 3.0);
  EXPECT_EQ(json["film"]["reliable"], nlohmann::ordered_json({true, false, true}));
  EXPECT_EQ(json["film"]["degrees_of_freedom"], 31.0);
  EXPECT_EQ(json["adaptation"], nlohmann::ordered_json::parse(R"({
    "kernel": 4.0, "tried": [{"kernel": 1.0, "spread": 0.5}, {"kernel": 4.0, "spread": 0.25},
                             {"kernel": 16.0, "spread": null}]})"));
  EXPECT_EQ(json["film"]["samples"]["value"][2].get<double>(), 0.25);
  EXPECT_EQ(json["pooling"]["by_class"][0],
            nlohmann::ordered_json::parse(R"({"class": "LE", "light": 0.625, "of_samples": 0.5})"));
  EXPECT_EQ(json["normalization"]["estimates"]["seed_pass"]["samples"], 100000);
  EXPECT_EQ(json["normalization"]["by_length"][0]["vertices"], 2);
  EXPECT_EQ(json["normalization"]["by_length"][0]["standard_error"], 0.001);
  EXPECT_EQ(json["chains"], nlohmann::ordered_json::parse(R"({
    "count": 64, "groups": 32, "draws": 300, "stride": 8, "longest_rejection_run": 99,
    "r_hat": {"film": 1.004, "specular": null},
    "ess": {"film": {"bulk": 4000.0, "tail": 3000.0}, "specular": {"bulk": null, "tail": 10.0}},
    "ess_per_second": {"film": 3200.0, "specular": null},
    "integrated_autocorrelation": {"film": 25.0, "specular": null}})"));
  EXPECT_EQ(json["mutations"]["primary_small"]["squared_jump"], 0.01);
  EXPECT_EQ(json["mutations"]["primary_small"]["longest_rejection_run"], 77);
  EXPECT_EQ(json["mutations"]["primary_small"]["by_length"][1]["vertices"], 4);
  EXPECT_EQ(json["mutations"]["primary_small"]["by_class"], nlohmann::ordered_json::parse(R"([
    {"class": "LSE", "proposed": 1000, "accepted": 400, "mean_acceptance": 0.41,
     "failures": {"occluded": 20}}])"));
  EXPECT_EQ(json["mutations"]["primary_small"]["failures"]["occluded"], 20);
}

TEST(RunJson, NumbersThatAreNotFiniteAreNull) {
  RunRecord run = markov_chain_run();
  run.rendering.film.value[0] = std::numeric_limits<double>::infinity();
  const nlohmann::ordered_json json = to_json(run);
  EXPECT_TRUE(json["film"]["standard_error"][1].is_null());
  EXPECT_TRUE(json["film"]["value"][0].is_null());
}

TEST(RunJson, AnIndependentSampleRunHasNoMarkovChainFields) {
  RunRecord run = markov_chain_run();
  run.rendering.normalization.reset();
  run.rendering.chains = 0;
  run.rendering.mutations.clear();
  run.rendering.complete = false;
  const nlohmann::ordered_json json = to_json(run);
  EXPECT_EQ(json["complete"], false);
  for (const char* key : {"normalization", "chains", "mutations"}) EXPECT_FALSE(json.contains(key));
}

}  // namespace
}  // namespace wander::test
