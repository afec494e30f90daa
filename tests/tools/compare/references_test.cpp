// What `wander compare` measures errors against: a file, an exact film, or long runs that are kept.
#include "tests/tools/compare/compare_command.h"

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

TEST_F(CompareCommand, KnowsADiffuseSceneExactlyAndNeedsNoCacheForIt) {
  const json document = compared(tiny);
  EXPECT_TRUE(document["reference"]["origin"].get<std::string>().starts_with("exact"));
  EXPECT_EQ(cached_files(), 0u);
}

TEST_F(CompareCommand, KeepsLongRunsAndMakesMoreWhenTheyDoNotSuffice) {
  write("mirror.json", mirror_box());
  const auto origin = [&](const std::string& arguments) {
    return compared("mirror.json -m pt,bdpt " + arguments)["reference"]["origin"]
        .get<std::string>();
  };
  EXPECT_HAS(origin("-b 4k --replicates 4"), "2 independent runs");
  EXPECT_EQ(cached_files(), 1u);
  const std::string kept = contents(cached_file());
  EXPECT_HAS(origin("-b 500 --replicates 4"), "2 independent runs");
  EXPECT_EQ(contents(cached_file()), kept);
  EXPECT_HAS(origin("-b 200k --replicates 4"), "independent runs");
  EXPECT_NE(contents(cached_file()), kept);
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
  for (const std::string& broken :
       {std::string("{"), std::string(), whole.substr(0, whole.size() / 2), std::string("[1]"),
        std::string(R"({"schema": "wanderlight-reference/1"})")}) {
    std::ofstream(cached_file()) << broken;
    const Outcome outcome = compare(command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_HAS(outcome.err, "cache");
    EXPECT_EQ(contents(cached_file()).size() > 1000, true);
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
