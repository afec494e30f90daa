// Progress where no terminal is: lines, at times that the reports themselves tell.
#include "tools/progress.h"

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

std::string said(const Global& global, Lines lines, const std::vector<ProgressReport>& reports) {
  ::testing::internal::CaptureStderr();
  {
    Progress progress(global);
    if (const auto report = progress.reporter(lines))
      for (const ProgressReport& each : reports) report(each);
  }
  return ::testing::internal::GetCapturedStderr();
}

const std::vector<ProgressReport> seven_seconds{{0, 0, 0, "seed pass"},
                                                {0.25, 1000, 2, "sampling"},
                                                {0.5, 10'000, 5, "sampling"},
                                                {0.7, 14'000, 7, "sampling"}};

TEST(Progress, PrintsALineNowAndThenInLongRuns) {
  EXPECT_EQ(said({}, Lines::of_long_runs, seven_seconds), " 50 %  sampling  2000/s  5 s left\n");
}

TEST(Progress, PrintsALineAtEachPart) {
  EXPECT_EQ(
      said({}, Lines::of_each_phase, seven_seconds),
      "  0 %  seed pass\n 25 %  sampling  500/s  6 s left\n 70 %  sampling  2000/s  3 s left\n");
}

TEST(Progress, IsSilentWhenToldSo) {
  Global quiet, mute;
  quiet.quiet = true;
  mute.progress = ProgressMode::none;
  EXPECT_EQ(said(quiet, Lines::of_each_phase, seven_seconds), "");
  EXPECT_EQ(said(mute, Lines::of_each_phase, seven_seconds), "");
}

}  // namespace
}  // namespace wander::test
