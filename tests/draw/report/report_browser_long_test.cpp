// The report in a browser, where there is one: the console stays silent, in light and in dark, the
// page can be printed, no word of a table is broken, and no text of a figure is too small.
#include <gtest/gtest.h>

#include "draw/report/report.h"
#include "tests/draw/report/comparison_maker.h"
#include "tests/tools/command_line.h"

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

// The page in a column of so many pixels, with a script that adds what it measures: words of table
// cells on more than one line, and texts of figures lower than 9 pixels of type.
std::string measured_page(std::string html, int width) {
  const auto policy = html.find("<meta http-equiv");
  html.erase(policy, html.find("/>", policy) + 2 - policy);
  constexpr std::string_view script = R"(<script>
let broken = [], small = [];
for (const cell of document.querySelectorAll('th, td')) {
  const text = cell.firstChild;
  for (const word of text ? text.data.matchAll(/[^\s-]+/g) : []) {
    const range = document.createRange();
    range.setStart(text, word.index);
    range.setEnd(text, word.index + word[0].length);
    const tops = new Set(Array.from(range.getClientRects(), (box) => Math.round(box.top)));
    if (tops.size > 1) broken.push(word[0]);
  }
}
for (const text of document.querySelectorAll('figure text')) {
  const size = parseFloat(text.getAttribute('font-size')) * text.getScreenCTM().a;
  if (Math.abs(text.getScreenCTM().b) < 1e-6 && size < 9) small.push(text.textContent);
}
document.title = `broken: ${broken.join(' ')}; small: ${small.join(' ')};`;
</script>)";
  html.insert(html.find("</body>"), script);
  const std::string column =
      fmt::format("<style>body {{ width: {}px; padding: 20px }}</style>", width);
  html.insert(html.find("</head>"), column);
  for (auto at = html.find("<details>"); at != html.npos; at = html.find("<details>", at))
    html.replace(at, 9, "<details open=\"\">");
  return html;
}

TEST_F(ReportInABrowser, NoWordIsBrokenAndNoTextTooSmall) {
  compare::Comparison many = test::repeated(test::usual(), 8, 3, 3);
  many.runs.contenders[0].label = "mlt large_step=0.05";
  for (const int width : {400, 700, 1000}) {
    write("report.html", measured_page(report_html(many), width));
    const std::string out = open("--window-size=1100,900 --dump-dom").out;
    const std::string found = out.substr(std::min(out.size(), out.find("<title>")), 400);
    EXPECT_TRUE(found.starts_with("<title>broken: ; small: ;</title>")) << width << ": " << found;
  }
}

TEST_F(ReportInABrowser, ItsComplaintsAreHeard) {
  write("report.html", "<!DOCTYPE html><html><script>no_such_thing();</script></html>");
  EXPECT_TRUE(complains(open("--dump-dom")));
}

}  // namespace
}  // namespace wander
