// Work in a process of its own: what it returns and throws comes back, and its end is not ours.
#include "draw/figure/child_process.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <new>

#include "draw/figure/rendition.h"

namespace wander::figure {
namespace {

std::string problem_of(const std::function<std::string()>& work) {
  try {
    in_a_child(work, "given up");
  } catch (const std::runtime_error& problem) {
    return problem.what();
  }
  return "";
}

TEST(ChildProcess, WhatWorkReturnsComesBackWhole) {
  EXPECT_EQ(in_a_child([] { return std::string(); }, ""), "");
  std::string large(3 << 20, 'x');
  large[1] = '\0';
  EXPECT_EQ(in_a_child([&] { return large; }, ""), large);
}

TEST(ChildProcess, WhatWorkThrowsIsThrown) {
  EXPECT_EQ(problem_of([]() -> std::string { throw std::runtime_error("no such font"); }),
            "no such font");
  EXPECT_EQ(problem_of([]() -> std::string { throw std::bad_alloc(); }), "Cannot allocate memory");
}

TEST(ChildProcess, ALibraryThatEndsTheProgramEndsTheChildAlone) {
  EXPECT_EQ(problem_of([]() -> std::string {
              std::signal(SIGABRT, SIG_DFL);
              std::abort();
            }),
            "given up");
  EXPECT_EQ(problem_of([]() -> std::string { std::_Exit(1); }), "given up");
}

// Fontconfig takes another font without a word.
TEST(ChildProcess, AFigureIsNotDrawnWithoutTheFilesOfItsFonts) {
  const std::string svg =
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10"><text x="1" y="9">a</text></svg>)";
  EXPECT_FALSE(to_png(svg, 72).empty());
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const rlimit few{12, before.rlim_max};
  setrlimit(RLIMIT_NOFILE, &few);
  std::string problem;
  try {
    to_png(svg, 72);
  } catch (const std::runtime_error& what) {
    problem = what.what();
  }
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(problem, "the figure cannot be drawn: Too many open files");
}

}  // namespace
}  // namespace wander::figure
