// Every output says which build made it, on which machine and when.
#include "records/origin.h"

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;

bool is_complete(const json& document) {
  const json origin = document.at("provenance");
  for (const OriginField& field : origin_fields)
    if (origin.value(field.name, "").empty()) return false;
  return std::regex_match(origin.at("date").get<std::string>(),
                          std::regex("20[0-9]{2}-[01][0-9]-[0-3][0-9]T[0-9:]{8}Z")) &&
         std::regex_match(origin.at("commit").get<std::string>(),
                          std::regex("unknown|[0-9a-f]{7,40}(\\+changes)?"));
}

class OriginOf : public CommandLine {
 protected:
  json inspection_of(const char* file) const {
    return json::parse(wander(std::string("inspect --json ") + file).out);
  }
};

TEST_F(OriginOf, EveryOutputIsKnown) {
  ASSERT_EQ(wander("render box.json -m pt -b 1k -o run -q").exit_code, 0);
  ASSERT_EQ(wander("trace box.json --steps 5 -o t.nc -q").exit_code, 0);
  ASSERT_EQ(wander("compare box.json -m pt -b 1k --replicates 2 -o out -q").exit_code, 0);
  EXPECT_TRUE(is_complete(json::parse(contents(folder / "run/run.json"))));
  EXPECT_TRUE(is_complete(json::parse(contents(folder / "out/compare.json"))));
  for (const char* file : {"run", "run/film.exr", "t.nc", "out"}) {
    EXPECT_TRUE(is_complete(inspection_of(file))) << file;
    const std::string text = wander(std::string("inspect ") + file).out;
    EXPECT_HAS(text, "from commit ");
    EXPECT_HAS(text, inspection_of(file)["provenance"]["cpu"].get<std::string>());
  }
  EXPECT_HAS(contents(folder / "out/report.html"), "built from");
}

TEST_F(OriginOf, RecordsFromBeforeItWasKeptAreRead) {
  ASSERT_EQ(wander("render box.json -m pt -b 1k -o run -q").exit_code, 0);
  json run = json::parse(contents(folder / "run/run.json"));
  run.erase("provenance");
  write("run/run.json", run.dump(1));
  const Outcome outcome = wander("inspect run");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_LACKS(outcome.out, "from commit");
}

TEST_F(OriginOf, TheCommitIsThatOfTheWorkingCopy) {
  const std::string write_commit =
      "cmake -DOUTPUT=$PWD/commit.cpp -DSOURCE=$PWD/copy -P '" WANDER_SOURCE
      "/records/commit.cmake' && sed -n 's/.*= \"\\(.*\\)\".*/\\1/p' commit.cpp";
  const std::string git = "git -C copy -c user.name=a -c user.email=a@b";
  EXPECT_EQ(shell("mkdir copy && echo one > copy/file && " + write_commit).out, "unknown\n");
  const Outcome clean = shell("git init -q copy && " + git + " add file && " + git +
                              " commit -qm one && git -C copy rev-parse --short=12 HEAD && " +
                              write_commit + " && touch -d '2001-01-01' commit.cpp && " +
                              write_commit + " && stat -c %y commit.cpp");
  ASSERT_EQ(clean.exit_code, 0) << clean.err;
  const std::string commit = clean.out.substr(0, 13);
  EXPECT_TRUE(clean.out.starts_with(commit + commit + commit + "2001-01-01")) << clean.out;
  EXPECT_EQ(shell("echo two > copy/file && " + write_commit).out,
            commit.substr(0, 12) + "+changes\n");
}

}  // namespace
}  // namespace wander::test
