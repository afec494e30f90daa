// compare.json and back to the last bit, compare.csv, `wander inspect` of both, and broken files.
#include "lab/compare/comparison_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lab/compare/comparison_csv.h"
#include "tests/lab/compare/made_runs.h"
#include "tests/tools/command_line.h"
#include "tools/inspection.h"

namespace wander::test {
namespace {

using nlohmann::ordered_json;

compare::Comparison made_comparison(std::size_t replicates = 4) {
  Generator random(1);
  compare::Runs runs =
      made_runs({.replicates = replicates}, {{"mlt, large", 0.1}, {"pt", 0.3}}, random);
  runs.contenders[0].dial = "large_step";
  runs.contenders[0].setting = "0.1";
  runs.provenance = {"room", "{}", {"abc", {{"tri.obj", "f00d"}}}, 2, "wander compare room.json",
                     "0.1.0"};
  runs.warnings = {"a warning"};
  runs.runs.back().film.standard_error[2] = not_known;
  Rendering detail;
  detail.method = "pt";
  detail.film = runs.runs.back().film;
  detail.mutations = {{"lens", 10, 5, 0.5, {{"occluded", 3}}, {}, {}}};
  runs.details = {detail};
  runs.complete = false;
  return summarize(std::move(runs));
}

std::string text_of(const compare::Comparison& comparison) {
  return compare::to_json(comparison).dump(1);
}

TEST(ComparisonJson, ReadsBackToTheLastBit) {
  for (const std::size_t replicates : {1, 4}) {
    const compare::Comparison comparison = made_comparison(replicates);
    const std::string text = text_of(comparison);
    const compare::Comparison back =
        compare::comparison_from_json(ordered_json::parse(text), "compare.json");
    EXPECT_EQ(text_of(back), text);
    EXPECT_EQ(back.runs.provenance.scene_name, "room");
    EXPECT_EQ(back.runs.runs.back().film.value, comparison.runs.runs.back().film.value);
    EXPECT_EQ(back.runs.details.at(0).mutations.at(0).failures.at("occluded"), 3U);
    EXPECT_EQ(back.cells.at(1).rmse.value, comparison.cells.at(1).rmse.value);
    EXPECT_EQ(back.verdict, comparison.verdict);
    EXPECT_FALSE(back.runs.complete);
  }
}

TEST(ComparisonJson, HoldsNoNumberThatIsNotFinite) {
  const std::string text = text_of(made_comparison(1));
  EXPECT_LACKS(text, ": nan");
  EXPECT_LACKS(text, "inf\"");
  EXPECT_EQ(compare::to_json(made_comparison(1))["cells"][0]["relative_rmse"]["low"], nullptr);
}

TEST(ComparisonJson, FilmsOfSpaceHaveAShapeAlone) {
  compare::Comparison comparison = made_comparison();
  comparison.runs.provenance.dimension = 3;
  const ordered_json json = compare::to_json(comparison);
  EXPECT_FALSE(json["runs"][0]["film"].contains("value"));
  const compare::Comparison back = compare::comparison_from_json(json, "compare.json");
  EXPECT_EQ(compare::to_json(back), json);
}

TEST(ComparisonJson, AnEmptyComparisonReadsBack) {
  const ordered_json json = compare::to_json(compare::summarize({}));
  EXPECT_EQ(compare::to_json(compare::comparison_from_json(json, "compare.json")), json);
}

void expect_refused(const ordered_json& json, const std::string& why) {
  try {
    compare::comparison_from_json(json, "FILE");
    ADD_FAILURE() << "accepted: " << why;
  } catch (const RunFileError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("FILE: ")) << error.what();
    EXPECT_HAS(std::string(error.what()), "; not a ");
    EXPECT_LACKS(std::string(error.what()), "json.exception");
    EXPECT_HAS(std::string(error.what()), why);
  }
}

TEST(ComparisonJson, WhatIsMissingOrOfAnotherKindIsRefused) {
  const ordered_json whole = compare::to_json(made_comparison());
  for (const auto& [key, value] : whole.items()) {
    ordered_json broken = whole;
    broken.erase(key);
    // Comparisons of older versions have neither.
    if (key != "provenance" && key != "time") expect_refused(broken, key);
    broken = whole;
    broken[key] = "something else";
    if (!value.is_string()) expect_refused(broken, "");
  }
}

TEST(ComparisonJson, IndicesOfNothingAreRefused) {
  const ordered_json whole = compare::to_json(made_comparison());
  const auto with = [&](const char* pointer, const ordered_json& value) {
    ordered_json broken = whole;
    broken[ordered_json::json_pointer(pointer)] = value;
    return broken;
  };
  expect_refused(with("/schema", "wanderlight-compare/9"), "its schema is another");
  expect_refused(with("/decisive_budget", 4), "decisive");
  expect_refused(with("/cells/0/contender", 2), "cells");
  expect_refused(with("/cells/1/budget", 0), "cells");
  expect_refused(with("/curves/0/contender", 1), "curves");
  expect_refused(with("/profiles/0/contender", 2), "profile");
  expect_refused(with("/profiles/0/share", ordered_json::array()), "profile");
  expect_refused(with("/crossings/0/ahead", 2), "crossing");
  expect_refused(with("/crossings/0/behind", -1), "crossing");
  expect_refused(with("/ranking", {0, 0}), "ranking");
  expect_refused(with("/ranking", {0}), "ranking");
  expect_refused(with("/runs/0/contender", 2), "run");
  expect_refused(with("/runs/0/budget", 4), "run");
  expect_refused(with("/reference/film/value", ordered_json::array()), "");
  expect_refused(with("/runs/3/errors", nullptr), "");
  expect_refused(with("/details/0/schema", "x"), "");
}

TEST(ComparisonCsv, HasARowForEachRun) {
  const compare::Comparison comparison = made_comparison();
  const std::string text = compare::to_csv(comparison);
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            1 + comparison.runs.runs.size());
  EXPECT_TRUE(text.starts_with(
      "contender,method,dial,setting,budget,replicate,seed,samples,seconds,"
      "seed_seconds,seed_samples,cpu_seconds,relative_mse,relative_rmse,rmse,mae,rel_mse,"
      "mean,relative_error_of_mean,claimed_relative_error,coverage,"
      "reliable_share\n\"mlt, large\",mlt,large_step,0.1,1s,1,1,1000,1,0.1,10,1,"))
      << text;
  EXPECT_LACKS(text, "-nan");
}

class InspectComparison : public CommandLine {};

TEST_F(InspectComparison, SaysTheVerdictAndTheTable) {
  write("compare.json", text_of(made_comparison()));
  for (const char* place : {"inspect compare.json", "inspect ."}) {
    const Outcome seen = wander(place);
    EXPECT_EQ(seen.exit_code, 0) << seen.err;
    EXPECT_HAS(seen.out, "mlt, large is ahead of pt from the first budget on");
    EXPECT_HAS(seen.out, "relative RMSE (95 %)");
    EXPECT_HAS(seen.out, "made for a test; its own relative error is 0 %");
    EXPECT_HAS(seen.out, "The comparison is not complete");
  }
  const Outcome json = wander("inspect . --json");
  const auto document = ordered_json::parse(json.out);
  EXPECT_EQ(document["kind"], "comparison");
  EXPECT_EQ(document["cells"].size(), 8U);
  EXPECT_FALSE(document["runs"][0].contains("film"));
}

TEST_F(InspectComparison, RefusesABrokenOne) {
  write("compare.json", R"({"schema": "wanderlight-compare/1", "complete": true})");
  const Outcome broken = wander("inspect .");
  EXPECT_EQ(broken.exit_code, 3);
  EXPECT_HAS(broken.err, "compare.json: /scene: it is missing; not a comparison of schema");
  fs::create_directory(folder / "empty");
  const Outcome empty = wander("inspect empty");
  EXPECT_EQ(empty.exit_code, 3);
  EXPECT_HAS(empty.err, "a directory without a run.json or a compare.json");
  EXPECT_EQ(wander("inspect compare.json --reference .").exit_code, 2);
}

}  // namespace
}  // namespace wander::test
