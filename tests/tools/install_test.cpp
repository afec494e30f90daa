// What `cmake --install` leaves, and whether shells and man take it.
#include <sstream>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

class Installation : public CommandLine {
 protected:
  Installation() {
    installed_ = shell("cmake --install '" WANDER_BUILD "' --prefix \"$PWD/usr\" >/dev/null");
  }
  bool has(const std::string& shell_name) const {
    return shell("command -v " + shell_name).exit_code == 0;
  }
  // What bash offers after this line, in the order of the alphabet.
  std::string offered(const std::string& line) const {
    write("complete.bash",
          "source usr/share/bash-completion/completions/wander\n"
          "COMP_LINE=$1 COMP_POINT=${#1}\n_wander\n"
          "printf '%s\\n' \"${COMPREPLY[@]}\" | sort | tr '\\n' ' '\n");
    const Outcome outcome = shell("bash complete.bash '" + line + "'");
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }

  Outcome installed_;
};

TEST_F(Installation, HoldsTheProgramAndWhatItShips) {
  ASSERT_EQ(installed_.exit_code, 0) << installed_.err;
  for (const char* file :
       {"usr/bin/wander", "usr/share/wanderlight/schema/scene.schema.json",
        "usr/share/wanderlight/scenes/slit.json", "usr/share/wanderlight/scenes/meshes/ring.obj",
        "usr/share/man/man1/wander.1", "usr/share/doc/wanderlight/LICENSE",
        "usr/share/bash-completion/completions/wander", "usr/share/zsh/site-functions/_wander",
        "usr/share/fish/vendor_completions.d/wander.fish"})
    EXPECT_GT(fs::file_size(folder / file), 100U) << file;
  EXPECT_EQ(shell("usr/bin/wander gallery slit").out,
            contents(folder / "usr/share/wanderlight/scenes/slit.json"));
  EXPECT_EQ(shell("ls usr/share/wanderlight/scenes/*.json | wc -l").out,
            shell("\"$WANDER\" gallery | wc -l").out);
}

// Those that the program, the citation, the changelog and CMake name.
using Versions = CommandLine;

TEST_F(Versions, Agree) {
  const fs::path source = WANDER_SOURCE;
  EXPECT_NE(contents(source / "CITATION.cff").find("\nversion: " + version() + "\n"),
            std::string::npos);
  // Its newest heading.
  EXPECT_TRUE(
      contents(source / "CHANGELOG.md").starts_with("# Changelog\n\n## " + version() + " "));
  EXPECT_NE(contents(source / "CMakeLists.txt").find("VERSION " + version() + " "),
            std::string::npos);
}

TEST_F(Installation, BashCompletesVerbsOptionsMethodsAndScenes) {
  ASSERT_EQ(shell("bash -n usr/share/bash-completion/completions/wander").exit_code, 0);
  EXPECT_EQ(offered("wander re"), "render ");
  EXPECT_EQ(offered("wander help tr"), "trace ");
  EXPECT_EQ(offered("wander trace --ch"), "--chains ");
  EXPECT_EQ(offered("wander render box.json -m ml"), "mlt ");
  EXPECT_EQ(offered("wander render box.json --method=mm"), "mmlt ");
  EXPECT_EQ(offered("wander trace box.json -m "), "mlt mmlt ");
  EXPECT_EQ(offered("wander compare box.json -m bdpt,ml"), "bdpt,mlt ");
  EXPECT_EQ(offered("wander gallery mirror-"), "mirror-dish ");
  EXPECT_EQ(offered("wander render gallery:mirror-"),
            "mirror-dish ");  // bash splits words at the colon
  EXPECT_EQ(offered("wander render bo"), "box.json ");
  EXPECT_EQ(offered("wander render box.json -o "), " ");  // files, by bash itself
}

// Of every option that takes one of a few words, in the words of its own messages.
TEST_F(Installation, ShellsCompleteTheWordsOfOptions) {
  EXPECT_EQ(offered("wander plot t.nc --figure a"), "acceptance all autocorrelation ");
  EXPECT_EQ(offered("wander render box.json -m mlt --normalization "),
            "bridge least-squares seed ");
  EXPECT_EQ(offered("wander render box.json --estimator=k"), "kelemen ");
  EXPECT_EQ(offered("wander render box.json --precision "), "double float ");
  EXPECT_EQ(offered("wander plot a.csv --layout p"), "panels ");
  EXPECT_EQ(offered("wander render box.json --progress "), "auto bar json none ");
  const std::string zsh = contents(folder / "usr/share/zsh/site-functions/_wander"),
                    fish = contents(folder / "usr/share/fish/vendor_completions.d/wander.fish");
  for (const char* words : {"paths trace acceptance autocorrelation density all",
                            "seed least-squares bridge", "kelemen expected"}) {
    EXPECT_HAS(zsh, "(" + std::string(words) + ")");
    EXPECT_HAS(fish, "-x -a '" + std::string(words) + "'");
  }
  for (const char* command :
       {"render box.json -m mlt -o o --normalization x",
        "render box.json -m pssmlt -o o --estimator x", "plot box.json -o o.svg --figure x"})
    EXPECT_HAS(wander(command).err, "allowed are ");
}

TEST_F(Installation, EveryOptionOfEveryVerbIsCompleted) {
  for (const std::string verb :
       {"render", "trace", "compare", "inspect", "gallery", "plot", "check", "merge", "import"}) {
    const std::string options =
        shell("\"$WANDER\" " + verb +
              " --help | grep -oE '^  (-.,)?--[a-z-]+' | grep -oE -- '--.*'")
            .out;
    const std::string completed = " " + offered("wander " + verb + " -");
    std::istringstream lines(options);
    for (std::string option; std::getline(lines, option);)
      EXPECT_HAS(completed, " " + option + " ");
    EXPECT_HAS(options, "--json");
  }
}

TEST_F(Installation, ZshAndFishTakeTheirScripts) {
  if (!has("zsh") || !has("fish")) GTEST_SKIP() << "zsh or fish is not installed";
  const Outcome zsh = shell("zsh -n usr/share/zsh/site-functions/_wander");
  EXPECT_EQ(zsh.exit_code, 0) << zsh.err;
  const std::string fish = "usr/share/fish/vendor_completions.d/wander.fish";
  EXPECT_EQ(shell("fish --no-execute " + fish).exit_code, 0);
  const auto offered_by_fish = [&](const std::string& line) {
    return shell("HOME=$PWD fish -c 'source " + fish + "; complete -C \"" + line + "\"' | cut -f1")
        .out;
  };
  EXPECT_EQ(offered_by_fish("wander rend"), "render\n");
  EXPECT_EQ(offered_by_fish("wander render box.json --method ml"), "mlt\n");
  EXPECT_EQ(offered_by_fish("wander trace --chai"), "--chains\n");
  EXPECT_EQ(offered_by_fish("wander gallery mirror-"), "mirror-dish\n");
}

TEST_F(Installation, TheManualPageIsThatOfTheProgram) {
  const std::string page = contents(folder / "usr/share/man/man1/wander.1");
  for (const char* part : {".SH NAME", "wander render", "wander compare", ".SH EXIT STATUS",
                           "\\fB\\-\\-mutations\\fR", "\\fB\\-\\-force\\fR"})
    EXPECT_HAS(page, part);
  if (!has("groff")) GTEST_SKIP() << "groff is not installed";
  const Outcome set = shell("groff -man -Tutf8 -ww -k -z usr/share/man/man1/wander.1");
  EXPECT_EQ(set.exit_code, 0);
  EXPECT_EQ(set.err, "");
}

TEST_F(Installation, TheManualPageFitsATerminal) {
  if (!has("man")) GTEST_SKIP() << "man is not installed";
  const Outcome shown = shell(
      "MANWIDTH=80 LC_ALL=C.UTF-8 man -l usr/share/man/man1/wander.1 >page && "
      "LC_ALL=C.UTF-8 wc -L <page");
  ASSERT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_GT(std::stoi(shown.out), 60);
  EXPECT_LE(std::stoi(shown.out), 90);
  const std::string page = contents(folder / "page");
  // Lists and commands have stayed such.
  for (const char* line :
       {"\n       mlt    Metropolis", "\n       130    interrupted",
        "         wander trace scene.json --steps 2000 --chains 4 -o chains.nc\n"})
    EXPECT_HAS(page, line);
}

}  // namespace
}  // namespace wander::test
