// What `wander compare` measures errors against: a file, an exact film, or long runs that are kept.
#include "tests/lab/compare/compare_command.h"

namespace wander::test {
namespace {

TEST_F(CompareCommand, TakesAReferenceOfTheSameShape) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 20k -o ref -q").exit_code, 0);
  for (const char* file : {"ref", "ref/run.json", "ref/film.exr"}) {
    const json document = compared(std::string(tiny) + " --reference " + file);
    EXPECT_HAS(document["reference"]["origin"].get<std::string>(), "ref");
  }
  ASSERT_EQ(compare(std::string(tiny) + " -o out -q").exit_code, 0);
  compared(std::string(tiny) + " --reference out/reference.json");

  std::string other = box;
  other.replace(other.find("\"bins\": 8"), 9, "\"bins\": 9");
  write("other.json", other);
  const Outcome shape = compare("other.json -m pt -b 1k --replicates 2 --reference ref -o o");
  EXPECT_EQ(shape.exit_code, 2);
  EXPECT_HAS(shape.err, "9 bins");
  EXPECT_EQ(compare(std::string(tiny) + " --reference box.json -o o").exit_code, 3);
  EXPECT_EQ(compare(std::string(tiny) + " --reference nowhere -o o").exit_code, 3);
  EXPECT_FALSE(exists("o"));

  write("mirror.json", mirror_box());
  EXPECT_HAS(compare("mirror.json -m pt -b 1k --replicates 2 --reference ref -o o").err,
             "another scene");
}

// The light of the paths that one of them leaves out would count as an error of the other.
TEST_F(CompareCommand, TellsThatAReferenceHasOtherLengths) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 20k --max-vertices 3 -o short -q").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m bdpt -b 20k -o whole -q").exit_code, 0);
  for (const char* file : {"short", "short/run.json", "short/film.exr"}) {
    const Outcome outcome = compare(std::string(tiny) + " --force -o o --reference " + file);
    EXPECT_HAS(outcome.err, "has paths of up to 3 vertices, not of up to ");
    EXPECT_EQ(json::parse(contents(folder / "o/compare.json"))["reference"]["max_vertices"], 3);
    EXPECT_EQ(json::parse(contents(folder / "o/reference.json"))["max_vertices"], 3);
  }
  EXPECT_HAS(wander("inspect whole --reference short").out, "has paths of up to 3 vertices");
  EXPECT_HAS(wander("plot whole --reference short -o film.svg").err, "has paths of up to 3");
  EXPECT_LACKS(compare(std::string(tiny) + " --force -o o --reference whole").err,
               "paths of up to");
  EXPECT_LACKS(wander("inspect whole --reference whole").out, "paths of up to");
  const Outcome same =
      compare(std::string(tiny) + " --dial max_vertices=3 --force -o o --reference short");
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_LACKS(same.err, "paths of up to");
}

TEST_F(CompareCommand, RefusesADamagedReference) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 20k -o ref -q").exit_code, 0);
  const json whole = json::parse(contents(folder / "ref" / "run.json"));
  const auto refused = [&](const char* list, const json& value, const char* why) {
    json broken = whole;
    broken["film"][list][3] = value;
    write("broken.json", broken.dump());
    const Outcome outcome = compare(std::string(tiny) + " --reference broken.json -o o");
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_HAS(outcome.err, why);
    EXPECT_HAS(outcome.err, "broken.json");
  };
  refused("value", nullptr, "1 of 8 values of its film are no numbers");
  refused("standard_error", -1, "a standard error of its film is below zero");
  refused("value", "light", "broken.json");
  json shorter = whole;
  for (const char* list : {"value", "standard_error", "reliable"})
    shorter["film"][list].erase(shorter["film"][list].size() - 1);
  write("broken.json", shorter.dump());
  const Outcome outcome = compare(std::string(tiny) + " --reference broken.json -o o");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_HAS(outcome.err, "8 bins has 7 values");
  const std::string image = contents(folder / "ref" / "film.exr");
  write("cut.exr", image.substr(0, image.size() / 2));
  EXPECT_EQ(compare(std::string(tiny) + " --reference cut.exr -o o").exit_code, 3);
  EXPECT_FALSE(exists("o"));
}

TEST_F(CompareCommand, KnowsADiffuseSceneExactlyAndNeedsNoCacheForIt) {
  const json document = compared(tiny);
  EXPECT_TRUE(document["reference"]["origin"].get<std::string>().starts_with("exact"));
  EXPECT_EQ(cached_files(), 0u);
}

TEST_F(CompareCommand, KeepsLongRunsAndMakesMoreWhenTheyDoNotSuffice) {
  write("mirror.json", mirror_box());
  const auto kept = [&] {
    std::string text;
    for (const auto& file : fs::directory_iterator(folder / "cache" / "wanderlight"))
      text += contents(file);
    return text;
  };
  const auto origin = [&](const std::string& arguments) {
    return compared("mirror.json -m pt,bdpt " + arguments)["reference"]["origin"]
        .get<std::string>();
  };
  EXPECT_HAS(origin("-b 8k --replicates 4"), "the mean of 2 independent runs of ");
  EXPECT_EQ(cached_files(), 2u);
  const std::string first = kept();
  EXPECT_HAS(origin("-b 500 --replicates 2"), "and 2 independent runs of ");
  EXPECT_EQ(kept(), first);
  EXPECT_HAS(origin("-b 100k --replicates 4"), " independent runs of ");
  EXPECT_NE(kept(), first);
}

// Whoever takes part, two methods that do well make it.
TEST_F(CompareCommand, AReferenceIsMadeByTwoMethodsThatNeedNotTakePart) {
  write("mirror.json", mirror_box());
  const json document = compared("mirror.json -m mlt -b 10k --replicates 2");
  const std::string origin = document["reference"]["origin"];
  EXPECT_HAS(origin, ", weight ");
  EXPECT_LACKS(origin, "of mlt");  // one wall and one mirror: its seed pass is no match for others
  EXPECT_EQ(document["cautions"].dump().find("do not agree"), std::string::npos);
}

// χ² of 8 bins exceeds 8 × 7.5 once in 2e9 times.
TEST_F(CompareCommand, ALongReferenceIsTheFilm) {
  write("mirror.json", mirror_box());
  ASSERT_EQ(compare("mirror.json -m pt,bdpt -b 40k --replicates 4 -o out -q").exit_code, 0);
  ASSERT_EQ(wander("render mirror.json -m pt -b 400k -o run -q").exit_code, 0);
  const auto chi2 = [&](const std::string& run) {
    const Outcome outcome = wander("inspect out/reference.json --reference " + run + " --json");
    return json::parse(outcome.out).at("comparison").at("chi2_per_degree").get<double>();
  };
  EXPECT_LT(chi2("run"), 7.5);
  ASSERT_EQ(wander("render box.json -m pt -b 400k -o other -q").exit_code, 0);  // control
  EXPECT_GT(chi2("other"), 7.5);
}

TEST_F(CompareCommand, IgnoresABrokenCacheWithAWarning) {
  write("mirror.json", mirror_box());
  const std::string command = "mirror.json -m pt -b 2k --replicates 2 -o out --force";
  ASSERT_EQ(compare(command).exit_code, 0);
  const std::string whole = contents(cached_file());
  std::string altered = whole;
  altered[altered.size() / 2] ^= 1;
  for (const std::string& broken :
       {std::string("{"), std::string(), whole.substr(0, whole.size() / 2), std::string("[1]"),
        altered, std::string(R"({"schema": "wanderlight-reference/4"})")}) {
    std::ofstream(cached_file()) << broken;
    const Outcome outcome = compare(command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_HAS(outcome.err, "cache");
    EXPECT_GE(cached_files(), 2u);
  }
}

TEST_F(CompareCommand, WithoutAPlaceForTheCacheGoesOnWithAWarning) {
  write("mirror.json", mirror_box());
  write("cache", "a file");
  const Outcome outcome = compare("mirror.json -m pt -b 2k --replicates 2 -o out");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_HAS(outcome.err, "not kept");
}

}  // namespace
}  // namespace wander::test
