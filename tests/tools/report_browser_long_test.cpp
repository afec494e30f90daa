// The report in a browser, where there is one: the console stays silent, with and without the
// light on, and the page can be printed.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include "tests/tools/comparison_maker.h"
#include "tools/report/report.h"

namespace wander {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int status = -1;
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome outcome;
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
    outcome.output += buffer.data();
  outcome.status = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

std::string browser() {
  for (const std::string name : {"chromium", "chromium-browser", "google-chrome"})
    if (run("command -v " + name).status == 0) return name;
  return "";
}

class ReportInABrowser : public testing::Test {
 protected:
  void SetUp() override {
    browser_ = browser();
    if (browser_.empty()) GTEST_SKIP() << "no chromium here: the report is not opened";
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& html) const {
    std::ofstream(folder_ / "report.html") << html;
    return (folder_ / "report.html").string();
  }
  Outcome open(const std::string& page, const std::string& options) const {
    return run(browser_ +
               " --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir=" +
               (folder_ / "profile").string() + ' ' + options + " 'file://" + page + '\'');
  }

  std::string browser_;
  fs::path folder_ = fs::temp_directory_path() / ("wander-report-" + std::to_string(::getpid()));
};

// What the page itself has to say; the browser's own troubles with its machine are not meant.
bool complains(const std::string& output) { return output.find("CONSOLE") != std::string::npos; }

TEST_F(ReportInABrowser, OpensInLightAndDarkAndPrintsWithoutAComplaint) {
  const std::string page = write(report_html(test::make_comparison({})));
  for (const char* scheme : {"0", "1"}) {
    const Outcome opened =
        open(page, fmt::format("--blink-settings=preferredColorScheme={} --dump-dom", scheme));
    EXPECT_EQ(opened.status, 0) << opened.output;
    EXPECT_FALSE(complains(opened.output)) << opened.output;
    EXPECT_NE(opened.output.find("id=\"provenance\""), std::string::npos);
  }
  const fs::path printed = folder_ / "report.pdf";
  open(page, "--print-to-pdf=" + printed.string());
  EXPECT_TRUE(fs::exists(printed));
}

TEST_F(ReportInABrowser, ItsComplaintsAreHeard) {
  const std::string page = write("<!DOCTYPE html><html><script>no_such_thing();</script></html>");
  EXPECT_TRUE(complains(open(page, "--dump-dom").output));
}

}  // namespace
}  // namespace wander
