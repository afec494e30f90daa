// The report in a browser, where there is one: the console stays silent, in light and in dark, and
// the page can be printed.
#include <gtest/gtest.h>

#include "tests/tools/command_line.h"
#include "tests/tools/comparison_maker.h"
#include "tools/report/report.h"

namespace wander {
namespace {

class ReportInABrowser : public test::CommandLine {
 protected:
  void SetUp() override {
    for (const std::string name : {"chromium", "chromium-browser", "google-chrome"})
      if (browser_.empty() && shell("command -v " + name).exit_code == 0) browser_ = name;
    if (browser_.empty()) GTEST_SKIP() << "no chromium here: the report is not opened";
  }

  test::Outcome open(const std::string& options) const {
    return shell(browser_ +
                 " --headless --no-sandbox --disable-gpu --enable-logging=stderr "
                 "--user-data-dir=profile " +
                 options + " \"file://$PWD/report.html\"");
  }

  std::string browser_;
};

// What the page itself has to say; the browser's own troubles with its machine are not meant.
bool complains(const test::Outcome& opened) {
  return opened.err.find("CONSOLE") != std::string::npos;
}

TEST_F(ReportInABrowser, OpensInLightAndDarkAndPrintsWithoutAComplaint) {
  write("report.html", report_html(test::make_comparison({})));
  for (const char* scheme : {"0", "1"}) {
    const test::Outcome opened =
        open(fmt::format("--blink-settings=preferredColorScheme={} --dump-dom", scheme));
    EXPECT_EQ(opened.exit_code, 0) << opened.err;
    EXPECT_FALSE(complains(opened)) << opened.err;
    EXPECT_HAS(opened.out, "id=\"provenance\"");
  }
  open("--print-to-pdf=report.pdf");
  EXPECT_TRUE(exists("report.pdf"));
}

TEST_F(ReportInABrowser, ItsComplaintsAreHeard) {
  write("report.html", "<!DOCTYPE html><html><script>no_such_thing();</script></html>");
  EXPECT_TRUE(complains(open("--dump-dom")));
}

}  // namespace
}  // namespace wander
