// Warnings about geometry: they come for what is rarely meant, and only for that.
#include "scenes/format/lint.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

namespace wander::description::lint_test {
namespace {

Shape shape(ShapeKind kind) {
  Shape result;
  result.kind = std::move(kind);
  return result;
}
Shape segment(double x0, double y0, double x1, double y1) {
  return shape(Segment{{x0, y0, 0}, {x1, y1, 0}});
}
Shape lit(Shape shape) {
  shape.light = Light{};
  return shape;
}
Shape sensing(Shape shape) {
  shape.sensor = Sensor{{10}};
  return shape;
}
Shape room(double scale = 1) {
  return shape(
      Polyline{{{0, 0, 0}, {2 * scale, 0, 0}, {2 * scale, scale, 0}, {0, scale, 0}}, true});
}

Lint lint_of(std::vector<Shape> shapes) {
  Scene scene;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    shapes[i].line = static_cast<int>(i) + 1;
    shapes[i].column = 5;
  }
  scene.shapes = std::move(shapes);
  return lint(scene);
}

// The single one, "/pointer: what"; all of them if there are more.
std::string lines_of(const std::vector<Fault>& faults) {
  std::string lines;
  for (const Fault& fault : faults)
    lines += fmt::format("{}{}: {}", lines.empty() ? "" : "\n", fault.pointer, fault.what);
  return lines;
}
// Of a scene without faults.
std::string warning_of(std::vector<Shape> shapes) {
  const Lint found = lint_of(std::move(shapes));
  EXPECT_EQ(lines_of(found.faults), "");
  return lines_of(found.warnings);
}
std::string fault_of(std::vector<Shape> shapes) {
  return lines_of(lint_of(std::move(shapes)).faults);
}

testing::AssertionResult holds(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos && text.find('\n') == std::string::npos)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "got \"" << text << "\" instead of \"" << part << "\"";
}

TEST(Lint, IsSilentAboutAnOrdinaryRoom) {
  EXPECT_EQ(
      warning_of({room(), lit(segment(0.5, 0.98, 0.3, 0.98)),
                  sensing(segment(1.2, 0.01, 1.9, 0.01)), shape(Circle{{1, 0.5, 0}, 0.1, false}),
                  segment(1.5, 0, 1.5, 0.4), shape(Arc{{1, 1.5, 0}, 0.3, 0, 180, false})}),
      "");
}

TEST(Lint, TellsTheLineAndColumnOfTheShape) {
  const auto faults = lint_of({room(), segment(0, 0, 1, 0)}).faults;
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].line, 2);
  EXPECT_EQ(faults[0].column, 5);
  EXPECT_EQ(faults[0].pointer, "/shapes/1");
}

TEST(Lint, RefusesDuplicateAndOverlappingSegments) {
  EXPECT_TRUE(holds(fault_of({segment(0, 0, 1, 2), segment(0, 0, 1, 2)}),
                    "/shapes/1: this shape lies on /shapes/0"));
  EXPECT_TRUE(holds(fault_of({segment(0, 0, 1, 2), segment(1, 2, 0, 0)}), "lies on /shapes/0"));
  EXPECT_TRUE(holds(fault_of({segment(0, 0, 3, 1), segment(1.5, 0.5, 6, 2)}), "lies on /shapes/0"));
  EXPECT_TRUE(
      holds(fault_of({segment(0.1, 0.1, 0.7, 0.7), segment(0.3, 0.3, 0.4, 0.4)}), "lies on"));
  EXPECT_TRUE(holds(fault_of({shape(Polyline{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, false})}),
                    "/shapes/0: parts of this shape lie on each other"));
}

TEST(Lint, AcceptsSegmentsThatCrossOrContinueOrShareACorner) {
  EXPECT_EQ(warning_of({segment(-1, 0, 1, 0), segment(0, -1, 0, 1)}), "");
  EXPECT_EQ(warning_of({segment(0, 0, 0.1, 0.3), segment(0.1, 0.3, 0.2, 0.6)}), "");
  EXPECT_EQ(warning_of({segment(0, 0, 1, 0), segment(0, 0, 1, 0.1)}), "");
  EXPECT_EQ(warning_of({segment(0, 0, 1, 0), segment(0, 0.001, 1, 0.001)}), "");
}

TEST(Lint, RefusesArcsThatLieOnEachOther) {
  const Shape circle = shape(Circle{{1, 1, 0}, 0.5, false});
  EXPECT_TRUE(holds(fault_of({circle, circle}), "lies on /shapes/0"));
  EXPECT_TRUE(holds(fault_of({circle, shape(Arc{{1, 1, 0}, 0.5, 350, 20, true})}), "lies on"));
  const auto arc = [](double from, double to) {
    return shape(Arc{{1, 1, 0}, 0.5, from, to, false});
  };
  EXPECT_TRUE(holds(fault_of({arc(0, 90), arc(80, 170)}), "lies on /shapes/0"));
  EXPECT_EQ(warning_of({arc(0, 180), arc(180, 360)}), "");
}

TEST(Lint, RefusesALightOrSensorOnAWall) {
  EXPECT_TRUE(holds(fault_of({room(), lit(segment(0.5, 1, 0.3, 1))}),
                    "/shapes/1: the light lies on /shapes/0 at no distance"));
  EXPECT_TRUE(holds(fault_of({lit(segment(0.5, 1, 0.3, 1)), room()}), "/shapes/0: the light"));
  EXPECT_TRUE(holds(fault_of({room(), sensing(segment(0.5, 0, 0.7, 0))}), "the sensor lies on"));
  EXPECT_EQ(warning_of({room(), lit(segment(0.5, 1 - 1e-9, 0.3, 1 - 1e-9))}), "");
}

TEST(Lint, WarnsOfALightThatFacesAWallAtAlmostNoDistance) {
  EXPECT_TRUE(holds(warning_of({room(), lit(segment(0.3, 1 - 1e-8, 0.5, 1 - 1e-8))}),
                    "/shapes/1: the light faces /shapes/0 at a distance of 1.0e-08 m"));
  EXPECT_EQ(warning_of({room(), lit(segment(0.3, 0.99, 0.5, 0.99))}), "");
}

TEST(Lint, WarnsOfEndsThatNearlyMeet) {
  EXPECT_TRUE(holds(warning_of({segment(0, 0, 1, 0), segment(1, 1e-9, 1, 1)}),
                    "an end of this shape and /shapes/1 are 1.0e-09 m apart"));
  EXPECT_TRUE(holds(warning_of({segment(0, 0, 1, 0), segment(0.5, 1e-9, 0.5, 1)}), "apart"));
  EXPECT_TRUE(
      holds(warning_of({shape(Polyline{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1e-8, 0}}, false})}),
            "an end of this shape and /shapes/0"));
  EXPECT_TRUE(holds(
      warning_of({shape(Arc{{0, 0, 0}, 1, 0, 90, false}), segment(0, 1.0000001, -1, 1)}), "apart"));
}

TEST(Lint, AcceptsEndsThatMeetCrossOrStayApart) {
  EXPECT_EQ(warning_of({segment(0, 0, 1, 0), segment(1, 0, 1, 1)}), "");
  EXPECT_EQ(warning_of({segment(0, 0, 1, 0), segment(0.5, -1e-9, 0.5, 1)}), "");
  EXPECT_EQ(warning_of({segment(0, 0, 1, 0), segment(1, 1e-4, 1, 1)}), "");
  const double x = std::cos(std::numbers::pi / 5), y = std::sin(std::numbers::pi / 5);
  EXPECT_EQ(warning_of({shape(Arc{{0, 0, 0}, 1, 0, 36, false}), segment(x, y, 2, 2)}), "");
  EXPECT_EQ(warning_of({segment(0, 0, 1, 0), lit(segment(0.5, 0.1, 0.5 - 1e-9, 0.1))}), "");
}

TEST(Lint, SaysTheSameOfASceneOfAnySize) {
  for (const double scale : {1e-59, 1e-9, 1.0, 1e9, 1e59})
    EXPECT_TRUE(holds(fault_of({room(scale), segment(0, 0, scale, 0)}), "lies on")) << scale;
}

TEST(Lint, WarnsOfFeaturesFarSmallerThanTheScene) {
  EXPECT_TRUE(holds(warning_of({room(), segment(0.5, 0.5, 0.5 + 1e-13, 0.5)}), "too small"));
  EXPECT_TRUE(holds(warning_of({room(), shape(Circle{{1, 0.5, 0}, 1e-13, false})}), "too small"));
  EXPECT_EQ(warning_of({room(), lit(segment(0.5, 0.5, 0.5 + 1e-9, 0.5))}), "");
}

TEST(Lint, WarnsOfASceneFarFromTheOrigin) {
  const double far = 1e7;
  EXPECT_TRUE(holds(warning_of({segment(far, 0, far + 1, 0), segment(far, 0, far, 1)}),
                    "/shapes/0: the scene lies 7.1e+06 of its diameters from the origin"));
  EXPECT_EQ(warning_of({segment(1e5, 0, 1e5 + 1, 0), segment(1e5, 0, 1e5, 1)}), "");
}

TEST(Lint, OfManyShapesTakesNoLongTime) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Shape> shapes;
  for (int i = 0; i < 20'000; ++i)
    shapes.push_back(
        segment(coordinate(random), coordinate(random), coordinate(random), coordinate(random)));
  const auto start = std::chrono::steady_clock::now();
  const auto warnings = lint_of(std::move(shapes)).warnings;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  EXPECT_LE(warnings.size(), 100u);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const Fault& warning) {
    return warning.what.find("too many shapes") != std::string::npos;
  }));
}

}  // namespace
}  // namespace wander::description::lint_test
