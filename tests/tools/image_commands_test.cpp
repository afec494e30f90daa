// What the verbs do with a run whose film is an image.
#include <nlohmann/json.hpp>

#include "records/run_files.h"
#include "records/run_json.h"
#include "tests/support/images.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;

class ImageCommands : public CommandLine {
 protected:
  void put(const char* name, const RunRecord& run) const {
    fs::create_directory(folder / name);
    write_run(run, {}, folder / name);
  }
};

TEST_F(ImageCommands, DrawWhatHoldsIt) {
  put("one", image_run(24, 16, 3, 1));
  put("other", image_run(24, 16, 3, 2));
  for (const char* file : {"one", "one/run.json", "one/film.nc", "one/film.exr"}) {
    const Outcome outcome = wander("plot " + std::string(file) + " --force -o one.svg --json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["kind"], "film");
    EXPECT_HAS(contents(folder / "one.svg"), ">luminance of mean radiance, W/(m²·sr)<");
  }
  EXPECT_EQ(wander("plot one other --exposure=-1.5 -o two.png").exit_code, 0);
  EXPECT_EQ(wander("plot one --reference other/film.nc --width 120mm -o two.svg").exit_code, 0);
  EXPECT_HAS(contents(folder / "two.svg"), "bdpt − bdpt, 2 M samples");
}

TEST_F(ImageCommands, DrawWhatEachSideCarries) {
  put("pooled", chains_image_run(24, 16, 3));
  const Outcome outcome = wander("plot pooled --parts -o parts.svg --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["kind"], "parts");
  for (const char* words : {"what samples carry", "what chains carry", "25 % of the light", "LDSE"})
    EXPECT_HAS(contents(folder / "parts.svg"), words);
  put("samples", image_run(24, 16, 3));
  expect_one_fault(wander("plot samples --parts -o no.svg"), 2, {"not pooled", "--film pooled"});
  for (const char* alone : {"pooled/film.nc", "pooled/film.exr"}) {
    expect_one_fault(wander(std::string("plot ") + alone + " --parts -o no.svg"), 2, {"directory"});
    const Outcome told = wander(std::string("inspect ") + alone);
    EXPECT_EQ(told.exit_code, 0) << told.err;
    EXPECT_LACKS(told.out, "pooled ");
  }
  for (const char* option : {"--log-y", "--layout panels", "--draws 0:2"})
    expect_one_fault(wander(std::string("plot pooled --parts -o no.svg ") + option), 2,
                     {"--parts"});
  expect_one_fault(wander("plot pooled samples --parts -o no.svg"), 2, {"--parts is of one run"});
}

TEST_F(ImageCommands, TellWhatItHolds) {
  RunRecord run = image_run(24, 16, 3);
  put("one", run);
  const Outcome text = wander("inspect one");
  EXPECT_HAS(text.out, "24 x 16 pixels in colour, mean luminance ");
  EXPECT_HAS(text.out, "channels        mean R ");
  EXPECT_HAS(text.out, " numbers");
  for (const char* file : {"one", "one/film.nc", "one/film.exr"}) {
    const json film = json::parse(wander("inspect --json " + std::string(file)).out)["film"];
    EXPECT_EQ(film["shape"], json({16, 24, 3}));
    EXPECT_EQ(film["channels"], json({"R", "G", "B"}));
    EXPECT_GT(film["relative_error"], 0);
    EXPECT_GT(film["reliable_share"], 0.9);
    const double mean = 0.2126 * film["channel_means"]["R"].get<double>() +
                        0.7152 * film["channel_means"]["G"].get<double>() +
                        0.0722 * film["channel_means"]["B"].get<double>();
    EXPECT_NEAR(film["mean"], mean, 1e-12);
  }
  put("grey", image_run(24, 16, 1));
  EXPECT_HAS(wander("inspect grey").out, "24 x 16 pixels, mean 0.");
  EXPECT_HAS(wander("inspect grey/film.nc").out, " of 384 pixels");
}

TEST_F(ImageCommands, HoldItAgainstAnother) {
  put("one", image_run(24, 16, 1, 1));
  put("other", image_run(24, 16, 1, 2));
  put("small", image_run(12, 16, 1, 2));
  const json comparison =
      json::parse(wander("inspect one --reference other --json").out)["comparison"];
  EXPECT_GT(comparison["bins"], 300);
  EXPECT_LT(comparison["chi2_per_degree"], 1.5);
  expect_one_fault(wander("inspect one --reference small"), 2,
                   {"24 x 16 pixels", "12 x 16 pixels", "nothing to compare"});
}

// The exact film is the one that is held against others.
TEST_F(ImageCommands, TakeTheExactFilm) {
  RunRecord run = image_run(24, 16, 1);
  run.rendering.film.value[3] = 1 + 1e-12;
  put("one", run);
  run.rendering.film.value[3] = 1;
  put("other", run);
  const auto error = [&](const std::string& one, const std::string& other) {
    return json::parse(wander("inspect " + one + " --reference " + other + " --json")
                           .out)["comparison"]["relative_rmse"]
        .get<double>();
  };
  EXPECT_GT(error("one", "other"), 0);
  EXPECT_EQ(error("one/film.exr", "other/film.exr"), 0);
}

TEST_F(ImageCommands, RefuseWhatMakesNoSense) {
  put("one", image_run(24, 16, 1));
  put("small", image_run(12, 16, 1));
  put("bare", image_run(12, 16, 1));
  fs::remove(folder / "bare/film.nc");
  ASSERT_EQ(wander("render box.json -m pt -b 1k -q -o row").exit_code, 0);
  expect_one_fault(wander("plot one row -o a.svg"), 2, {"one is an image and row a row of bins"});
  expect_one_fault(wander("plot row one -o a.svg"), 2, {"one is an image and row a row of bins"});
  expect_one_fault(wander("plot one small -o a.svg"), 2, {"12 x 16 pixels", "24 x 16 pixels"});
  expect_one_fault(wander("plot one --log-y -o a.svg"), 2, {"--log-y", "one is an image"});
  expect_one_fault(wander("plot one --layout panels -o a.svg"), 2, {"--layout", "image"});
  expect_one_fault(wander("plot row --exposure 1 -o a.svg"), 2, {"--exposure is for images"});
  expect_one_fault(wander("plot box.json --exposure 1 -o a.svg"), 2, {"--exposure is for images"});
  expect_one_fault(wander("plot one --exposure bright -o a.svg"), 2, {"'bright'", "stops"});
  expect_one_fault(wander("plot bare -o a.svg"), 3, {"bare", "film.nc"});
  expect_one_fault(wander("render box.json -m pt -b 1k --exposure 1 -o a"), 2,
                   {"--exposure is for film.png", "row of bins"});
  expect_one_fault(wander("render --continue --exposure 1 -o row"), 2,
                   {"--exposure is for film.png"});
  EXPECT_FALSE(exists("a"));
  EXPECT_FALSE(exists("a.svg"));
}

TEST_F(ImageCommands, RefuseADamagedFilm) {
  put("one", image_run(24, 16, 1));
  change("one/film.nc", [](std::string& bytes) { bytes.resize(bytes.size() / 2); });
  expect_one_fault(wander("inspect one"), 3, {"one/film.nc", "cut short or changed"});
  expect_one_fault(wander("plot one/run.json -o a.svg"), 3, {"one/film.nc"});
  expect_one_fault(wander("plot one/film.nc -o a.svg"), 3, {"one/film.nc", "cut short or changed"});
  expect_one_fault(wander("inspect one/film.nc"), 3, {"one/film.nc", "cut short or changed"});
}

}  // namespace
}  // namespace wander::test
