// What a run leaves behind whose film is an image: film.exr and film.nc (film.png: image_png_test.cpp).
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "core/film_statistics.h"
#include "records/atomic_file.h"
#include "records/exr.h"
#include "records/film_netcdf.h"
#include "records/netcdf.h"
#include "records/run_files.h"
#include "records/run_json.h"
#include "records/seal.h"
#include "records/trajectory_netcdf.h"
#include "tests/support/images.h"

namespace wander::test::image_test {
namespace {

namespace fs = std::filesystem;

class Image : public ::testing::Test {
 protected:
  Image() {
    std::string name = (fs::temp_directory_path() / "wander-image-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~Image() override { fs::remove_all(folder); }

  fs::path write_nc(const RunRecord& run) const {
    const fs::path path = folder / "film.nc";
    write_file(path, [&](const ByteSink& file) { write_film_netcdf(run, file); });
    return path;
  }

  fs::path folder;
};

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> channels_in(const fs::path& path) {
  const Imf::InputFile file(path.c_str());
  std::vector<std::string> names;
  const Imf::ChannelList& channels = file.header().channels();
  for (auto it = channels.begin(); it != channels.end(); ++it) names.emplace_back(it.name());
  return names;
}

// As any program would read it.
std::vector<float> channel_in(const fs::path& path, const char* name) {
  Imf::InputFile file(path.c_str());
  const auto& window = file.header().dataWindow();
  const int width = window.max.x + 1, height = window.max.y + 1;
  std::vector<float> pixels(static_cast<std::size_t>(width * height));
  Imf::FrameBuffer frame;
  frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
                                sizeof(float) * static_cast<std::size_t>(width)));
  file.setFrameBuffer(frame);
  file.readPixels(0, height - 1);
  return pixels;
}

// NaN is NaN.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) ||
           (std::isnan(x) && std::isnan(y));
  });
}

// ---- film.exr

TEST_F(Image, HasAChannelForEachLayerOfOneChannel) {
  write_file(folder / "film.exr", to_exr(chains_image_run(5, 3, 1)));
  EXPECT_EQ(channels_in(folder / "film.exr"),
            (std::vector<std::string>{"Y", "acceptance.lens.Y", "chains.Y", "proposed.lens.Y",
                                      "reliable.Y", "samples.Y", "standard_error.Y", "vertices_2.Y",
                                      "vertices_5.Y"}));
}

TEST_F(Image, HasThreeChannelsForEachLayerOfColour) {
  write_file(folder / "film.exr", to_exr(chains_image_run(5, 3, 3)));
  EXPECT_EQ(channels_in(folder / "film.exr"), (std::vector<std::string>{"B",
                                                                        "G",
                                                                        "R",
                                                                        "acceptance.lens.Y",
                                                                        "chains.B",
                                                                        "chains.G",
                                                                        "chains.R",
                                                                        "proposed.lens.Y",
                                                                        "reliable.B",
                                                                        "reliable.G",
                                                                        "reliable.R",
                                                                        "samples.B",
                                                                        "samples.G",
                                                                        "samples.R",
                                                                        "standard_error.B",
                                                                        "standard_error.G",
                                                                        "standard_error.R",
                                                                        "vertices_2.B",
                                                                        "vertices_2.G",
                                                                        "vertices_2.R",
                                                                        "vertices_5.B",
                                                                        "vertices_5.G",
                                                                        "vertices_5.R"}));
}

// More rows than are written at once.
TEST_F(Image, HasItsPixelsWhereOthersLookForThem) {
  const RunRecord run = chains_image_run(7, 37, 3);
  write_file(folder / "film.exr", to_exr(run));
  const auto red = channel_in(folder / "film.exr", "R"),
             blue = channel_in(folder / "film.exr", "B");
  const auto error = channel_in(folder / "film.exr", "standard_error.G");
  const auto flags = channel_in(folder / "film.exr", "reliable.R");
  const auto proposed = channel_in(folder / "film.exr", "proposed.lens.Y");
  const FilmEstimate& film = run.rendering.film;
  ASSERT_EQ(red.size(), 7u * 37u);
  for (std::size_t p = 0; p < red.size(); ++p) {
    EXPECT_EQ(red[p], static_cast<float>(film.value[3 * p])) << p;
    EXPECT_EQ(blue[p], static_cast<float>(film.value[3 * p + 2])) << p;
    EXPECT_EQ(error[p], static_cast<float>(film.standard_error[3 * p + 1])) << p;
    EXPECT_EQ(flags[p], film.reliable[3 * p] ? 1.F : 0.F) << p;
    EXPECT_EQ(proposed[p], static_cast<float>(p % 7 * 100)) << p;
  }
}

TEST_F(Image, OfColourReadsBackFromItsExr) {
  const RunRecord run = chains_image_run(7, 37, 3);
  write_file(folder / "film.exr", to_exr(run));
  const RunRecord back = read_exr(folder / "film.exr");
  const FilmEstimate &film = run.rendering.film, &read = back.rendering.film;
  EXPECT_EQ(read.shape, (std::vector{37, 7, 3}));
  EXPECT_EQ(read.reliable, film.reliable);
  ASSERT_EQ(read.value.size(), film.value.size());
  for (std::size_t i = 0; i < film.value.size(); ++i) {
    EXPECT_EQ(read.value[i], static_cast<float>(film.value[i]));
    EXPECT_EQ(read.by_length.at(5)[i], static_cast<float>(film.standard_error[i]));
  }
  ASSERT_EQ(back.rendering.mutations.size(), 1u);
  EXPECT_EQ(back.rendering.mutations[0].proposed_per_bin,
            run.rendering.mutations[0].proposed_per_bin);
}

// Of a large film mutations are known by the cells of a raster; that of 256 × 256 has 128 × 128.
TEST_F(Image, SharesTheMapsOfCellsAmongTheirPixels) {
  RunRecord run = chains_image_run(256, 256, 3);
  MutationRecord& lens = run.rendering.mutations[0];
  lens.proposed_per_bin.assign(128 * 128, 8);
  lens.acceptance_per_bin.assign(128 * 128, 0.25);
  lens.proposed_per_bin[1] = 40;
  lens.acceptance_per_bin[1] = 0.5;
  write_file(folder / "film.exr", to_exr(run));
  const auto proposed = channel_in(folder / "film.exr", "proposed.lens.Y");
  const auto acceptance = channel_in(folder / "film.exr", "acceptance.lens.Y");
  for (const std::size_t p : {2, 3, 258, 259}) {
    EXPECT_EQ(proposed[p], 10.F) << p;
    EXPECT_EQ(acceptance[p], 0.5F) << p;
  }
  EXPECT_EQ(proposed[1], 2.F);
  EXPECT_EQ(proposed[4], 2.F);
  EXPECT_EQ(acceptance[512], 0.25F);
}

TEST_F(Image, WithoutAChannelIsRefused) {
  RunRecord run = image_run(4, 3, 1);
  std::string bytes = to_exr(run);
  // A name of the same length.
  const auto at = bytes.find("standard_error.Y");
  bytes.replace(at, 16, "standard_error.Z");
  write_file(folder / "film.exr", bytes);
  EXPECT_THROW(read_exr(folder / "film.exr"), RunFileError);
}

// ---- film.nc

TEST_F(Image, ReadsBackFromNetcdfToTheLastBit) {
  for (const int channels : {1, 3}) {
    RunRecord run = chains_image_run(300, 70, channels);
    run.rendering.film.standard_error[5] = not_known;
    run.rendering.film.value[7] = 1e300;
    run.provenance.origin.commit = "c0ffee";
    const RunRecord back = read_film_netcdf(write_nc(run));
    const FilmEstimate &film = run.rendering.film, &read = back.rendering.film;
    EXPECT_EQ(read.shape, film.shape);
    EXPECT_TRUE(same(read.value, film.value));
    EXPECT_TRUE(same(read.standard_error, film.standard_error));
    EXPECT_EQ(read.reliable, film.reliable);
    EXPECT_EQ(read.degrees_of_freedom, film.degrees_of_freedom);
    ASSERT_EQ(read.by_length.size(), 2u);
    EXPECT_TRUE(same(read.by_length.at(5), film.by_length.at(5)));
    ASSERT_TRUE(back.rendering.chains_film);
    EXPECT_TRUE(same(back.rendering.chains_film->value, run.rendering.chains_film->value));
    EXPECT_TRUE(back.rendering.chains_film->standard_error.empty()) << "not known of an image";
    EXPECT_TRUE(same(back.rendering.pooling.value().film_of_samples,
                     run.rendering.pooling->film_of_samples));
    ASSERT_EQ(back.rendering.mutations.size(), 1u);
    const MutationRecord &lens = run.rendering.mutations[0], &again = back.rendering.mutations[0];
    EXPECT_EQ(again.name, "lens");
    EXPECT_TRUE(same(again.acceptance_per_bin, lens.acceptance_per_bin));
    EXPECT_TRUE(same(again.proposed_per_bin, lens.proposed_per_bin));
    EXPECT_EQ(back.rendering.normalization.value().standard_error, 0.002);
    EXPECT_EQ(back.rendering.samples, run.rendering.samples);
    EXPECT_EQ(back.provenance.scene_text, run.provenance.scene_text);
    EXPECT_EQ(back.provenance.scene_digest, run.provenance.scene_digest);
    EXPECT_EQ(back.provenance.dimension, 3);
    EXPECT_EQ(back.provenance.origin.commit, "c0ffee");
  }
}

// What xarray and netCDF's own tools look for.
TEST_F(Image, HasTheDimensionsAndVariablesOfItsLayout) {
  const std::string bytes = contents(write_nc(chains_image_run(5, 3, 3)));
  const netcdf::Reader reader(unsealed(bytes).value());
  const auto file = reader.root();
  EXPECT_EQ(file.dimension("y"), 3u);
  EXPECT_EQ(file.dimension("x"), 5u);
  EXPECT_EQ(file.dimension("channel"), 3u);
  const std::vector<std::string> names = file.variables();
  EXPECT_EQ((std::set<std::string>{names.begin(), names.end()}),
            (std::set<std::string>{"channel", "value", "standard_error", "reliable", "vertices_2",
                                   "vertices_5", "chains", "samples", "acceptance.lens",
                                   "proposed.lens"}));
  EXPECT_EQ(file.lengths("value"), (std::vector<std::size_t>{3, 5, 3}));
  EXPECT_EQ(file.lengths("acceptance.lens"), (std::vector<std::size_t>{3, 5}));
  EXPECT_EQ(file.text("format"), "wanderlight-film/1");
  EXPECT_EQ(file.text("seed"), "1");
  EXPECT_EQ(file.number("normalization"), 0.6);
}

TEST_F(Image, OfEqualContentHasEqualBytes) {
  RunRecord run = chains_image_run(5, 3, 1);
  const std::string bytes = contents(write_nc(run));
  run.rendering.seconds = 99;
  run.rendering.threads = 7;
  EXPECT_EQ(contents(write_nc(run)), bytes);
  run.rendering.film.value[3] += 1;
  EXPECT_NE(contents(write_nc(run)), bytes);
}

TEST_F(Image, WhoseNetcdfIsDamagedIsRefusedWithItsName) {
  const std::string whole = contents(write_nc(chains_image_run(5, 3, 1)));
  const auto message = [&](const std::string& bytes) -> std::string {
    write_file(folder / "film.nc", bytes);
    try {
      read_film_netcdf(folder / "film.nc");
    } catch (const RunFileError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(whole), "");
  for (const std::size_t size : {std::size_t{0}, whole.size() / 2, whole.size() - 1})
    EXPECT_NE(message(whole.substr(0, size)).find("film.nc: not a film of this program, or cut"),
              std::string::npos);
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 40) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    EXPECT_NE(message(damaged), "") << at;
  }
}

TEST_F(Image, IsToldFromATrajectory) {
  const fs::path film = write_nc(image_run(4, 3, 1));
  EXPECT_TRUE(is_film_netcdf(film));
  EXPECT_FALSE(find_trajectory(film));
  EXPECT_EQ(find_run(film).value().rendering.film.value.size(), 12u);
  write_file(folder / "other.nc", sealed("\x89HDF\r\n\x1a\n and so on"));
  EXPECT_FALSE(is_film_netcdf(folder / "other.nc"));
}

// ---- the whole run

using Names = std::set<std::string>;

Names names_in(const fs::path& folder) {
  Names names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

TEST_F(Image, ReadsBackFromItsDirectoryToTheLastBit) {
  const RunRecord run = chains_image_run(20, 10, 3);
  write_run(run, {}, folder);
  EXPECT_EQ(names_in(folder), (Names{"film.exr", "film.nc", "film.png", "run.json"}));
  const auto json = nlohmann::json::parse(contents(folder / "run.json"));
  EXPECT_EQ(json["film"]["shape"], nlohmann::json({10, 20, 3}));
  EXPECT_FALSE(json["film"].contains("value"));
  EXPECT_EQ(json["film"]["degrees_of_freedom"], 2e6);
  for (const fs::path& place : {folder, folder / "run.json"}) {
    const RunRecord back = read_run(place);
    EXPECT_TRUE(same(back.rendering.film.value, run.rendering.film.value));
    EXPECT_EQ(back.rendering.seconds, run.rendering.seconds);
    EXPECT_EQ(to_json(back), to_json(run));
  }
  EXPECT_TRUE(find_run_alone(folder).value().rendering.film.value.empty());
  fs::remove(folder / "film.nc");
  EXPECT_TRUE(read_run(folder).rendering.film.value.empty());
}

TEST_F(Image, OfAnotherRunIsNotTakenForTheFilm) {
  write_run(image_run(6, 4, 1, 1), {}, folder);
  write_nc(image_run(6, 4, 1, 2));
  EXPECT_THROW(read_run(folder), RunFileError);
  write_nc(image_run(4, 6, 1, 1));
  EXPECT_THROW(read_run(folder), RunFileError);
  write_nc(image_run(6, 4, 1, 1));
  EXPECT_EQ(read_run(folder).rendering.film.value.size(), 24u);
}

TEST_F(Image, LeavesNoFileOfTheRowOfBinsThatItReplaces) {
  description::Scene scene;
  scene.camera.emplace().resolution = {3};
  RunRecord row;
  row.rendering.film = {.shape = {3},
                        .value = {1, 2, 3},
                        .standard_error = {0.1, 0.1, 0.1},
                        .reliable = {true, true, true}};
  write_run(row, scene, folder);
  EXPECT_EQ(names_in(folder), (Names{"film.exr", "film.csv", "run.json"}));
  write_run(image_run(6, 4, 1), {}, folder);
  EXPECT_EQ(names_in(folder), (Names{"film.exr", "film.nc", "film.png", "run.json"}));
  write_run(row, scene, folder);
  EXPECT_EQ(names_in(folder), (Names{"film.exr", "film.csv", "run.json"}));
}

}  // namespace
}  // namespace wander::test::image_test
