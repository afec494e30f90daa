// `wander check`: verdicts in words and in JSON, exit codes, and a wrong twin that is caught.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "mlt/mixture.h"
#include "tests/support/test_scenes.h"
#include "tests/support/wrong_twins.h"
#include "tests/tools/command_line.h"
#include "tools/check_report.h"

namespace wander::test {
namespace {

using nlohmann::json;
using Flat = Transport<Flatland>;

std::string box_of(const char* member, const json& value) {
  json scene = json::parse(box);
  scene[member] = value;
  return scene.dump(1);
}

TEST_F(CommandLine, CheckSaysOfEachMutationThatItLeavesTheTargetInvariant) {
  const Outcome check = wander("check box.json --samples 20k");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  const Outcome inspection = wander("inspect box.json --json");
  const json needs = json::parse(inspection.out)["requires"];
  for (const json& name : needs["mutations"]) EXPECT_HAS(check.out, name.get<std::string>());
  for (const auto& [name, why] : needs["left_out"].items()) EXPECT_LACKS(check.out, name);
  EXPECT_HAS(check.out, "leaves the target invariant (largest |z|");
  EXPECT_HAS(check.out, "mixture");
  EXPECT_HAS(check.out, "agrees with bdpt");
  EXPECT_LACKS(check.out, "DOES NOT");
}

TEST_F(CommandLine, CheckTestsTheMutationsThatWereNamedAndNoOther) {
  const Outcome check = wander("check box.json --samples 5k --mutations bidirectional=1");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_HAS(check.out, "bidirectional");
  EXPECT_LACKS(check.out, "primary");
  EXPECT_LACKS(check.out, "mixture");
}

TEST_F(CommandLine, CheckPrintsOneDocumentThatIsTheSameForAnyNumberOfThreads) {
  const std::string arguments = "check box.json --samples 5k --mutations bidirectional=1 --json ";
  const Outcome one = wander(arguments + "-t 1"), three = wander(arguments + "-t 3");
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out, three.out);
  const json document = json::parse(one.out);
  EXPECT_EQ(document["schema"], "wanderlight-check/1");
  EXPECT_EQ(document["passed"], true);
  EXPECT_EQ(document["mutations"][0]["verdict"], "passed");
  EXPECT_EQ(document["methods"].size(), checked_methods().size());
  EXPECT_NE(wander(arguments + "-s 2").out, one.out);
}

// A mirror shows the floor a lamp of a nanometre: light paths find that light, a path from the floor would have to
// meet the lamp by chance.
constexpr const char* tiny_lamp_text = R"({
  "format": "wanderlight-scene/1", "dimension": 2, "max_vertices": 8,
  "materials": { "silver": { "type": "mirror", "reflectance": 0.9 } },
  "shapes": [
    { "type": "segment", "from": [0, 0], "to": [1, 0], "sensor": { "bins": 4 } },
    { "type": "segment", "from": [0.5, 1], "to": [0.499999999, 1], "light": { "radiance": 2e9 } },
    { "type": "segment", "from": [1.2, 0], "to": [1.2, 1.5], "material": "silver" } ] })";

TEST_F(CommandLine, CheckHoldsNothingAgainstAMethodThatCannotMeetALamp) {
  write("tiny.json", tiny_lamp_text);
  for (const int seed : {1, 2}) {
    const Outcome check = wander(fmt::format("check tiny.json --samples 20k -s {}", seed));
    EXPECT_EQ(check.exit_code, 0) << check.out;
    EXPECT_HAS(check.out, "lt");
    EXPECT_LACKS(check.out, "DISAGREES");
  }
  const auto rendered = [&](const char* method) {
    return json::parse(
        wander(fmt::format("render tiny.json -m {0} -b 20k --json -q -o {0} --force", method)).out);
  };
  const json by_pt = rendered("pt"), by_lt = rendered("lt");
  EXPECT_EQ(by_pt["film"]["reliable"], json::array({false, false, false, false}));
  EXPECT_HAS(by_pt["warnings"].dump(), "pt finds light that comes by mirrors or smooth glass only");
  EXPECT_EQ(by_lt["film"]["reliable"], json::array({true, true, true, true}));
}

// Lamp and sensor of 10 μm, and what a mirror shows of one to the other: only a subpath that meets one of them finds it, and none does.
constexpr const char* tiny_ends_text = R"({
  "format": "wanderlight-scene/1", "dimension": 2, "max_vertices": 4,
  "materials": { "silver": { "type": "mirror", "reflectance": 0.95 } },
  "shapes": [
    { "type": "segment", "from": [0, 0], "to": [0.00001, 0], "sensor": { "bins": 2 } },
    { "type": "segment", "from": [0.50001, 0.5], "to": [0.5, 0.5], "light": { "radiance": 5 } },
    { "type": "segment", "from": [1, -1], "to": [1, 2], "material": "silver" } ] })";

TEST_F(CommandLine, WhatNoSubpathMetIsDoubtedByAllMethodsThatHaveToMeetIt) {
  write("ends.json", tiny_ends_text);
  const auto rendered = [&](const std::string& arguments) {
    return json::parse(
        wander("render ends.json -b 20k --json -q -t 1 -o run --force -m " + arguments).out);
  };
  for (const std::string method :
       {"pt", "lt", "bdpt", "mlt", "mlt --film chains", "pssmlt", "mmlt"}) {
    const json run = rendered(method), direct = rendered(method + " --max-vertices 2");
    EXPECT_EQ(run["film"]["reliable"], json::array({false, false})) << method;
    EXPECT_HAS(run["warnings"].dump(), "what it may have missed is in no error bar");
    EXPECT_EQ(direct["film"]["reliable"], json::array({true, true}))
        << method << ": no mirror in two";
    EXPECT_LACKS(direct["warnings"].dump(), "no error bar");
  }
}

// A pinhole sees a ball of silver: light tracing knows nothing of what comes by it, so nothing of any bin.
TEST_F(CommandLine, AMethodThatMissesLightCallsNoBinReliable) {
  json scene = json::parse(box);
  scene["materials"]["silver"] = {{"type", "mirror"}, {"reflectance", 0.9}};
  scene["shapes"].push_back(
      {{"type", "circle"}, {"center", {1, 0.5}}, {"radius", 0.1}, {"material", "silver"}});
  json& floor = scene["shapes"][2];
  floor.erase("sensor");
  floor["material"] = "wall";
  scene["camera"] = {{"type", "perspective"},
                     {"position", {0.2, 0.5}},
                     {"target", {1, 0.5}},
                     {"fov_deg", 60},
                     {"resolution", 4}};
  write("seen.json", scene.dump(1));
  for (const char* method : {"lt", "bdpt"}) {
    const json film = json::parse(
        wander(fmt::format("render seen.json -m {0} -b 50k --json -q -o {0}", method)).out)["film"];
    EXPECT_EQ(film["reliable"],
              json::array({method[0] == 'b', method[0] == 'b', method[0] == 'b', method[0] == 'b'}))
        << method;
  }
  const Outcome direct = wander("render seen.json -m lt -b 1k --max-vertices 2 -o direct");
  EXPECT_LACKS(direct.err, "a mirror") << "no mirror is between two vertices";
}

// Where samples go on beside each step, the first look comes after as much work as it does without.
TEST_F(CommandLine, AnErrorThatIsEasilyReachedIsReachedSoon) {
  const json run =
      json::parse(wander("render box.json -m mlt -b \"error<0.5\" --json -q -o run").out);
  const double beside = run["pooling"]["samples_per_step"];
  EXPECT_GT(beside, 1);
  EXPECT_LT(run["samples"].get<double>() * (1 + beside), 1.5 * (1 << 17));
}

TEST_F(CommandLine, CheckFindsNoLightAndSaysSo) {
  json scene = json::parse(box);
  scene["shapes"].push_back(
      {{"type", "segment"}, {"from", {0, 0.5}}, {"to", {2, 0.5}}, {"material", "wall"}});
  write("dark.json", scene.dump(1));
  const Outcome check = wander("check dark.json --json");
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_HAS(check.err, "found no light path");
  EXPECT_TRUE(json::parse(check.out).contains("error"));
}

TEST_F(CommandLine, CheckThatCouldTestNothingHasNotPassed) {
  const Outcome check = wander("check box.json --samples 10");
  EXPECT_EQ(check.exit_code, 4) << check.err;
  EXPECT_HAS(check.out, "not tested: it moved");
  EXPECT_HAS(check.out, "NOTHING COULD BE TESTED: 0 tests passed, 0 failed, ");
  const Outcome document = wander("check box.json --samples 10 --json");
  EXPECT_EQ(document.exit_code, 4);
  EXPECT_EQ(json::parse(document.out)["passed"], false);
  EXPECT_HAS(wander("check --help").out, "when none could be made");
}

TEST_F(CommandLine, CheckRefusesWhatItCannotDo) {
  for (const char* arguments :
       {"check", "check box.json --samples 5s", "check box.json --samples 0",
        "check box.json -o out", "check box.json --mutations nope=1"}) {
    const Outcome check = wander(arguments);
    EXPECT_EQ(check.exit_code, 2) << arguments << check.err;
  }
  write("bad.json", box_of("max_vertices", 1));
  EXPECT_EQ(wander("check bad.json").exit_code, 3);
}

// ---- the verdicts themselves

std::vector<KernelCheck> checks_of(const Flat& space, const auto& mixture, std::uint64_t samples) {
  Session session;
  session.threads = 1;
  const Starts<Flat> starts(space, 1);
  std::vector<KernelCheck> checks;
  check_kernels(space, mixture, starts, {.samples = samples, .false_alarm = 1e-7}, Run(session),
                [&](KernelCheck check) { checks.push_back(std::move(check)); });
  return checks;
}

// Who asks for few samples does not wait for many; and the error says how many were tried.
TEST_F(CommandLine, ACheckOfFewSamplesTriesFewBeforeItBegins) {
  write("dark.json", R"({"format": "wanderlight-scene/1", "dimension": 2, "max_vertices": 4,
    "materials": {"white": {"type": "diffuse", "reflectance": 0.5}},
    "shapes": [{"type": "segment", "from": [0, 0], "to": [1, 0], "light": {"radiance": 1}},
               {"type": "segment", "from": [-9, 1], "to": [9, 1], "material": "white"},
               {"type": "segment", "from": [1, 2], "to": [0, 2], "sensor": {"bins": 4}}]})");
  for (const auto& [samples, tried] :
       {std::pair{"100", " 8192 "}, std::pair{"1000", " 16000 "}, std::pair{"1M", " 262144 "}}) {
    const Outcome check = wander("check dark.json --samples " + std::string(samples));
    EXPECT_EQ(check.exit_code, 1) << check.err;
    EXPECT_HAS(check.err, tried);
  }
}

TEST(Check, CatchesTheFlawedMutationAloneAndInTheMixture) {
  const FlatScene scene = build(diffuse_room());
  const Mixture mixture({1, 1}, FlawedRatio<Bidirectional>{{}, RatioFlaw::inverted},
                        PrimarySmall{});
  const auto checks = checks_of(Flat(*scene, Roulette::off), mixture, 20'000);
  ASSERT_EQ(checks.size(), 3u);
  EXPECT_EQ(verdict_of(checks[0].report), Verdict::failed);
  EXPECT_EQ(verdict_of(checks[1].report), Verdict::passed);
  EXPECT_EQ(verdict_of(checks[2].report), Verdict::failed);
  const CheckReport report{.samples = 20'000, .steps = 20, .mutations = checks};
  EXPECT_FALSE(report.passed());
  EXPECT_HAS(text_of(report), "bidirectional  DOES NOT leave the target invariant: ");
  EXPECT_HAS(text_of(report), "primary_small  leaves the target invariant");
}

// Can act nowhere.
struct Idle {
  static constexpr std::string_view name = "idle";
  double applicability(const auto&, const auto&) const { return 0; }
  Proposed propose(const auto&, const auto&, auto&, auto&) const { return Proposal{1, 1}; }
};

TEST(Check, SaysThatAMutationCannotActRatherThanThatItIsRight) {
  const FlatScene scene = build(diffuse_room());
  const auto checks = checks_of(Flat(*scene, Roulette::off), Mixture<Idle>({1}, Idle{}), 1000);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(verdict_of(checks[0].report), Verdict::untested);
  const CheckReport report{.samples = 1000, .steps = 20, .mutations = checks};
  EXPECT_FALSE(report.passed());  // nothing was tested
  EXPECT_HAS(text_of(report), "idle  not tested: it cannot act on any of the ");
}

TEST(Check, ComparesFilmsOnlyWhereBothAreReliable) {
  const FilmEstimate film{.value = {1, 1, 1},
                          .standard_error = {0.01, 0.01, 0.01},
                          .reliable = {true, true, false},
                          .degrees_of_freedom = 63};
  FilmEstimate other = film;
  other.value = {1.01, 1.02, 9};
  const MethodCheck same = compare_films("pt", film, other, 1e-7);
  EXPECT_EQ(same.verdict, Verdict::passed);
  EXPECT_EQ(same.decision.comparisons, 2u);
  other.value[1] = 1.2;
  const MethodCheck different = compare_films("pt", film, other, 1e-7);
  EXPECT_EQ(different.verdict, Verdict::failed);
  EXPECT_EQ(different.decision.worst, 1u);
  other.reliable = {false, false, true};
  EXPECT_EQ(compare_films("pt", film, other, 1e-7).verdict, Verdict::untested);
}

// Errors that rest on one or two groups of chains decide nothing, however different the films are.
TEST(Check, ComparesFilmsOnlyWhereTheyCouldDisagree) {
  const FilmEstimate reference{.value = {1, 1},
                               .standard_error = {0.01, 0.01},
                               .reliable = {true, true},
                               .degrees_of_freedom = 1e6};
  for (const double degrees : {0.0, 0.003, 0.05, 1.0, 2.0}) {
    FilmEstimate film = reference;
    film.value = {1, 3};
    film.standard_error = {0.05, 0.15};
    film.degrees_of_freedom = degrees;
    const MethodCheck check = compare_films("mlt", film, reference, 1e-7);
    EXPECT_EQ(check.verdict, Verdict::untested) << degrees;
    EXPECT_HAS(check.reason, "in 2 of 2 bins");
  }
  FilmEstimate film = reference;
  film.degrees_of_freedom = 1.5;
  film.standard_error = {0, 0.15};  // the error of the first is that of the reference
  const MethodCheck check = compare_films("mlt", film, reference, 1e-7);
  EXPECT_EQ(check.verdict, Verdict::passed);
  EXPECT_EQ(check.decision.comparisons, 1u);
}

}  // namespace
}  // namespace wander::test
