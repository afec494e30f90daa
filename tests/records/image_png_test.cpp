// The quick look at an image: film.png and its tone.
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/film_statistics.h"
#include "records/run_files.h"
#include "records/tone.h"
#include "tests/support/images.h"

namespace wander::test::image_png_test {
namespace {

namespace fs = std::filesystem;

class ImagePng : public ::testing::Test {
 protected:
  ImagePng() {
    std::string name = (fs::temp_directory_path() / "wander-png-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~ImagePng() override { fs::remove_all(folder); }

  fs::path folder;
};

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Picture {
  std::uint32_t width, height;
  std::vector<std::uint8_t> pixels;
};

Picture decoded(const std::string& bytes, std::uint32_t format) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(png.format, format);
  Picture picture{png.width, png.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  png_image_finish_read(&png, nullptr, picture.pixels.data(), 0, nullptr);
  return picture;
}

TEST(Tone, IsThatOfSrgb) {
  EXPECT_EQ(srgb_byte(0), 0);
  EXPECT_EQ(srgb_byte(-1), 0);
  EXPECT_EQ(srgb_byte(not_known), 0);
  EXPECT_EQ(srgb_byte(1), 255);
  EXPECT_EQ(srgb_byte(1e300), 255);
  EXPECT_EQ(srgb_byte(std::numeric_limits<double>::infinity()), 255);
  // By the definition of IEC 61966-2-1.
  EXPECT_EQ(srgb_byte(0.5), 188);
  EXPECT_EQ(srgb_byte(0.18), 118);
  EXPECT_EQ(srgb_byte(0.002), 7);  // 12.92 · 0.002 · 255 = 6.59
}

TEST(Tone, HasWhiteAboveNinetyNineOfAHundredPixelsWithLight) {
  FilmEstimate film{.shape = {2, 150}};
  for (int k = 1; k <= 200; ++k) film.value.push_back(k);
  film.value.resize(298, 0);
  film.value.push_back(not_known);
  film.value.push_back(std::numeric_limits<double>::infinity());
  EXPECT_EQ(white_of(film), 198);
  film.value.assign(300, 0);
  EXPECT_EQ(white_of(film), 1);
}

TEST(Tone, TakesTheLuminanceOfColours) {
  FilmEstimate film{.shape = {1, 2, 3}, .value = {1, 0, 0, 0, 0, 1}};
  EXPECT_EQ(white_of(film), 0.2126);
  EXPECT_DOUBLE_EQ(mean_value(film), (0.2126 + 0.0722) / 2);
}

TEST_F(ImagePng, IsShownInGrey) {
  RunRecord run = image_run(2, 2, 1);
  run.rendering.film.value = {0, 0.5, 1, 8};
  write_run(run, {}, folder);
  // White is the largest of so few.
  const Picture picture = decoded(contents(folder / "film.png"), PNG_FORMAT_GRAY);
  EXPECT_EQ(picture.width, 2u);
  EXPECT_EQ(picture.pixels, (std::vector<std::uint8_t>{0, srgb_byte(1. / 16), 99, 255}));
  write_run(run, {}, folder, 3);
  EXPECT_EQ(decoded(contents(folder / "film.png"), PNG_FORMAT_GRAY).pixels,
            (std::vector<std::uint8_t>{0, 188, 255, 255}));
}

TEST_F(ImagePng, IsShownInColour) {
  RunRecord run = image_run(2, 1, 3);
  run.rendering.film.value = {1, 1, 1, 0.5, 0, 0.18};
  write_run(run, {}, folder);
  EXPECT_EQ(decoded(contents(folder / "film.png"), PNG_FORMAT_RGB).pixels,
            (std::vector<std::uint8_t>{255, 255, 255, 188, 0, 118}));
}

}  // namespace
}  // namespace wander::test::image_png_test
