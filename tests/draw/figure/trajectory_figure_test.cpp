// Figures of trajectories: what they say is right, and they are well-formed whatever was recorded.
#include "draw/figure/trajectory_figure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/rng.h"
#include "draw/figure/acceptance_chart.h"
#include "draw/figure/autocorrelation.h"
#include "draw/figure/path_density.h"
#include "draw/report/embedding.h"
#include "tests/draw/figure/figure_checks.h"
#include "tests/support/statistics.h"

namespace wander::figure {
namespace {

constexpr int failed = 2;  // index of a reason

// Every third step is accepted, every third refused, every third fails without a path.
Trajectory recorded(int chains, int draws) {
  Trajectory t;
  t.max_vertices = 4;
  t.chains = chains;
  t.draws = draws;
  t.mutations = {"bidirectional", "lens"};
  t.reasons = {"none", "metropolis", "occluded"};
  t.classes = {"LDE", "LDDE"};
  Rng rng(5, Purpose::test, 0);
  const auto add_path = [&](RecordedPaths& paths, int vertices) {
    for (int k = 0; k < t.max_vertices; ++k)
      for (const double size : {2., 1.})
        paths.position.push_back(k < vertices ? size * rng.uniform() : nan);
    paths.film.push_back(vertices > 0 ? rng.uniform() : nan);
    paths.vertices.push_back(vertices);
    paths.path_class.push_back(vertices - 3);
  };
  for (std::size_t i = 0; i < t.size(); ++i) {
    const int kind = static_cast<int>(i % 3);
    add_path(t.state, 3 + static_cast<int>(i / 3 % 2));
    if (kind == failed)
      add_path(t.proposed, 0);
    else
      add_path(t.proposed, 3);
    if (kind == failed) t.proposed.path_class.back() = -1;
    t.mutation.push_back(static_cast<int>(i / 3 % 2));
    t.reason.push_back(kind);
    t.accepted.push_back(kind == 0);
    t.acceptance.push_back(kind == failed ? 0 : 0.5);
    t.log_f.push_back(rng.uniform());
  }
  return t;
}

std::vector<std::string> pages(const Trajectory& t, const StepFilter& filter = {},
                               const std::string& title = "room") {
  const d::Scene scene = room();
  const TrajectoryPage page(t, scene, filter, title);
  return {page.paths(),           page.trace(),   page.acceptance(),
          page.autocorrelation(), page.density(), page.overview()};
}

// Inkscape 1.2 knows xlink:href alone, newer readers prefer href.
TEST(TrajectoryFigure, WhatIsUsedAgainIsReferredToInBothWays) {
  const std::string svg = pages(recorded(1, 3)).front();
  EXPECT_EQ(count(svg, "<use "), 3u);
  EXPECT_EQ(count(svg, "<use href=\"#sequence-scene\" xlink:href=\"#sequence-scene\"/>"), 3u);
  EXPECT_EQ(count(svg, "xmlns:xlink=\"http://www.w3.org/1999/xlink\""), 1u);
  const std::string in_page = report::embedded(svg, "figure-7");
  EXPECT_EQ(count(in_page, "href=\"#figure-7-sequence-scene\""), 6u);
  EXPECT_EQ(count(in_page, "href=\"#sequence-scene\""), 0u);
}

// The letters of an image may be any.
std::string without_images(std::string svg) {
  const std::string start = "base64,";
  for (auto at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1))
    svg.erase(at, svg.find('"', at) - at);
  return svg;
}

TEST(TrajectoryFigure, IsWellFormedAndTheSameEveryTime) {
  for (const auto& [chains, draws] : {std::pair{1, 1}, {1, 3}, {3, 40}, {30, 10}, {1, 3000}}) {
    const Trajectory t = recorded(chains, draws);
    const std::vector<std::string> first = pages(t, {}, "<&>"), again = pages(t, {}, "<&>");
    for (const std::string& svg : first) {
      EXPECT_TRUE(is_well_formed(svg)) << chains << " x " << draws;
      EXPECT_EQ(without_images(svg).find("nan"), std::string::npos);
      EXPECT_LT(svg.size(), 1000000u);
    }
    EXPECT_EQ(first, again);
  }
}

TEST(TrajectoryFigure, NamesNothingTwice) {
  for (const std::string& svg : pages(recorded(3, 40))) {
    const std::regex id(R"re( id="([^"]+)")re");
    for (std::sregex_iterator it(svg.begin(), svg.end(), id), end; it != end; ++it)
      EXPECT_EQ(count(svg, it->str()), 1u) << it->str();
  }
}

TEST(TrajectoryFigure, ShowsNothingWhereNothingWasChosen) {
  StepFilter filter;
  filter.first = filter.end = 5;
  for (const std::string& svg : pages(recorded(2, 20), filter)) EXPECT_TRUE(is_well_formed(svg));
}

TEST(PathSequence, DashesRejectedProposalsAndNoOthers) {
  const std::string svg = pages(recorded(2, 12)).at(0);
  EXPECT_EQ(count(svg, "class=\"step\""), 12u);
  EXPECT_EQ(count(svg, "class=\"accepted\""), 4u);
  EXPECT_EQ(count(svg, "class=\"rejected\""), 4u);
  // Of an accepted first step the path before it is not recorded.
  EXPECT_EQ(count(svg, "class=\"current\""), 11u);
  const std::regex path(
      R"re(class="(accepted|rejected|current)"[^>]*stroke-dasharray="([^"]*)")re");
  for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it)
    EXPECT_EQ((*it)[2] == "none", (*it)[1] != "rejected") << it->str();
}

TEST(PathSequence, SaysInWordsWhatBecameOfEachStep) {
  const std::string svg = pages(recorded(1, 6)).at(0);
  EXPECT_EQ(count(svg, ">accepted, a = 0.5<"), 2u);
  EXPECT_EQ(count(svg, ">rejected, a = 0.5<"), 2u);
  EXPECT_EQ(count(svg, ">failed: occluded<"), 2u);
  EXPECT_EQ(count(svg, ">step 4: lens<"), 1u);
  EXPECT_NE(pages(recorded(1, 100)).at(0).find("the first 24 of 100 steps"), std::string::npos);
}

// Two walks of every failed step, and where it failed.
Trajectory with_attempts(Trajectory t) {
  t.attempts.max_points = 5;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool has = i % 3 == failed;
    for (const double x : {0.5, 0.6, nan, 1.5, 1.2})
      for (const double y : {x, 0.5}) t.attempts.position.push_back(has ? y : nan);
    for (int k = 0; k < 2; ++k) t.attempts.failure.push_back(has ? 0.4 : nan);
  }
  for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(t.max_vertices); ++k)
    t.start.position.push_back(k < 6 ? 0.1 * static_cast<double>(k) : nan);
  t.start.film = {0.5};
  t.start.vertices = {3};
  t.start.path_class = {0};
  return t;
}

TEST(PathSequence, DrawsWhatFailedAsFarAsItCameAndSaysWhyThere) {
  const std::string svg = pages(with_attempts(recorded(1, 12))).at(0);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "class=\"failed\""), 4u);
  EXPECT_EQ(count(svg, "class=\"failure\""), 4u);
  EXPECT_EQ(count(svg, ">occluded<"), 4u);
  const std::regex walks(R"re(class="failed"[^>]* d="M[^M"]*M[^M"]*")re");
  EXPECT_TRUE(std::regex_search(svg, walks));
}

TEST(PathSequence, KnowsThePathBeforeTheFirstStepFromTheStartOfTheChain) {
  const std::string svg = pages(with_attempts(recorded(1, 12))).at(0);
  EXPECT_EQ(count(svg, "class=\"current\""), 12u);
  EXPECT_EQ(count(svg, "not recorded"), 0u);
}

// A move that the whole scene does not show is enlarged, and what was enlarged is framed.
TEST(PathSequence, EnlargesSmallMovesAndNoOthers) {
  Trajectory t = recorded(1, 2);
  const auto row = static_cast<std::size_t>(t.max_vertices) * 2;
  t.reason[1] = 1;  // the second step is refused
  t.accepted[1] = 0;
  for (const double move : {1e-7, 1e-4, 0.3}) {
    for (std::size_t k = 0; k < row; ++k)
      t.proposed.position[row + k] = t.state.position[row + k] + (k == 2 ? move : 0);
    const std::string svg = pages(t).at(0);
    const std::size_t expected = move < 0.01 ? 1 : 0;
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(count(svg, "class=\"zoom\""), expected) << move;
    EXPECT_EQ(count(svg, "class=\"zoom-frame\""), expected) << move;
    EXPECT_EQ(count(svg, ">× "), expected) << move;
  }
}

double height_of(const std::string& svg) {
  std::smatch found;
  return std::regex_search(svg, found, std::regex(" height=\"([0-9.]+)pt\"")) ? std::stod(found[1])
                                                                              : nan;
}

// Without an enlarged part a row ends below its captions, and in a column no caption is cut.
TEST(PathSequence, ARowIsAsHighAsItsCaptions) {
  Trajectory t = recorded(1, 2);
  const auto row = static_cast<std::size_t>(t.max_vertices) * 2;
  t.reason[1] = 1;
  t.accepted[1] = 0;
  const auto drawn = [&](double move, double width) {
    for (std::size_t k = 0; k < row; ++k)
      t.proposed.position[row + k] = t.state.position[row + k] + (k == 2 ? move : 0);
    return TrajectoryPage(t, room(), {}, "room", width).paths();
  };
  EXPECT_LT(height_of(drawn(0.3, 516)), height_of(drawn(1e-4, 516)) - 20);
  const std::string column = drawn(1e-4, 238);
  EXPECT_EQ(count(column, "class=\"zoom\""), 1u);
  EXPECT_EQ(count(column, "…"), 0u);
  EXPECT_EQ(count(column, ">bidirectional<"), 1u);  // on a line of its own beside the enlarged part
  EXPECT_EQ(count(drawn(1e-4, 170), "…"), 0u) << "of the narrowest page";
}

TEST(PathSequence, ShowsTheChosenStepsAlone) {
  const Trajectory t = recorded(2, 12);
  StepFilter filter{.chains = {1}, .first = 3, .end = 9, .mutation = 1, .path_class = {}};
  const std::string svg = pages(t, filter).at(0);
  EXPECT_EQ(count(svg, "class=\"step\""), 3u);
  EXPECT_NE(svg.find("chain 1, draws 3 to 8, mutation lens"), std::string::npos);
  filter.mutation.reset();
  filter.path_class = 1;
  const Steps steps(t, filter);
  steps.each([&](const Step& step) {
    const auto before = steps.before(step);
    EXPECT_TRUE(t.state.path_class[step.index] == 1 || t.proposed.path_class[step.index] == 1 ||
                (before && before->path_class() == 1));
  });
}

TEST(PathSequence, KnowsNoPathBeforeAnAcceptedStepOfAThinnedTrajectory) {
  Trajectory t = recorded(1, 6);
  t.every = 10;
  const std::string svg = pages(t).at(0);
  EXPECT_EQ(count(svg, "class=\"current\""), 4u);
  EXPECT_EQ(count(svg, ">step 30: lens<"), 1u);
  EXPECT_EQ(count(svg, ">not recorded → LDE<"), 2u);
}

TEST(CoordinateTrace, MarksEveryRejection) {
  const std::string svg = pages(recorded(1, 30)).at(1);
  const std::size_t at = svg.find("class=\"rejections\"");
  const std::string marks = svg.substr(at, svg.find("/>", at) - at);
  EXPECT_EQ(count(marks, "M"), 20u);
}

TEST(CoordinateTrace, HasNoMarksWithoutRejections) {
  Trajectory t = recorded(1, 30);
  t.accepted.assign(t.size(), 1);
  EXPECT_NE(pages(t).at(1).find("d=\"\""), std::string::npos);
}

TEST(AcceptanceChart, SharesAddUp) {
  const std::string svg = pages(recorded(2, 60)).at(2);
  EXPECT_EQ(count(svg, "class=\"bar\""), 2u);
  EXPECT_EQ(count(svg, "class=\"share\""), 6u);
  EXPECT_EQ(count(svg, ">33.3 %<"), 6u);
  for (const char* text : {">accepted: 33.3 % of all<", ">occluded: 33.3 % of all<",
                           ">rejected by the acceptance test: 33.3 % of all<"})
    EXPECT_EQ(count(svg, text), 1u) << text;
}

// The first autoregressive process has ρ_k = φ^k.
TEST(Autocorrelation, IsThatOfAnAutoregressiveProcess) {
  constexpr double phi = 0.8;
  constexpr int length = 200000;
  Rng rng(9, Purpose::test, 0);
  std::vector<double> x{0};
  for (int i = 1; i < length; ++i) x.push_back(phi * x.back() + rng.uniform() - 0.5);
  const std::vector<double> rho = autocorrelation(x, 6);
  EXPECT_EQ(rho[0], 1);
  // Var ρ_1 = (1 - φ²) / n; that of no later one exceeds (1 + φ²) / (1 - φ²) / n [Bartlett 1946].
  const double error = std::sqrt((1 + phi * phi) / (1 - phi * phi) / length);
  const auto decide = [&](double base) {
    std::vector<double> z;
    for (std::size_t k = 1; k < rho.size(); ++k)
      z.push_back((rho[k] - std::pow(base, static_cast<double>(k))) / error);
    return largest_z_test(z, test::usual_false_alarm);
  };
  EXPECT_TRUE(decide(phi));
  EXPECT_FALSE(decide(0.95 * phi));
}

TEST(Autocorrelation, OfWhatDoesNotMoveIsEmpty) {
  EXPECT_TRUE(autocorrelation(std::vector<double>(50, 0.1), 5).empty());
  EXPECT_TRUE(autocorrelation(std::vector<double>{1, nan, 2}, 1).empty());
  EXPECT_TRUE(autocorrelation({}, 1).empty());
  EXPECT_EQ(autocorrelation(std::vector<double>{1, -1, 1, -1}, 1), (std::vector<double>{1, -0.75}));
}

// Chains that never move and lie apart have a ρ of 1 at all lags, and a τ that is but the length of their record.
TEST(Autocorrelation, OfChainsThatStayHasNoTime) {
  Trajectory t = recorded(2, 60);
  for (std::size_t i = 0; i < t.size(); ++i) {
    t.state.film[i] = t.log_f[i] = i < 60 ? 0.25 : 0.75;
    t.state.vertices[i] = i < 60 ? 3 : 4;
  }
  const std::string svg = TrajectoryPage(t, room(), {}, "room").autocorrelation();
  EXPECT_EQ(count(svg, "changes in no chain"), 3u);
  EXPECT_EQ(count(svg, ", τ "), 0u);
  EXPECT_GT(count(TrajectoryPage(recorded(2, 60), room(), {}, "room").autocorrelation(), ", τ "),
            0u);
}

TEST(CoordinateTrace, CountsWholeSteps) {
  for (const int draws : {1, 2, 3}) {
    const std::string svg = TrajectoryPage(recorded(1, draws), room(), {}, "room").trace();
    EXPECT_EQ(count(svg, ">0.5<"), 1u) << "of u alone";
    for (const char* part : {">0.2<", ">1.5<", ">2.5<"}) EXPECT_EQ(count(svg, part), 0u) << part;
  }
}

TEST(PathDensity, HoldsTheMeanLengthOfThePaths) {
  const Trajectory t = recorded(3, 50);
  const Steps steps(t, {});
  const PlaneGrid grid({0, 0}, {2, 1}, 17);
  double expected = 0, total = 0;
  steps.each([&](const Step& step) {
    const std::vector<Vector> path = steps.path(t.state, step.index);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      expected += glm::distance(path[i], path[i + 1]) / static_cast<double>(t.size());
  });
  for (const double density : path_density(steps, grid)) total += density * grid.cell_area();
  EXPECT_NEAR(total, expected, 1e-12 * expected);
}

}  // namespace
}  // namespace wander::figure
