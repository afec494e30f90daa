// The report of a comparison: one page that any parser reads, whatever was measured.
#include "tools/report/report.h"

#include <gtest/gtest.h>

#include <regex>

#include "tests/tools/comparison_maker.h"
#include "tests/tools/report_checks.h"

namespace wander {
namespace {

using compare::Comparison;
using test::Element;
using test::Page;

const Comparison& usual() {
  static const Comparison made = test::make_comparison({});
  return made;
}

const std::string& usual_report() {
  static const std::string html = report_html(usual());
  return html;
}

const Comparison& of_chains() {
  static const Comparison made = test::make_comparison(
      {"gallery:glass-caustic-camera", {"mlt", "pssmlt", "mmlt"}, {20'000}, 2});
  return made;
}

// What holds of every report.
void expect_sound(const std::string& html) {
  const Page page = test::read_page(html);
  EXPECT_EQ(page.fault, "");
  EXPECT_TRUE(has_whole_references(page));
  EXPECT_TRUE(has_headings_in_order(page));
  EXPECT_LT(html.size(), 2'000'000u);
  static const std::regex not_a_number(R"([^a-zA-Z](nan|NaN|-?inf)[^a-zA-Z])");
  std::smatch found;
  for (const Element& element : page.elements) {
    EXPECT_FALSE(std::regex_search(element.text, found, not_a_number) && element.name != "pre")
        << element.text;
    for (const auto& [name, value] : element.attributes)
      EXPECT_FALSE(value == "nan" || value == "inf") << element.name << ' ' << name;
  }
}

std::string report_of(const compare::Runs& runs) { return report_html(compare::summarize(runs)); }

bool says(const std::string& html, const std::string& words) {
  return html.find(words) != std::string::npos;
}

TEST(Report, IsSoundAndTheSameEveryTime) {
  expect_sound(usual_report());
  EXPECT_EQ(usual_report(), report_html(usual()));
}

TEST(Report, TheCheckOfPagesFindsFaults) {
  using test::read_page;
  EXPECT_EQ(read_page("<!DOCTYPE html>\n<p a=\"b\">x &amp; y<br/></p>\n").fault, "");
  for (const char* wrong : {"<p>", "<p></q>", "<p>a & b</p>", "<p>a > b</p>", "<p a=b></p>",
                            "<p a=\"1\" a=\"2\"></p>", "text", "<p a=\"<\"></p>"})
    EXPECT_NE(read_page(wrong).fault, "") << wrong;
  const auto references = [](const char* text) { return has_whole_references(read_page(text)); };
  EXPECT_FALSE(references("<p id=\"a\"><i id=\"a\"/></p>"));
  EXPECT_FALSE(references("<a href=\"#b\"/>"));
  EXPECT_FALSE(references("<p aria-labelledby=\"a b\" id=\"a\"/>"));
  EXPECT_FALSE(has_headings_in_order(read_page("<p><h1/><h3/></p>")));
  EXPECT_FALSE(has_headings_in_order(read_page("<p><h2/></p>")));
}

TEST(Report, HasEverySectionInItsOrder) {
  const Page page = test::read_page(usual_report());
  std::vector<std::string> sections;
  for (const Element& element : page.elements)
    if (element.name == "section") sections.push_back(element.attributes.at("id"));
  EXPECT_EQ(sections,
            (std::vector<std::string>{"verdict", "scene", "films", "spread", "errors", "acceptance",
                                      "mixing", "energy", "normalization", "provenance"}));
}

TEST(Report, NeedsNoOtherFileAndNoScript) {
  std::string html = usual_report();
  const std::string allowed = "http://www.w3.org/2000/svg";
  for (auto at = html.find(allowed); at != std::string::npos; at = html.find(allowed))
    html.erase(at, allowed.size());
  for (const char* word : {"http:", "https:", "<script", "<link", "<img", "<iframe", "@import",
                           " src=", "url(h", "url(/", "data:", " onclick"})
    EXPECT_FALSE(says(html, word)) << word;
}

TEST(Report, EveryFigureIsNamedDescribedAndExplained) {
  const Page page = test::read_page(usual_report());
  std::size_t figures = 0, captions = 0, titles = 0, descriptions = 0;
  for (const Element& element : page.elements) {
    figures += element.name == "svg" ? 1 : 0;
    captions += element.name == "figcaption" && !element.text.empty() ? 1 : 0;
    titles += element.name == "title" && element.attributes.contains("id") ? 1 : 0;
    descriptions += element.name == "desc" && !element.text.empty() ? 1 : 0;
  }
  EXPECT_GT(figures, 9u);
  EXPECT_EQ(captions, figures);
  EXPECT_EQ(titles, figures);
  EXPECT_EQ(descriptions, figures);
}

TEST(Report, IsSmallHoweverMuchWasMeasured) {
  const Comparison many = test::repeated(test::with_bins(usual(), 100), 8, 6, 16);
  ASSERT_EQ(many.runs.runs.size(), 8u * 6 * 16);
  expect_sound(report_html(many));
}

TEST(Report, IsSoundForOneOfEachAndForManyBins) {
  const std::string one =
      report_html(test::make_comparison({"gallery:article-1", {"mlt"}, {10'000}, 1}));
  expect_sound(one);
  EXPECT_TRUE(says(one, "it takes at least two replicates"));
  EXPECT_TRUE(says(one, "One budget has no slope"));
  expect_sound(report_html(test::with_bins(usual(), 1)));
  expect_sound(report_html(test::with_bins(usual(), 1000)));
}

TEST(Report, SaysWhyThereAreNoChains) {
  const std::string html =
      report_html(test::make_comparison({"gallery:article-1", {"bdpt", "pt"}, {10'000}, 2}));
  expect_sound(html);
  EXPECT_TRUE(says(html, "nothing is proposed, accepted or refused"));
  EXPECT_TRUE(says(html, "samples are independent"));
  EXPECT_TRUE(says(html, "independent samples need no normalization"));
}

TEST(Report, IsSoundWithoutReferenceOrDetailsOrRuns) {
  Comparison unmeasured = usual();
  unmeasured.runs.reference = {};
  expect_sound(report_html(unmeasured));
  compare::Runs runs = usual().runs;
  runs.details.clear();
  runs.complete = false;
  runs.runs.resize(3);
  const std::string html = report_of(runs);
  expect_sound(html);
  EXPECT_TRUE(says(html, "was interrupted"));
  EXPECT_TRUE(says(html, "there are no films to show"));
  runs.runs.clear();
  expect_sound(report_of(runs));
}

TEST(Report, IsSoundForFilmsWithoutLightOrNumbers) {
  compare::Runs runs = usual().runs;
  for (const double value : {0.0, not_known, 1e300, 1e-300}) {
    const auto fill = [&](FilmEstimate& film) {
      std::ranges::fill(film.value, value);
      std::ranges::fill(film.standard_error, value);
    };
    for (compare::Run& run : runs.runs) fill(run.film);
    for (Rendering& details : runs.details) fill(details.film);
    if (value == 0) expect_sound(report_of(runs));
    fill(runs.reference.film);
    expect_sound(report_of(runs));
  }
}

TEST(Report, SaysThatANormalizationHasFailedOrDisagrees) {
  compare::Runs runs = of_chains().runs;
  Normalization& b = *runs.details.front().normalization;
  b.estimates["bridge"] = {{not_known, not_known}, 0};
  b.estimates["least_squares"] = {{2 * b.value, 0.01 * b.value}, 1000};
  const std::string html = report_of(runs);
  expect_sound(html);
  EXPECT_TRUE(says(html, "Failed, and not used: bridge of mlt."));
  EXPECT_TRUE(says(html, "estimates disagree: least squares and seed pass of mlt"));
  EXPECT_FALSE(says(report_html(of_chains()), "estimates disagree"));
}

TEST(Report, TextsOfOthersAreTexts) {
  compare::Runs runs = usual().runs;
  runs.contenders[0].label = "mlt <b>&\"'</b> " + std::string(300, 'x');
  runs.provenance.command_line = "wander compare '</pre><script>'";
  runs.warnings.push_back("<script>alert(1)</script>");
  const std::string html = report_of(runs);
  expect_sound(html);
  EXPECT_FALSE(says(html, "<script"));
}

TEST(Report, GivesTheCommandOfEveryRun) {
  compare::Runs runs = usual().runs;
  runs.contenders[1].dial = "max_vertices";
  runs.contenders[1].setting = "5";
  const std::string html = report_of(runs);
  for (const compare::Run& run : runs.runs) {
    const compare::Contender& contender = runs.contenders[run.contender];
    std::string command = fmt::format("wander render gallery:article-1 -m {} -b {} -s {}",
                                      contender.method, runs.budgets[run.budget], run.seed);
    if (!contender.dial.empty()) command += " --max-vertices 5";
    EXPECT_TRUE(says(html, command)) << command;
  }
  runs.provenance.scene_text += "\n";
  EXPECT_TRUE(says(report_of(runs), "wander render scene.json -m mlt"));
}

}  // namespace
}  // namespace wander
