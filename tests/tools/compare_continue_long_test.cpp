// `compare --continue` where the reference is a mean of long runs, which is kept and not made again.
#include "tests/tools/continued_comparison.h"

namespace wander::test {
namespace {

class ContinuingLongReference : public ContinuingComparison {};

TEST_F(ContinuingLongReference, WhatWasInterruptedGoesOnToItsEndAndMakesNoRunTwice) {
  write("mirror.json", mirror_box());
  expect_to_go_on("mirror.json", "400k");
}

}  // namespace
}  // namespace wander::test
