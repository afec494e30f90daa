// `wander compare` of scenes in space: images, whose numbers are in files beside compare.json.
#include <cmath>
#include <utility>

#include "records/exr.h"
#include "tests/lab/compare/compare_command.h"
#include "tests/support/space_scene_text.h"

namespace wander::test {
namespace {

class SpaceCompare : public CompareCommand {
 protected:
  SpaceCompare() {
    write("room.json", coloured_room());
    write("grey.json", grey_room());
  }
  FilmEstimate film(const std::string& file) const {
    return read_exr(folder / file).rendering.film;
  }
  json document(const std::string& directory) const {
    return json::parse(contents(folder / directory / "compare.json"));
  }
};

constexpr const char* some = "room.json -m pt,bdpt,mlt -b 2k,8k --replicates 3 -t 1 ";

// A comparison that several tests read, made once.
class SomeSpaceCompared : public SpaceCompare {
 protected:
  static void SetUpTestSuite() { made_ = new Made; }
  static void TearDownTestSuite() { delete std::exchange(made_, nullptr); }

  SomeSpaceCompared() {
    EXPECT_EQ(made_->outcome.exit_code, 0) << made_->outcome.err;
    fs::copy(made_->folder / "out", folder / "out", fs::copy_options::recursive);
  }

 private:
  struct Made : SpaceCompare {
    void TestBody() override {}
    Outcome outcome = compare(std::string(some) + "-o out");
    using SpaceCompare::folder;
  };
  static inline Made* made_ = nullptr;
};

TEST_F(SomeSpaceCompared, HasReportTableAndFilms) {
  const json all = document("out");
  EXPECT_EQ(all["dimension"], 3);
  EXPECT_EQ(all["reference"]["file"], "films/reference.exr");
  EXPECT_EQ(all["cells"][5]["file"], "films/mlt-8k.exr");
  for (const json& run : all["runs"]) {
    EXPECT_EQ(run["film"]["shape"], json({8, 12, 3}));
    EXPECT_EQ(run["film"].count("value"), 0u);
  }
  EXPECT_EQ(all["reference"]["film"].count("value"), 0u);
  EXPECT_FALSE(exists("out/reference.json"));
  for (const json& cell : all["cells"]) {
    EXPECT_TRUE(exists(("out/" + cell["file"].get<std::string>()).c_str()));
    for (const char* error : {"relative_rmse", "rmse", "mae", "rel_mse"}) {
      EXPECT_TRUE(cell[error]["value"].is_number()) << error;
      EXPECT_TRUE(cell[error]["low"].is_number()) << error;
    }
  }
  EXPECT_HAS(contents(folder / "out/report.html"), "small room: pt, bdpt and mlt compared");
  const std::string table = contents(folder / "out/compare.csv");
  EXPECT_EQ(std::ranges::count(table, '\n'), 1 + 18);
}

// Of the first replicate, by its film and that of the reference, which are rounded to floats.
TEST_F(SomeSpaceCompared, HasErrorsThatAreMeansOverPixelsAndChannels) {
  const json all = document("out");
  const FilmEstimate reference = film("out/films/reference.exr");
  double mean = 0, noise = 0, weighted_noise = 0;
  const auto count = static_cast<double>(reference.value.size());
  for (const double x : reference.value) mean += x / count;
  const auto weight = [&](double x) { return 1 / (x * x + 1e-4 * mean * mean); };
  for (std::size_t i = 0; i < reference.value.size(); ++i) {
    const double e = reference.standard_error[i];
    noise += e * e / count;
    weighted_noise += weight(reference.value[i]) * e * e / count;
  }
  for (const json& run : all["runs"]) {
    if (run["replicate"] != 0) continue;
    const std::size_t cell =
        run["contender"].get<std::size_t>() * 2 + run["budget"].get<std::size_t>();
    const FilmEstimate image = film("out/" + all["cells"][cell]["file"].get<std::string>());
    double square = 0, absolute = 0, weighted = 0;
    for (std::size_t i = 0; i < image.value.size(); ++i) {
      const double d = image.value[i] - reference.value[i];
      square += d * d / count;
      absolute += std::abs(d) / count;
      weighted += weight(reference.value[i]) * d * d / count;
    }
    const json& errors = run["errors"];
    const auto expect = [&](const char* name, double value) {
      EXPECT_NEAR(errors[name].get<double>(), value, 1e-4 * std::abs(value) + 1e-7) << name;
    };
    expect("rmse", std::sqrt(std::max(square - noise, 0.)));
    expect("mae", absolute);
    expect("rel_mse", weighted - weighted_noise);
  }
}

// The same films, whether they were made at once or carried on; and whether they lie on the shelf
// (-o) or in memory (--json alone).
TEST_F(SomeSpaceCompared, CarriedOnItIsTheSame) {
  ASSERT_EQ(compare("room.json -m pt,bdpt,mlt -b 2k,8k --replicates 2 -t 1 -o part -q --reference "
                    "out/films/reference.exr")
                .exit_code,
            0);
  ASSERT_EQ(compare("--continue --replicates 3 -o part -q").exit_code, 0);
  ASSERT_EQ(compare(std::string(some) + "-o anew -q --reference out/films/reference.exr").exit_code,
            0);
  const json memory = compared(std::string(some) + "--reference out/films/reference.exr");
  const json part = document("part"), anew = document("anew");
  const auto errors_of = [](const json& all, std::size_t seed_of) {
    for (const json& run : all["runs"])
      if (run["seed"] == seed_of) return run["errors"];
    return json();
  };
  for (const json& run : anew["runs"]) {
    EXPECT_EQ(errors_of(part, run["seed"]), run["errors"]);
    EXPECT_EQ(errors_of(memory, run["seed"]), run["errors"]);
  }
  for (std::size_t cell = 0; cell < 6; ++cell)
    for (const char* error : {"rmse", "rel_mse", "bias"}) {
      EXPECT_EQ(part["cells"][cell][error], anew["cells"][cell][error]) << error;
      EXPECT_EQ(memory["cells"][cell][error], anew["cells"][cell][error]) << error;
    }
  for (const char* name : {"films/pt-2k.exr", "films/mlt-8k.exr"})
    EXPECT_EQ(film(std::string("part/") + name).value, film(std::string("anew/") + name).value);
}

TEST_F(SpaceCompare, LongRunsOfImagesAreKeptForTheNextTime) {
  const json first = compared("room.json -m pt,bdpt -b 4k --replicates 2");
  EXPECT_EQ(cached_files(), 2u);
  const Outcome again = compare("room.json -m pt,bdpt -b 1k --replicates 2 --json");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_LACKS(again.err, "cache");
  EXPECT_EQ(cached_files(), 2u);
  const auto origin = [](const json& all) { return all["reference"]["origin"]; };
  EXPECT_EQ(origin(json::parse(again.out)), origin(first));
  const std::string whole = contents(cached_file());
  std::ofstream(cached_file(), std::ios::binary) << whole.substr(0, whole.size() / 2);
  EXPECT_HAS(compare("room.json -m pt,bdpt -b 1k --replicates 2 --json").err, "cut short");
}

TEST_F(SpaceCompare, AReferenceOfAnotherShapeIsAFaultOfTheFile) {
  write("large.json", coloured_room(24, 16));
  ASSERT_EQ(wander("render large.json -m pt -b 2k -q -o large").exit_code, 0);
  ASSERT_EQ(wander("render grey.json -m pt -b 2k -q -o grey").exit_code, 0);
  ASSERT_EQ(wander("render room.json -m pt -b 2k -q -o room").exit_code, 0);
  const std::string command = "room.json -m pt,bdpt -b 1k --replicates 2 -o out --reference ";
  expect_one_fault(compare(command + "large/film.exr"), 3,
                   {"large/film.exr", "24 x 16 pixels in colour", "12 x 8 pixels in colour"});
  expect_one_fault(compare(command + "grey/film.exr"), 3,
                   {"grey/film.exr", "12 x 8 pixels in one channel", "12 x 8 pixels in colour"});
  expect_one_fault(
      compare("grey.json -m pt,bdpt -b 1k --replicates 2 -o out --reference room/film.exr"), 3,
      {"room/film.exr", "pixels in colour", "in one channel"});
  EXPECT_FALSE(exists("out"));
}

// What is left of a comparison of the other kind goes.
TEST_F(SpaceCompare, ReplacesAComparisonOfThePlaneAndTheOtherWayRound) {
  ASSERT_EQ(compare("box.json -m pt -b 1k --replicates 2 -o out -q").exit_code, 0);
  ASSERT_EQ(compare("room.json -m pt,bdpt -b 1k --replicates 2 -o out -q --force").exit_code, 0);
  EXPECT_FALSE(exists("out/reference.json"));
  ASSERT_EQ(compare("room.json -m pt -b 1k --replicates 2 -o out -q --force").exit_code, 0);
  EXPECT_FALSE(exists("out/films/bdpt-1k.exr"));
  ASSERT_EQ(compare("box.json -m pt -b 1k --replicates 2 -o out -q --force").exit_code, 0);
  EXPECT_FALSE(exists("out/films"));
}

TEST_F(SpaceCompare, IsInspectedAndDrawn) {
  ASSERT_EQ(compare("grey.json -m pt,bdpt -b 1k,4k --replicates 2 -o out -q").exit_code, 0);
  const Outcome text = wander("inspect out");
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_HAS(text.out, "its own relative error is ");
  EXPECT_LACKS(text.out, "its own relative error is unknown");
  const json inspected = json::parse(wander("inspect out --json").out);
  EXPECT_TRUE(inspected["reference"]["relative_error"].is_number());
  EXPECT_EQ(inspected["cells"][3]["file"], "films/bdpt-4k.exr");
  EXPECT_EQ(wander("plot out -o error.svg").exit_code, 0);
  EXPECT_EQ(wander("inspect out/films/bdpt-4k.exr").exit_code, 0);
  EXPECT_EQ(
      wander("plot out/films/pt-4k.exr --reference out/films/reference.exr -o z.svg").exit_code, 0);
  EXPECT_HAS(contents(folder / "z.svg"), "z: difference / standard error of both");
}

}  // namespace
}  // namespace wander::test
