// How a report is laid out: text that can be read on a phone, in the dark and on paper, and numbers
// on the scale of the axis beside them.
#include <gtest/gtest.h>

#include <cmath>

#include "draw/report/report.h"
#include "draw/report/style_sheet.h"
#include "tests/draw/report/comparison_maker.h"
#include "tests/draw/report/report_checks.h"

namespace wander::report_layout_test {
namespace {

using test::Element;
using test::Page;

const std::string& usual_report() {
  static const std::string html = report_html(test::usual());
  return html;
}

// An <svg> of the page, and the texts in it, its title the first.
struct Figure {
  Element svg;
  std::vector<Element> texts;

  double points(const std::string& attribute) const {
    return std::stod(svg.attributes.at(attribute));
  }
  const std::string& title() const { return texts.front().text; }
};

std::vector<Figure> figures_of(const std::string& html) {
  std::vector<Figure> figures;
  for (const Element& element : test::read_page(html).elements) {
    if (element.name == "svg") figures.push_back({element, {}});
    if (element.name == "text") figures.back().texts.push_back(element);
  }
  return figures;
}

Figure figure_named(const std::string& html, const std::string& title) {
  for (const Figure& figure : figures_of(html))
    if (!figure.texts.empty() && figure.title() == title) return figure;
  ADD_FAILURE() << "no figure " << title;
  return {};
}

bool has_text(const Figure& figure, const std::string& text) {
  return std::ranges::find(figure.texts, text, &Element::text) != figure.texts.end();
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

// The rules between two marks of the style sheet.
std::string style_between(const std::string& from, const std::string& to) {
  const std::string style = report::style_sheet();
  const auto at = style.find(from);
  return style.substr(at, style.find(to, at) - at);
}

// In pixels, of which a point is 4/3, where a window leaves 360 of them to a figure.
double smallest_text_on_a_phone(const Figure& figure) {
  const double width = figure.points("width") * 4 / 3;
  const auto style = figure.svg.attributes.find("style");
  const bool keeps_width = style != figure.svg.attributes.end() &&
                           says(style->second, "--own-width: ") &&
                           says(style_between("figure svg {", "}"), "min-width: var(--own-width)");
  const double shown = keeps_width ? std::max(360.0, width) : 360;
  double smallest = INFINITY;
  for (const Element& text : figure.texts)
    smallest = std::min(smallest, std::stod(text.attributes.at("font-size")) * 4 / 3);
  return smallest * shown / width;
}

TEST(ReportLayout, NoTextOfAFigureIsTooSmallForAPhone) {
  for (const Figure& figure : figures_of(usual_report()))
    EXPECT_GE(smallest_text_on_a_phone(figure), 9) << figure.title();
  std::size_t views = 0;
  for (const Element& element : test::read_page(usual_report()).elements)
    if (element.name == "div" && element.attributes.at("class") == "view") {
      ++views;
      EXPECT_EQ(element.attributes.at("tabindex"), "0");
    }
  EXPECT_EQ(views, figures_of(usual_report()).size());
  EXPECT_TRUE(says(style_between(".view {", "}"), "overflow-x: auto"));
}

TEST(ReportLayout, NoFigureIsHigherThanHalfAPageOfPaper) {
  constexpr double text_height = (297 - 2 * 16) / 25.4 * 72;
  for (const Figure& figure : figures_of(report_html(test::repeated(test::usual(), 8, 3, 3))))
    EXPECT_LE(figure.points("height"), text_height / 2) << figure.title();
}

TEST(ReportLayout, PathLengthsHaveTicksWhereThereAreProposals) {
  compare::Runs runs = test::usual().runs;
  for (Rendering& details : runs.details)
    for (MutationRecord& mutation : details.mutations) {
      mutation.by_length.resize(2);
      for (std::size_t k = 0; k < 2; ++k) {
        mutation.by_length[k].vertices = 4 + static_cast<int>(k);
        mutation.by_length[k].proposed = 5000;
        mutation.by_length[k].mean_acceptance = 0.5;
      }
    }
  const Figure figure =
      figure_named(report_html(compare::summarize(runs)), "Mean acceptance by path length");
  EXPECT_TRUE(has_text(figure, "4"));
  EXPECT_TRUE(has_text(figure, "5"));
  EXPECT_FALSE(has_text(figure, "3"));
  EXPECT_FALSE(has_text(figure, "6"));
}

TEST(ReportLayout, EstimatesStandOnTheScaleOfTheirAxis) {
  constexpr double dark = 1e-5;
  compare::Runs runs = test::usual().runs;
  const auto darken = [](Estimate& b) { b = {dark * b.value, dark * b.standard_error}; };
  for (Rendering& details : runs.details)
    if (details.normalization)
      for (auto& [name, estimate] : details.normalization->estimates) darken(estimate);
  for (double& value : runs.reference.film.value) value *= dark;
  for (double& error : runs.reference.film.standard_error) error *= dark;
  const Figure figure =
      figure_named(report_html(compare::summarize(runs)), "Estimates of the normalization");
  EXPECT_TRUE(has_text(figure, "b, the mean of the film, 10⁻⁶ W/m"));
  for (const Element& text : figure.texts)
    EXPECT_FALSE(text.text.starts_with("0.00") || says(text.text, "·10")) << text.text;
}

TEST(ReportLayout, TwoCountsOfRefusalsHaveTwoNames) {
  EXPECT_FALSE(says(usual_report(), "longest run of rejections"));
  EXPECT_TRUE(says(usual_report(), ">most rejected in a row<"));
  EXPECT_TRUE(says(usual_report(), ">longest stay at one path,\u00A0mutations<"));
}

TEST(ReportLayout, CellsBreakBetweenWordsOnly) {
  // "anywhere" makes a column as narrow as a letter.
  EXPECT_FALSE(says(style_between("th[scope=\"row\"]", "}"), "anywhere"));
  for (const Element& element : test::read_page(usual_report()).elements) {
    const auto kind = element.attributes.find("class");
    if (element.name == "td" && kind != element.attributes.end() && kind->second != "words") {
      EXPECT_FALSE(says(element.text, ", ")) << element.text;
    }
    if (element.name == "th") {
      EXPECT_FALSE(element.text.ends_with(", %")) << element.text;
    }
  }
}

TEST(ReportLayout, EveryColourOfAFigureHasOneForTheNight) {
  const std::string night = style_between("prefers-color-scheme: dark", "@media print");
  EXPECT_FALSE(says(night, ": #ffffff")) << "a white box in the dark";
  EXPECT_TRUE(says(night, ".picture svg > :is(rect, text)[fill=\"#ffffff\"]"));
  bool picture = false;
  for (const Element& element : test::read_page(usual_report()).elements) {
    if (element.name == "figure") picture = element.attributes.at("class") == "picture";
    if (picture) continue;
    for (const std::string name : {"fill", "stroke"})
      if (const auto found = element.attributes.find(name);
          found != element.attributes.end() && found->second.starts_with('#')) {
        EXPECT_TRUE(says(night, fmt::format("[{}=\"{}\"]", name, found->second))) << found->second;
      }
  }
}

// Relative luminance and contrast of WCAG 2.2.
double luminance(const std::string& colour) {
  double sum = 0;
  for (const auto& [at, weight] : {std::pair{1, 0.2126}, {3, 0.7152}, {5, 0.0722}}) {
    const double c = std::stoi(colour.substr(static_cast<std::size_t>(at), 2), nullptr, 16) / 255.0;
    sum += weight * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}
double contrast(const std::string& a, const std::string& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

TEST(ReportLayout, TextStandsOutFromItsGround) {
  EXPECT_NEAR(contrast("#000000", "#ffffff"), 21, 1e-9);
  for (const std::string& scheme :
       {style_between(":root {", "}"), style_between("prefers-color-scheme: dark", "}"),
        style_between("@media print", "body {")}) {
    const auto colour = [&](const std::string& name) {
      return scheme.substr(scheme.find("--" + name + ": #") + name.size() + 4, 7);
    };
    for (const char* text : {"ink", "soft", "link", "warn"})
      EXPECT_GE(contrast(colour(text), colour("paper")), 4.5) << text << scheme;
    EXPECT_GE(contrast(colour("ink"), colour("warn-tint")), 4.5);
    EXPECT_GE(contrast(colour("warn"), colour("warn-tint")), 4.5);
  }
}

}  // namespace
}  // namespace wander::report_layout_test
