// What a run leaves on the disk: whole files or none, and the same numbers on the way back.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "records/atomic_file.h"
#include "records/exr.h"
#include "records/pending_names.h"
#include "records/rendering_archive.h"
#include "records/run_files.h"
#include "records/run_json.h"
#include "tests/records/made_record.h"

namespace wander::test {
namespace {

namespace fs = std::filesystem;

// An empty directory that is gone when the test is.
class Output : public ::testing::Test {
 protected:
  Output() {
    std::string name = (fs::temp_directory_path() / "wander-output-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~Output() override { fs::remove_all(folder); }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
      names.push_back(entry.path().filename());
    return names;
  }

  fs::path folder;
};

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Files of this process cannot grow beyond a limit, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

std::string error_of_writing(const fs::path& path, std::string_view bytes) {
  try {
    write_file(path, bytes);
  } catch (const OutputError& error) {
    return error.what();
  }
  return "";
}

// ---- whole files or none

TEST_F(Output, AWrittenFileHoldsItsBytesAndLeavesNoOtherFile) {
  write_file(folder / "a", "first");
  write_file(folder / "a", std::string("sec\0ond", 7));
  EXPECT_EQ(contents(folder / "a"), std::string("sec\0ond", 7));
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(Output, AFullDiskLeavesTheFormerFileAndNoHalfOne) {
  write_file(folder / "a", "before");
  const std::string big(1 << 16, 'x');
  std::string message;
  {
    const FileSizeLimit limit(1 << 12);
    message = error_of_writing(folder / "a", big);
  }
  EXPECT_EQ(message, "cannot write " + (folder / "a").string() + ": File too large");
  EXPECT_EQ(contents(folder / "a"), "before");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(Output, AnErrorNamesThePathAndTheReason) {
  EXPECT_EQ(error_of_writing(folder / "no" / "a", "x"),
            "cannot write " + (folder / "no" / "a").string() + ": No such file or directory");
  EXPECT_EQ(error_of_writing(folder, "x"), "cannot write " + folder.string() + ": Is a directory");
}

TEST_F(Output, ADeviceIsWrittenInPlaceAndItsFailureIsSeen) {
  EXPECT_EQ(error_of_writing("/dev/null", "x"), "");
  EXPECT_EQ(error_of_writing("/dev/full", "x"), "cannot write /dev/full: No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Output, ALinkStaysALinkToTheFileThatIsReplaced) {
  write_file(folder / "file", "before");
  fs::create_symlink("file", folder / "link");
  write_file(folder / "link", "after");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contents(folder / "file"), "after");
}

TEST_F(Output, LeftoversGoAndFilesInUseStay) {
  write_file(folder / ".wander-1-0.tmp", "of a program that was killed");
  write_file(folder / "mine.tmp", "mine");
  StagedFile staged(folder / "a", "in use");
  remove_leftovers(folder);
  EXPECT_FALSE(fs::exists(folder / ".wander-1-0.tmp"));
  EXPECT_TRUE(fs::exists(folder / "mine.tmp"));
  staged.commit();
  EXPECT_EQ(contents(folder / "a"), "in use");
  remove_leftovers(folder / "nowhere");
}

// Whatever is written next beside them; what another program works on is locked and stays.
TEST_F(Output, LeftoversGoWithTheNextFile) {
  write_file(folder / ".wander-1-0.tmp", "of a program that was killed");
  fs::create_directory(folder / ".wander-1-1.tmp");
  write_file(folder / ".wander-1-1.tmp" / "mesh", "half");
  const StagedFile staged(folder / "b", "in use");
  write_file(folder / "a", "whole");
  EXPECT_EQ(names().size(), 2U);
  EXPECT_EQ(contents(folder / "a"), "whole");
}

TEST_F(Output, ATemporaryFolderStaysWhileItIsInUse) {
  {
    const TemporaryFolder workshop(folder / "a");
    write_file(folder / "a", "whole");
    EXPECT_TRUE(fs::is_directory(workshop.path()));
    EXPECT_TRUE(is_temporary(workshop.path()));
  }
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(Output, OneHasTheLockOfADirectory) {
  {
    const DirectoryLock first(folder), second(folder);
    EXPECT_TRUE(first.is_held());
    EXPECT_FALSE(second.is_held());
  }
  EXPECT_TRUE(DirectoryLock(folder).is_held());
}

TEST_F(Output, FilesAreCommittedTogether) {
  write_file(folder / "a", "before");
  std::vector<StagedFile> files;
  files.emplace_back(folder / "a", "after");
  files.emplace_back(folder / "b", "new");
  EXPECT_EQ(contents(folder / "a"), "before");
  StagedFile::commit_together(files);
  EXPECT_EQ(contents(folder / "a"), "after");
  EXPECT_EQ(contents(folder / "b"), "new");
  EXPECT_EQ(names().size(), 2U);
}

// A name that cannot be given stands for a program that was stopped between two names.
TEST_F(Output, NamesThatLackAreGivenWhenTheDirectoryIsLookedAt) {
  write_file(folder / "a", "before");
  fs::create_directory(folder / "films");
  std::vector<StagedFile> files;
  files.emplace_back(folder / "a", "after");
  files.emplace_back(folder / "films" / "b", "new");
  files.emplace_back(folder / "c", "last");
  fs::create_directories(folder / "films" / "b" / "in the way");
  EXPECT_THROW(StagedFile::commit_together(files), OutputError);
  files.clear();
  EXPECT_EQ(contents(folder / "a"), "after");
  EXPECT_FALSE(fs::exists(folder / "c"));
  remove_leftovers(folder);  // the way is not free yet: nothing is lost
  fs::remove_all(folder / "films" / "b");
  remove_leftovers(folder / "films");
  EXPECT_EQ(contents(folder / "films" / "b"), "new");
  EXPECT_EQ(contents(folder / "c"), "last");
  EXPECT_EQ(names().size(), 3U);
}

TEST_F(Output, WhereTheFirstNameCannotBeGivenAllIsAsItWas) {
  write_file(folder / "b", "before");
  std::vector<StagedFile> files;
  files.emplace_back(folder / "a", "new");
  files.emplace_back(folder / "b", "after");
  fs::create_directories(folder / "a" / "in the way");
  EXPECT_THROW(StagedFile::commit_together(files), OutputError);
  files.clear();
  remove_leftovers(folder);
  EXPECT_EQ(contents(folder / "b"), "before");
  EXPECT_EQ(names().size(), 2U);
}

// A list that somebody else has written moves nothing of theirs.
TEST_F(Output, AListOfNamesMovesTemporaryFilesAlone) {
  const auto entry = [](std::string from, std::string to) { return from + '\0' + to + '\0'; };
  for (const std::string& list :
       {entry("mine", "theirs"), entry("inside/.wander-1-1.tmp", "inside/../../theirs"),
        entry("inside/.wander-1-1.tmp", "theirs"), entry("/tmp/.wander-1-1.tmp", "/tmp/theirs"),
        std::string("inside/.wander-1-1.tmp\0theirs", 29), std::string(2 << 20, 'x')}) {
    write_file(folder / "mine", "mine");
    fs::create_directory(folder / "inside");
    write_file(folder / ".wander-names.tmp", list);
    { std::ofstream(folder / "inside" / ".wander-1-1.tmp") << "other"; }
    EXPECT_TRUE(give_pending_names(folder));
    EXPECT_EQ(contents(folder / "mine"), "mine");
    EXPECT_FALSE(fs::exists(folder / "theirs"));
    EXPECT_TRUE(fs::exists(folder / "inside" / ".wander-1-1.tmp"));
  }
}

TEST_F(Output, AListThatAProgramWorksOnIsLeftToIt) {
  std::vector<PendingNames::Renaming> names{{folder / ".wander-1-1.tmp", folder / "a"},
                                            {folder / ".wander-1-2.tmp", folder / "b"}};
  { std::ofstream(folder / ".wander-1-1.tmp") << "new"; }
  {
    const PendingNames pending(names);
    EXPECT_FALSE(give_pending_names(folder));
    remove_leftovers(folder);
    EXPECT_TRUE(fs::exists(folder / ".wander-1-1.tmp"));
  }
  EXPECT_TRUE(give_pending_names(folder));
}

TEST_F(Output, AStagedFileThatIsNotCommittedVanishes) {
  { const StagedFile staged(folder / "a", "bytes"); }
  EXPECT_TRUE(names().empty());
}

// ---- film.exr

TEST_F(Output, AnExrReadsBackWhatItHolds) {
  const RunRecord run = markov_chain_run();
  write_file(folder / "film.exr", to_exr(run));
  const RunRecord back = read_exr(folder / "film.exr");
  EXPECT_EQ(back.provenance.scene_text, run.provenance.scene_text);
  EXPECT_EQ(back.provenance.scene_digest, run.provenance.scene_digest);
  EXPECT_EQ(back.provenance.command_line, "wander render box.json");
  EXPECT_EQ(back.provenance.version, "0.1.0");
  for (const OriginField& field : origin_fields)
    EXPECT_EQ(back.provenance.origin.*field.member, run.provenance.origin.*field.member);
  EXPECT_EQ(back.rendering.method, "mlt");
  EXPECT_EQ(back.rendering.seed, run.rendering.seed);
  EXPECT_EQ(back.rendering.samples, run.rendering.samples);
  EXPECT_EQ(back.rendering.film.shape, std::vector{3});
  EXPECT_EQ(back.rendering.film.reliable, run.rendering.film.reliable);
  EXPECT_EQ(back.rendering.film.degrees_of_freedom, 31);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_FLOAT_EQ(static_cast<float>(back.rendering.film.value[i]),
                    static_cast<float>(run.rendering.film.value[i]));
  EXPECT_TRUE(std::isnan(back.rendering.film.standard_error[1]));
  ASSERT_EQ(back.rendering.film.by_length.size(), 2U);
  EXPECT_FLOAT_EQ(static_cast<float>(back.rendering.film.by_length.at(5)[2]), 1 / 3.F);
  ASSERT_TRUE(back.rendering.chains_film);
  EXPECT_FLOAT_EQ(static_cast<float>(back.rendering.chains_film->value[2]), 2 / 3.F);
  EXPECT_FLOAT_EQ(static_cast<float>(back.rendering.chains_film->standard_error[0]), 0.02F);
  EXPECT_EQ(back.rendering.normalization.value().value, 0.6);
  EXPECT_EQ(back.rendering.normalization.value().standard_error, 0.002);
  ASSERT_EQ(back.rendering.mutations.size(), 1U);
  EXPECT_EQ(back.rendering.mutations[0].name, "primary_small");
  EXPECT_EQ(back.rendering.mutations[0].proposed, 1000U);
  EXPECT_NEAR(back.rendering.mutations[0].mean_acceptance, 0.41, 1e-6);
}

TEST_F(Output, AnExrOfEqualContentHasEqualBytesWhateverTheExecution) {
  const RunRecord run = markov_chain_run();
  RunRecord slower = run;
  slower.rendering.threads = 1;
  slower.rendering.seconds = 99;
  EXPECT_EQ(to_exr(run), to_exr(slower));
  slower.rendering.film.value[0] *= 1.001;
  EXPECT_NE(to_exr(run), to_exr(slower));
}

TEST_F(Output, WhatIsBeyondTheRangeOfAFloatIsInfiniteInAnExr) {
  RunRecord run = markov_chain_run();
  run.rendering.film.value = {1e39, -1e300, 3e38};
  write_file(folder / "film.exr", to_exr(run));
  const auto value = read_exr(folder / "film.exr").rendering.film.value;
  EXPECT_EQ(value[0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(value[1], -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(value[2]));
}

TEST_F(Output, AnImageKeepsItsWidthAndHeight) {
  RunRecord run;
  run.provenance.dimension = 3;
  run.rendering.film.shape = {2, 3};
  run.rendering.film.value = {1, 2, 3, 4, 5, 6};
  run.rendering.film.standard_error = std::vector<double>(6, 0.5);
  run.rendering.film.reliable = std::vector<bool>(6, true);
  write_file(folder / "film.exr", to_exr(run));
  const RunRecord back = read_exr(folder / "film.exr");
  EXPECT_EQ(back.rendering.film.shape, run.rendering.film.shape);
  EXPECT_EQ(back.rendering.film.value, run.rendering.film.value);
}

TEST_F(Output, ADamagedExrIsRefusedAndNeverCrashes) {
  const std::string whole = to_exr(markov_chain_run());
  for (std::size_t size = 4; size < whole.size(); size += 7) {
    write_file(folder / "film.exr", std::string_view(whole).substr(0, size));
    EXPECT_THROW(read_exr(folder / "film.exr"), RunFileError) << size;
  }
  for (std::size_t i = 4; i < whole.size(); i += 3) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(~damaged[i]);
    write_file(folder / "film.exr", damaged);
    try {
      read_exr(folder / "film.exr");  // an altered number is still a film
    } catch (const RunFileError&) {
    }
  }
}

description::Scene scene_with_sensor(description::ShapeKind kind, int bins) {
  description::Scene scene;
  description::Shape shape;
  shape.kind = std::move(kind);
  shape.sensor = description::Sensor{{bins}};
  scene.shapes = {description::Shape{}, shape};
  return scene;
}

// ---- a run

TEST_F(Output, ARunReadsBackFromItsDirectoryToTheLastBit) {
  const RunRecord run = markov_chain_run();
  const description::Segment segment{{0, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(holds_run(folder));
  write_run(run, scene_with_sensor(segment, 3), folder);
  EXPECT_EQ(contents(folder / "run.json"), to_json(run).dump(1) + "\n");
  EXPECT_TRUE(holds_run(folder));
  EXPECT_EQ(to_json(read_run(folder)), to_json(run));
  EXPECT_EQ(to_json(read_run(folder / "run.json")), to_json(run));
  EXPECT_EQ(read_run(folder / "film.exr").rendering.method, "mlt");
  EXPECT_TRUE(fs::exists(folder / "film.csv"));
}

// Where this fails, what is archived has changed: then wanderlight-kept (lab/compare/kept_comparison.cpp) and
// wanderlight-reference (lab/compare/reference_cache.cpp) need a new number, or what older programs kept is misread.
TEST(RenderingArchive, HasTheLayoutOfItsFormats) {
  EXPECT_EQ(archived(markov_chain_run().rendering).size(), 1218u)
      << "wanderlight-kept/5, wanderlight-reference/4";
}

TEST_F(Output, AFullDiskLeavesTheWholeFormerRun) {
  RunRecord run = markov_chain_run();
  const description::Scene scene = scene_with_sensor(description::Segment{{0, 0, 0}, {1, 0, 0}}, 3);
  write_run(run, scene, folder);
  const std::string before = contents(folder / "film.exr");
  run.rendering.film.value[0] = 7;
  run.provenance.scene_text = std::string(1 << 16, 'x');  // compresses in no file
  {
    const FileSizeLimit limit(1 << 14);
    EXPECT_THROW(write_run(run, scene, folder), OutputError);
  }
  EXPECT_EQ(contents(folder / "film.exr"), before);
  EXPECT_EQ(names().size(), 3U);
}

TEST_F(Output, AFileThatIsNoRunIsToldFromABrokenOne) {
  write_file(folder / "scene.json", "{ \"format\": \"wanderlight-scene/1\" }");
  EXPECT_FALSE(find_run(folder / "scene.json"));
  EXPECT_FALSE(find_run(folder / "missing"));
  EXPECT_THROW(read_run(folder / "scene.json"), RunFileError);
  const std::string whole = to_json(markov_chain_run()).dump();
  nlohmann::ordered_json broken = to_json(markov_chain_run());
  broken["film"]["value"].push_back(1);
  write_file(folder / "run.json", broken.dump());
  EXPECT_THROW(find_run(folder / "run.json"), RunFileError);
  write_file(folder / "run.json", "{\"schema\":\"wanderlight-run/1\"}");
  EXPECT_THROW(find_run(folder), RunFileError);
}

}  // namespace
}  // namespace wander::test
