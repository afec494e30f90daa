// The report of a comparison: one page that any parser reads, whatever was measured.
#include "draw/report/report.h"

#include <gtest/gtest.h>

#include "tests/draw/report/comparison_maker.h"
#include "tests/draw/report/report_checks.h"

namespace wander::report_test {
namespace {

using compare::Comparison;
using test::Element;
using test::Page;

const std::string& usual_report() {
  static const std::string html = report_html(test::usual());
  return html;
}

std::string report_of(const compare::Runs& runs) { return report_html(compare::summarize(runs)); }

bool says(const std::string& html, const std::string& words) {
  return html.find(words) != std::string::npos;
}

TEST(Report, IsSoundAndTheSameEveryTime) {
  test::expect_sound(usual_report());
  EXPECT_EQ(usual_report(), report_html(test::usual()));
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
  for (const std::string allowed : {"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink",
                                    "\"data:image/png;base64,", "img-src data:"})
    for (auto at = html.find(allowed); at != std::string::npos; at = html.find(allowed))
      html.erase(at, allowed.size());
  for (const char* word : {"http:", "https:", "<script", "<link", "<img", "<iframe", "@import",
                           " src=", "url(h", "url(/", "data:", " onclick"})
    EXPECT_FALSE(says(html, word)) << word;
}

// The light between the surfaces is a picture within the page, which the page itself has to allow.
TEST(Report, ItsPolicyLetsItsPicturesBeSeen) {
  const Page page = test::read_page(usual_report());
  const auto is = [](const char* name, const char* attribute) {
    return [=](const Element& element) {
      return element.name == name && element.attributes.contains(attribute);
    };
  };
  EXPECT_TRUE(std::ranges::any_of(page.elements, is("image", "xlink:href")));
  const auto policy = std::ranges::find_if(page.elements, is("meta", "http-equiv"));
  ASSERT_NE(policy, page.elements.end());
  EXPECT_EQ(policy->attributes.at("content"),
            "default-src 'none'; style-src 'unsafe-inline'; img-src data:");
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
  const Comparison many = test::repeated(test::with_bins(test::usual(), 100), 8, 6, 16);
  ASSERT_EQ(many.runs.runs.size(), 8u * 6 * 16);
  test::expect_sound(report_html(many));
}

// A bin somewhat above all others is drawn; one far above would press the rest to the ground, and is told of.
TEST(Report, TellsOfValuesBeyondTheAxis) {
  constexpr const char* beyond = " Beyond the axis ";
  compare::Runs runs = test::usual().runs;
  double& bin = runs.runs.back().film.value.at(7);
  bin *= 1.4;
  EXPECT_FALSE(says(report_of(runs), beyond));
  bin *= 1e3;
  EXPECT_TRUE(says(report_of(runs), std::string(beyond) + "is 1 value."));
}

// The axis of an even film begins far above zero, and is linear: a dark bin lies beyond it.
TEST(Report, TellsOfDarkValuesBelowALinearAxis) {
  compare::Runs runs = test::usual().runs;
  const auto even = [](std::vector<double>& film) {
    for (std::size_t i = 0; i < film.size(); ++i) film[i] = i % 2 == 0 ? 0.9 : 1.1;
  };
  even(runs.reference.film.value);
  for (compare::Run& run : runs.runs) even(run.film.value);
  EXPECT_FALSE(says(report_of(runs), " Beyond the axis "));
  runs.runs.back().film.value.at(7) = 0;
  EXPECT_TRUE(says(report_of(runs), " Beyond the axis is 1 value."));
}

TEST(Report, SaysWhyThereAreNoChains) {
  const std::string html =
      report_html(test::make_comparison({"gallery:article-1", {"bdpt", "pt"}, {10'000}, 2}));
  test::expect_sound(html);
  EXPECT_TRUE(says(html, "nothing is proposed, accepted or rejected"));
  EXPECT_TRUE(says(html, "samples are independent"));
  EXPECT_TRUE(says(html, "independent samples need no normalization"));
}

TEST(Report, TextsOfOthersAreTexts) {
  compare::Runs runs = test::usual().runs;
  runs.contenders[0].label = "mlt <b>&\"'</b> " + std::string(300, 'x');
  runs.provenance.command_line = "wander compare '</pre><script>'";
  runs.warnings.push_back("<script>alert(1)</script>");
  const std::string html = report_of(runs);
  test::expect_sound(html);
  EXPECT_FALSE(says(html, "<script"));
}

TEST(Report, GivesTheCommandOfEveryRun) {
  compare::Runs runs = test::usual().runs;
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
}  // namespace wander::report_test
