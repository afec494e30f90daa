// Hostile input, a bounded run of every target of libFuzzer: its corpus and files made of it keep the contract.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "records/run_record.h"
#include "scenes/format/scene_file.h"
#include "tests/fuzz/drive.h"
#include "tests/tools/command_line.h"

namespace wander::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus_of(const Target& target) {
  std::vector<fs::path> paths;
  for (const auto& entry :
       fs::directory_iterator(fs::path(WANDER_SOURCE) / "tests/fuzz/corpus" / target.kind))
    paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<std::string> files;
  for (const fs::path& path : paths) {
    std::ifstream stream(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return files;
}

// A target, and how many files are made: as many as fit into half a second of an optimised program; tests/fuzz/run makes millions.
struct Case {
  const Target& target;
  int made;
};

class HostileInput : public testing::TestWithParam<Case> {};

TEST_P(HostileInput, IsReadOrRefusedInOurOwnWords) {
  const auto& [target, made] = GetParam();
  const std::vector<std::string> files = corpus_of(target);
  ASSERT_GE(files.size(), 2u);
  EXPECT_EQ(first_breach(target, files, made).value_or(""), "");
}

INSTANTIATE_TEST_SUITE_P(Fuzz, HostileInput,
                         testing::Values(Case{checkpoint_target, 2000}, Case{exr_target, 400},
                                         Case{film_target, 600}, Case{mitsuba_target, 1600},
                                         Case{obj_target, 400}, Case{ply_target, 400},
                                         Case{reference_target, 2400}, Case{run_target, 2400},
                                         Case{scene_target, 1600}, Case{texture_target, 400},
                                         Case{trajectory_target, 400}),
                         [](const auto& each) { return std::string(each.param.target.kind); });

// The seeds are read, or what is made of them is refused for no more than the beginning of a file.
TEST(HostileInputs, BeginWithSoundFiles) {
  for (const Target* target : {&obj_target, &ply_target, &texture_target, &exr_target, &run_target,
                               &film_target, &trajectory_target, &reference_target}) {
    int sound = 0;
    const fs::path folder = fs::path(testing::TempDir()) / "fuzz_seeds";
    fs::create_directories(folder);
    for (const std::string& file : corpus_of(*target)) {
      try {
        target->read(file, folder);
        ++sound;
      } catch (const std::exception&) {
      }
    }
    fs::remove_all(folder);
    EXPECT_GE(sound, 1) << target->kind;
  }
}

// ---- controls: targets that break the contract

std::string breach_of(void (*read)(std::string_view, const fs::path&)) {
  return first_breach({"planted", read}, {"one", "two"}, 100).value_or("");
}

TEST(HostileInputControls, CatchAnExceptionOfALibrary) {
  EXPECT_HAS(breach_of([](std::string_view bytes, const fs::path&) {
               if (bytes != "one" && bytes != "two") throw std::out_of_range("vector::at");
             }),
             "ends the program");
}

TEST(HostileInputControls, CatchWordsOfALibrary) {
  EXPECT_HAS(breach_of([](std::string_view, const fs::path& folder) {
               throw RunFileError((folder / "run.json").string() +
                                  ": [json.exception.type_error.302] type must be number");
             }),
             "as a library does");
}

TEST(HostileInputControls, MayQuoteWhatTheirFilesSay) {
  EXPECT_EQ(breach_of([](std::string_view bytes, const fs::path& folder) {
              write_bytes(folder / "run.json", "its format is Iex" + std::string(bytes));
              throw RunFileError((folder / "run.json").string() + ": its format is Iex");
            }),
            "");
}

TEST(HostileInputControls, TakeTheLettersOfAShownByteForNoWord) {
  EXPECT_EQ(breach_of([](std::string_view, const fs::path& folder) {
              throw RunFileError((folder / "mesh.obj").string() + ": \\xcbad_alloc is no integer");
            }),
            "");
}

TEST(HostileInputControls, CatchAMessageThatNamesNoFile) {
  EXPECT_HAS(
      breach_of([](std::string_view, const fs::path&) { throw RunFileError("it is broken"); }),
      "does not begin with its file");
}

TEST(HostileInputControls, CatchAMessageThatIsNoText) {
  for (const char* what : {": it is \x1b[31mred", ": it is \xff"})
    EXPECT_NE(breach({"planted",
                      [](std::string_view bytes, const fs::path& folder) {
                        throw RunFileError((folder / "run.json").string() + std::string(bytes));
                      }},
                     what),
              std::nullopt);
}

TEST(HostileInputControls, CatchWhatTheMutationsFind) {
  EXPECT_HAS(breach_of([](std::string_view bytes, const fs::path&) {
               if (bytes.find("null") != bytes.npos) throw std::runtime_error("a rare fault");
             }),
             "a rare fault");
}

}  // namespace
}  // namespace wander::fuzz
