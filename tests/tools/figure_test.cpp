// Figures: what they say is in the right place, and they are well-formed whatever they are given.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <regex>

#include "tools/figure/axis.h"
#include "tools/figure/film_figure.h"
#include "tools/figure/region.h"
#include "tools/figure/scene_drawing.h"
#include "tools/figure/scene_figure.h"
#include "tools/figure/scene_inset.h"

namespace wander::figure {
namespace {

namespace d = description;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Every tag is closed by its own name, in order; no bare markup in texts and attributes; no number
// that is not finite.
testing::AssertionResult is_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  const std::regex tag(R"(<(/?)([A-Za-z]+)((?:\s+[A-Za-z:-]+="[^"<]*")*)\s*(/?)>)");
  std::size_t at = svg.find("?>") + 2;
  while (at < svg.size()) {
    const std::size_t next = std::min(svg.find('<', at), svg.size());
    const std::string text = svg.substr(at, next - at);
    if (text.find('>') != std::string::npos)
      return testing::AssertionFailure() << "bare > in " << text;
    at = next;
    if (at == svg.size()) break;
    std::smatch found;
    const std::string rest = svg.substr(at, svg.find('>', at) + 1 - at);
    if (!std::regex_match(rest, found, tag))
      return testing::AssertionFailure() << "no tag: " << rest;
    if (found[1].length() == 0 && found[4].length() == 0) open.push_back(found[2]);
    if (found[1].length() > 0) {
      if (open.empty() || open.back() != found[2]) return testing::AssertionFailure() << rest;
      open.pop_back();
    }
    at += rest.size();
  }
  if (!open.empty()) return testing::AssertionFailure() << open.back() << " is not closed";
  const std::regex entity(R"(&(?!(lt|gt|amp|quot);))"),
      not_finite(R"([ "](nan|inf|-nan|-inf)[ "])");
  if (std::regex_search(svg, entity)) return testing::AssertionFailure() << "a bare &";
  if (std::regex_search(svg, not_finite)) return testing::AssertionFailure() << "not finite";
  return testing::AssertionSuccess();
}

d::Quantity grey(double value) { return {{value, value, value}, false}; }

d::Shape segment(d::Coordinates from, d::Coordinates to) {
  d::Shape shape;
  shape.kind = d::Segment{from, to};
  return shape;
}

// A room with every material and kind of shape; the light on the ceiling shines down.
d::Scene room() {
  d::Scene scene;
  scene.name = "room";
  scene.materials = {
      {"plaster", d::Diffuse{grey(0.5)}},         {"silver", d::Mirror{grey(0.9)}},
      {"glass", d::Dielectric{1.5, 1}},           {"satin", d::RoughConductor{0.2, grey(0.9)}},
      {"frost", d::RoughDielectric{0.3, 1.4, 1}}, {"soot", d::Black{}}};
  const std::vector<d::ShapeKind> kinds{d::Polyline{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, true},
                                        d::Arc{{2.2, 0.5}, 0.5, 150, 210},
                                        d::Circle{{0.5, 0.5}, 0.1},
                                        d::Segment{{1, 0.2}, {1.2, 0.4}},
                                        d::Circle{{1.5, 0.5}, 0.1},
                                        d::Segment{{0.1, 0.3}, {0.2, 0.3}}};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    d::Shape shape;
    shape.kind = kinds[k];
    shape.material = k;
    scene.shapes.push_back(shape);
  }
  d::Shape light = segment({1.1, 0.9}, {0.9, 0.9});
  light.light = d::Light{grey(5)};
  d::Shape sensor = segment({0.5, 0.05}, {1.5, 0.05});
  sensor.sensor = d::Sensor{{20}};
  scene.shapes.push_back(light);
  scene.shapes.push_back(sensor);
  return scene;
}

LabelledFilm film(std::size_t bins, double value = 1) {
  LabelledFilm result{"bdpt", {}};
  Rendering& run = result.rendering;
  run.method = "bdpt";
  run.samples = 1000000;
  run.film.shape = {static_cast<int>(bins)};
  run.film.degrees_of_freedom = 31;
  for (std::size_t k = 0; k < bins; ++k) {
    run.film.value.push_back(value * (1 + 0.5 * std::sin(static_cast<double>(k))));
    run.film.standard_error.push_back(0.05 * value);
    run.film.reliable.push_back(true);
  }
  return result;
}

FilmFigureOptions options() {
  return {.title = "", .axes = film_axes(room()), .inset = {}, .reference = {}};
}

// The text between `<g class="KIND">` and the end of that group.
std::string group(const std::string& svg, const std::string& kind) {
  const auto begin = svg.find("class=\"" + kind + "\"");
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find("</g>", begin) - begin);
}

TEST(Ticks, AreMultiplesOfOneTwoOrFiveTimesAPowerOfTenInsideTheRange) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-12, 12), mantissa(-10, 10);
  for (int trial = 0; trial < 20000; ++trial) {
    const double scale = std::pow(10, exponent(random));
    const double low = scale * mantissa(random),
                 high = low + scale * (0.01 + std::abs(mantissa(random)));
    const int at_most = 2 + trial % 9;
    const Ticks ticks = nice_ticks({low, high}, at_most);

    const double power = std::pow(10, std::floor(std::log10(ticks.step) + 1e-9));
    const double leading = std::round(ticks.step / power);
    EXPECT_TRUE(leading == 1 || leading == 2 || leading == 5) << ticks.step;
    EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(at_most));
    for (const double value : ticks.values) {
      const double multiple = value / ticks.step, slack = 1e-5 * ticks.step;
      EXPECT_NEAR(multiple, std::round(multiple), 1e-6 * std::max(1., std::abs(multiple)));
      EXPECT_TRUE(value >= low - slack && value <= high + slack);
    }
  }
}

TEST(Ticks, AreAsManyAsAllowed) {
  EXPECT_EQ(nice_ticks({0, 1}, 6).values, (std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1}));
  EXPECT_EQ(nice_ticks({0, 1}, 11).values.size(), 11u);
}

TEST(Ticks, ExistForRangesThatAreEmptyReversedOrNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Range range : {Range{1, 1}, Range{0, 0}, Range{2, 1}, Range{0, inf}, Range{nan, 1},
                            Range{-1e308, 1e308}, Range{0, 5e-324}, Range{1e15, 1e15 + 1}}) {
    const Axis axis = make_axis({"x", "m"}, range, {0, 100}, 6);
    EXPECT_EQ(axis.labels.size(), axis.ticks.size());
    EXPECT_LE(axis.ticks.size(), 6u);
    for (const double tick : axis.ticks) EXPECT_TRUE(std::isfinite(axis.scale(tick)));
  }
}

TEST(Axis, TakesPowersOfTenAndOffsetsIntoItsTitle) {
  const Axis tiny = make_axis({"x", "m"}, {0, 4e-9}, {0, 100}, 5);
  EXPECT_EQ(tiny.title, "x, 10⁻⁹ m");
  EXPECT_EQ(tiny.labels, (std::vector<std::string>{"0", "1", "2", "3", "4"}));
  const Axis far = make_axis({"x", "m"}, {1e6, 1e6 + 1}, {0, 100}, 3);
  EXPECT_EQ(far.title, "x − 1000000, m");
  EXPECT_EQ(far.labels, (std::vector<std::string>{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(make_axis({"y", "m"}, {-1, 1}, {0, 100}, 3).labels.front(), "−1");
}

TEST(Svg, NumbersAreShortAndNeverNegativeZero) {
  EXPECT_EQ(number(1), "1");
  EXPECT_EQ(number(-0.001), "0");
  EXPECT_EQ(number(2.50), "2.5");
  EXPECT_EQ(number(-1.239), "-1.24");
  EXPECT_EQ(number(nan), "0");
}

TEST(Svg, EscapesMarkupAndReplacesWhatXmlForbids) {
  EXPECT_EQ(escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
  EXPECT_EQ(escaped("αβ → 光"), "αβ → 光");
  for (const std::string& bad : {std::string("\x01"), std::string("\xFF"), std::string("\xC0\x80"),
                                 std::string("\xED\xA0\x80"), std::string("\xEF\xBF\xBE")})
    EXPECT_NE(escaped(bad).find("\xEF\xBF\xBD"), std::string::npos);
  EXPECT_EQ(escaped("\xE2\x82"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // cut off
}

TEST(Svg, ShortenedTextFitsAndKeepsWholeCharacters) {
  const std::string text = "αβγδεζηθικλμνξοπ";
  for (double width = 20; width < 120; width += 3) {
    const std::string cut = shortened(text, 7, width);
    EXPECT_LE(text_width(cut, 7), width);
    EXPECT_EQ(escaped(cut), cut);
  }
  EXPECT_EQ(shortened("abc", 7, 100), "abc");
}

TEST(SceneFigure, IsWellFormedAndTheSameEveryTime) {
  d::Scene scene = room();
  scene.name = "a <b> & \"c\" \x01 <script>alert(1)</script>";
  const std::string svg = scene_figure(scene);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(svg, scene_figure(scene));
  EXPECT_NE(svg.find("a &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(SceneFigure, NamesInItsLegendWhatOccursAndNothingElse) {
  const std::string all = scene_figure(room());
  for (const char* entry :
       {">light, 5 W/(m rad)<", ">sensor, 20 bins from the dot<", ">diffuse, ρ 0.5<",
        ">mirror, ρ 0.9<", ">dielectric, n 1.5<", ">rough conductor, α 0.2, ρ 0.9<",
        ">rough dielectric, α 0.3, n 1.4<", ">black<"})
    EXPECT_EQ(count(all, entry), 1u) << entry;
  d::Scene bare = room();
  bare.shapes.erase(bare.shapes.begin() + 1, bare.shapes.begin() + 6);
  const std::string some = scene_figure(bare);
  for (const char* entry : {">mirror", ">dielectric", ">rough", ">black", ">camera"})
    EXPECT_EQ(count(some, entry), 0u) << entry;
}

// The marks of a light or sensor are lines "Mx yLx y" from the curve outwards.
std::vector<std::array<double, 4>> marks(const std::string& text) {
  const std::regex line(R"(stroke-width="0.7" d="M([-0-9.]+) ([-0-9.]+)L([-0-9.]+) ([-0-9.]+)\")");
  std::vector<std::array<double, 4>> result;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
    result.push_back(
        {std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4])});
  return result;
}

TEST(SceneFigure, LightsAndSensorsHaveTheirMarksOnTheSideOfTheNormal) {
  const std::string svg = scene_figure(room());
  const auto rays = marks(group(svg, "light")), pins = marks(group(svg, "sensor"));
  ASSERT_FALSE(rays.empty());
  ASSERT_FALSE(pins.empty());
  for (const auto& ray : rays) EXPECT_GT(ray[3], ray[1] + 3) << "the light shines down";
  for (const auto& pin : pins) EXPECT_LT(pin[3], pin[1] - 3) << "the sensor listens up";
}

TEST(SceneFigure, CurvedLightsShineAwayFromTheirCentreUnlessFlipped) {
  for (const bool flip : {false, true}) {
    const std::vector<Curve> parts = curves(d::Arc{{1, 2}, 0.5, 300, 390, flip});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_NEAR(length(parts[0]), 0.5 * std::numbers::pi / 2, 1e-12);
    for (const double u : {0., 0.3, 1.}) {
      const Spot s = spot(parts[0], u);
      EXPECT_NEAR(glm::distance(s.position, Vector(1, 2)), 0.5, 1e-12);
      EXPECT_NEAR(glm::dot(s.normal, s.position - Vector(1, 2)), flip ? -0.5 : 0.5, 1e-12);
    }
    EXPECT_NEAR(spot(parts[0], 0).position.y, 2 - 0.5 * std::sin(std::numbers::pi / 3), 1e-12);
  }
}

TEST(SceneFigure, CirclesStayExactCurves) {
  EXPECT_NE(group(scene_figure(room()), "scene").find('A'), std::string::npos);
  Extent extent;
  extent.include(curves(d::Arc{{0, 0}, 1, 45, 135})[0]);
  EXPECT_NEAR(extent.high.y, 1, 1e-12);
  EXPECT_NEAR(extent.low.y, std::sqrt(0.5), 1e-12);
}

TEST(SceneFigure, TwoArcsThatMeetAreARegionWhenTheirBacksAreWithin) {
  const d::Arc upper{{0, -std::sqrt(0.5)}, 1, 45, 135}, lower{{0, std::sqrt(0.5)}, 1, 225, 315};
  const PageMap map{{0, 0}, {0, 0}, 100};
  const Insides lens = find_insides({upper, lower}, map, 1);
  EXPECT_EQ(lens.regions.size(), 1u);
  EXPECT_TRUE(lens.open.empty());

  d::Arc flipped = upper;
  flipped.flip = true;
  EXPECT_EQ(find_insides({flipped, lower}, map, 1).open.size(), 2u);
  EXPECT_EQ(find_insides({upper}, map, 1).open.size(), 1u);

  // The left of a counter-clockwise polygon is its inside, so its back is the world around it.
  const d::Polyline outwards{{{0, 0}, {0, 1}, {1, 0}}, true},
      inwards{{{0, 0}, {1, 0}, {0, 1}}, true};
  EXPECT_EQ(find_insides({outwards}, map, 1).regions.size(), 1u);
  EXPECT_EQ(find_insides({inwards}, map, 1).regions.size(), 0u);
}

TEST(SceneFigure, SurvivesScenesOfAnySizeAndPlace) {
  for (const double scale : {1e-9, 1., 1e9, 1e150}) {
    for (const double offset : {0., 1e6}) {
      d::Scene scene;
      d::Shape light = segment({offset * scale, 0}, {(offset + 1) * scale, 0});
      light.light = d::Light{grey(1)};
      scene.shapes = {light};
      scene.camera = d::Camera{{offset * scale, scale}, {offset * scale, 0}, {}, 179, {10}, 0, {}};
      EXPECT_TRUE(is_well_formed(scene_figure(scene))) << scale << " " << offset;
    }
  }
}

TEST(SceneFigure, NamesTheFirstBinOfACameraAtItsLeft) {
  const d::Camera camera{{0, 0}, {1, 0}, {}, 90, {10}, 0, {}};
  const Wedge wedge = camera_wedge(camera, 1);
  EXPECT_GT(wedge.first.y, 0);
  EXPECT_LT(wedge.last.y, 0);
}

TEST(FilmFigure, IsWellFormedAndTheSameEveryTimeInEveryLayout) {
  FilmFigureOptions how = options();
  how.title = "<&>";
  how.inset = room();
  how.reference = film(20);
  for (const Layout layout : {Layout::automatic, Layout::overlay, Layout::panels}) {
    how.layout = layout;
    const std::string svg = film_figure({film(20), film(10), film(40)}, how);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(svg, film_figure({film(20), film(10), film(40)}, how));
  }
}

TEST(FilmFigure, AxesHaveUnits) {
  EXPECT_NE(film_figure({film(20)}, options()).find(">position on the sensor, m<"),
            std::string::npos);
  EXPECT_NE(film_figure({film(20)}, options()).find(">mean irradiance, W/m<"), std::string::npos);
  d::Scene scene = room();
  scene.shapes.pop_back();
  scene.camera = d::Camera{{0, 0}, {1, 0}, {}, 90, {10}, 0, {}};
  FilmFigureOptions how = options();
  how.axes = film_axes(scene);
  EXPECT_NE(film_figure({film(20)}, how).find(">mean radiance, W/(m rad)<"), std::string::npos);
}

TEST(FilmFigure, MarksUnreliableBinsAndSaysSo) {
  EXPECT_EQ(count(film_figure({film(20)}, options()), "unreliable"), 0u);
  LabelledFilm partly = film(20);
  partly.rendering.film.reliable[7] = false;
  const std::string svg = film_figure({partly}, options());
  EXPECT_EQ(count(svg, "class=\"band unreliable\""), 1u);
  EXPECT_EQ(count(svg, "class=\"band\""), 2u);        // to its left and to its right
  EXPECT_GE(count(svg, "class=\"unreliable\""), 2u);  // the bin and its sample in the legend
  EXPECT_EQ(count(svg, ">unreliable bin<"), 1u);
}

TEST(FilmFigure, ABinWithoutAStandardErrorIsUnreliable) {
  LabelledFilm partly = film(20);
  partly.rendering.film.standard_error[3] = nan;
  EXPECT_EQ(count(film_figure({partly}, options()), ">unreliable bin<"), 1u);
}

TEST(FilmFigure, OneFireflyDoesNotFlattenTheFilm) {
  LabelledFilm noisy = film(20);
  noisy.rendering.film.value[4] = 1e6;
  noisy.rendering.film.standard_error[4] = 1e6;
  noisy.rendering.film.reliable[4] = false;
  const std::vector<std::vector<Bar>> bars{bars_of(noisy.rendering.film, {0, 1})};
  EXPECT_LT(value_range(bars, {}).high, 3);
  const std::string svg = film_figure({noisy}, options());
  EXPECT_EQ(count(svg, "class=\"beyond\""), 2u);  // at the edge and in the legend
  EXPECT_EQ(count(svg, ">beyond the axis, up to 1e+06 W/m<"), 1u);
}

TEST(FilmFigure, BandsAre95PercentIntervals) {
  FilmEstimate estimate = film(1).rendering.film;
  estimate.degrees_of_freedom = 4;
  EXPECT_NEAR(*bars_of(estimate, {0, 1})[0].half_width, 2.776 * 0.05, 1e-4);
  estimate.degrees_of_freedom = 1e9;
  EXPECT_NEAR(*bars_of(estimate, {0, 1})[0].half_width, 1.960 * 0.05, 1e-4);
}

TEST(FilmFigure, MillionsOfBinsMakeASmallFigureThatSaysWhatAStepIs) {
  const LabelledFilm fine = film(1200000);
  const std::vector<Bar> bars = bars_of(fine.rendering.film, {0, 1});
  EXPECT_LE(bars.size(), most_bars);
  EXPECT_EQ(bars.front().position.low, 0);
  EXPECT_EQ(bars.back().position.high, 1);
  const std::string svg = film_figure({fine}, options());
  EXPECT_LT(svg.size(), 100000u);
  EXPECT_NE(svg.find("each step averages 2000 bins"), std::string::npos);
}

TEST(FilmFigure, SurvivesFilmsOfZerosOfNothingKnownAndOfAnySize) {
  for (const double value : {0., 1e-30, 1e30, 1e300}) {
    LabelledFilm unknown = film(20, value);
    unknown.rendering.film.standard_error.assign(20, nan);
    unknown.rendering.film.reliable.assign(20, false);
    unknown.rendering.film.degrees_of_freedom = 0;
    EXPECT_TRUE(is_well_formed(film_figure({film(20, value), unknown}, options()))) << value;
    EXPECT_TRUE(is_well_formed(film_figure({unknown}, options()))) << value;
  }
  LabelledFilm nothing = film(20);
  nothing.rendering.film.value.assign(20, nan);
  EXPECT_TRUE(is_well_formed(film_figure({nothing}, options())));
}

TEST(FilmFigure, AutomaticLayoutOverlaysTwoFilmsAndSeparatesMore) {
  const auto panels = [](const std::vector<LabelledFilm>& films) {
    return count(film_figure(films, options()), "<clipPath");
  };
  EXPECT_EQ(panels({film(20), film(20)}), 1u);
  EXPECT_EQ(panels({film(20), film(20), film(20)}), 3u);
}

TEST(FilmFigure, SaysWhenARunWasInterrupted) {
  LabelledFilm part = film(20);
  part.rendering.complete = false;
  EXPECT_NE(film_figure({part}, options()).find(", interrupted<"), std::string::npos);
}

TEST(Inset, NamesLengthsWithPrefixes) {
  EXPECT_EQ(length_in_words(0.5), "0.5 m");
  EXPECT_EQ(length_in_words(2e-9), "2 nm");
  EXPECT_EQ(length_in_words(5e8), "500 Mm");
  EXPECT_EQ(length_in_words(1000), "1 km");
}

}  // namespace
}  // namespace wander::figure
