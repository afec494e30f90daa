// Transforms of Mitsuba, against points moved by hand.
#include "scenes/import/transform.h"

#include <cmath>

#include "tests/scenes/import/import_folder.h"

namespace wander::test {
namespace {

using Vector = glm::dvec3;

XmlElement element(const std::string& tag,
                   std::map<std::string, std::string, std::less<>> attributes) {
  XmlElement result;
  result.tag = tag;
  result.attributes = std::move(attributes);
  result.place.file = std::make_shared<std::string>("scene.xml");
  return result;
}

// Where the steps lead a point, done one after the other.
Vector moved(const std::vector<XmlElement>& steps, Vector p,
             RotationAxis axis = RotationAxis::normalized) {
  XmlElement transform = element("transform", {});
  transform.children = steps;
  Diagnosis diagnosis(Fidelity::exact);
  const glm::dmat4 matrix = transform_of(transform, axis, diagnosis);
  diagnosis.require_sound();
  return Vector(matrix * glm::dvec4(p, 1));
}

void expect_point(Vector p, Vector expected) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(p[axis], expected[axis], 1e-12) << axis;
}

std::string refusal(const XmlElement& step) {
  try {
    moved({step}, Vector(0));
  } catch (const ImportError& error) {
    return error.faults.front().what;
  }
  return "";
}

TEST(ImportedTransform, DoesItsFirstStepFirst) {
  const auto shift = element("translate", {{"x", "1"}});
  const auto turn = element("rotate", {{"z", "1"}, {"angle", "90"}});
  expect_point(moved({shift, turn}, {0, 0, 0}), {0, 1, 0});
  expect_point(moved({turn, shift}, {0, 0, 0}), {1, 0, 0});
  expect_point(moved({}, {1, 2, 3}), {1, 2, 3});
}

TEST(ImportedTransform, HasEveryStepOfMitsuba) {
  expect_point(moved({element("translate", {{"value", "1, 2, 3"}})}, {1, 1, 1}), {2, 3, 4});
  expect_point(moved({element("translate", {{"y", "2"}})}, {1, 1, 1}), {1, 3, 1});
  expect_point(moved({element("scale", {{"value", "2"}})}, {1, 2, 3}), {2, 4, 6});
  expect_point(moved({element("scale", {{"value", "2 3 4"}})}, {1, 1, 1}), {2, 3, 4});
  expect_point(moved({element("scale", {{"x", "-1"}})}, {1, 2, 3}), {-1, 2, 3});
  expect_point(
      moved({element("matrix", {{"value", "1 2 3 4 5 6 7 8 9 10 11 12 0 0 0 1"}})}, {1, 0, 2}),
      {11, 27, 43});
  expect_point(moved({element("matrix", {{"value", "1 2 3 5 6 7 9 10 11"}})}, {1, 0, 2}),
               {7, 19, 31});
}

// Counter-clockwise as seen against the axis.
TEST(ImportedTransform, TurnsRightHanded) {
  expect_point(moved({element("rotate", {{"y", "1"}, {"angle", "90"}})}, {1, 0, 0}), {0, 0, -1});
  expect_point(moved({element("rotate", {{"value", "0,2,0"}, {"angle", "-90"}})}, {1, 0, 0}),
               {0, 0, 1});
  const double s = std::sqrt(0.5);
  expect_point(moved({element("rotate", {{"x", "1"}, {"angle", "45"}})}, {0, 1, 0}), {0, s, s});
  // A third of a turn about the diagonal takes each axis to the next.
  expect_point(
      moved({element("rotate", {{"x", "1"}, {"y", "1"}, {"z", "1"}, {"angle", "120"}})}, {1, 0, 0}),
      {0, 1, 0});
}

// Its matrix for this axis has the rows (1, 1, 1), (1, 1, -1) and (-1, 1, 0).
TEST(ImportedTransform, DistortsAsMitsuba3Does) {
  const auto turn = element("rotate", {{"x", "1"}, {"y", "1"}, {"angle", "90"}});
  expect_point(moved({turn}, {1, 2, 4}, RotationAxis::as_given), {7, -1, 1});
  const double s = std::sqrt(0.5);
  expect_point(moved({turn}, {0, 0, 1}), {s, -s, 0});
}

TEST(ImportedTransform, TurnsQuartersToTheLastBit) {
  for (const char* angle : {"90", "-270", "450"})
    EXPECT_EQ(moved({element("rotate", {{"x", "1"}, {"angle", angle}})}, {0, 1, 0}),
              Vector(0, 0, 1));
  EXPECT_EQ(moved({element("rotate", {{"x", "1"}, {"angle", "180"}})}, {0, 1, 0}),
            Vector(0, -1, 0));
}

// x to the left of the picture, y up, z ahead.
TEST(ImportedTransform, LooksAlongZ) {
  const auto look = element("lookat", {{"origin", "1,2,3"}, {"target", "1,2,0"}, {"up", "0,1,0"}});
  expect_point(moved({look}, {0, 0, 0}), {1, 2, 3});
  expect_point(moved({look}, {0, 0, 1}), {1, 2, 2});
  expect_point(moved({look}, {0, 1, 0}), {1, 3, 3});
  expect_point(moved({look}, {1, 0, 0}), {0, 2, 3});
  // Without an up, as Mitsuba 3.9 chooses it: its matrix has the columns (0,1,0), (1,0,0), (0,0,-1).
  const auto free = element("lookAt", {{"origin", "1,2,3"}, {"target", "1,2,0"}});
  expect_point(moved({free}, {1, 0, 0}), {1, 3, 3});
  expect_point(moved({free}, {0, 1, 0}), {2, 2, 3});
}

TEST(ImportedTransform, RefusesWhatIsNone) {
  EXPECT_SAYS(refusal(element("turn", {})), "a transform has no <turn>");
  EXPECT_SAYS(refusal(element("rotate", {{"y", "1"}})), "has an angle");
  EXPECT_SAYS(refusal(element("rotate", {{"angle", "1"}})), "has an axis");
  EXPECT_SAYS(refusal(element("scale", {{"value", "0"}})), "not 0");
  EXPECT_SAYS(refusal(element("scale", {{"value", "2"}, {"x", "3"}})), "no value of a <scale>");
  EXPECT_SAYS(refusal(element("translate", {{"x", "far"}})), "finite number");
  EXPECT_SAYS(refusal(element("translate", {{"value", "1"}})), "three numbers");
  EXPECT_SAYS(refusal(element("matrix", {{"value", "1 2 3"}})), "16 numbers");
  EXPECT_SAYS(refusal(element("matrix", {{"value", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1"}})),
              "last row");
  EXPECT_SAYS(refusal(element("lookat", {{"origin", "0,0,0"}, {"target", "0,0,0"}})), "same point");
  EXPECT_SAYS(
      refusal(element("lookat", {{"origin", "0,0,0"}, {"target", "0,1,0"}, {"up", "0,2,0"}})),
      "along the view");
  EXPECT_SAYS(refusal(element("lookat", {{"origin", "0,0"}, {"target", "0,1,0"}})),
              "three numbers");
}

TEST(ImportedTransform, ThatOverflowsIsRefused) {
  XmlElement transform = element("transform", {});
  const auto large = element("scale", {{"value", "1e200"}});
  transform.children = {large, large};
  Diagnosis diagnosis(Fidelity::exact);
  transform_of(transform, RotationAxis::normalized, diagnosis);
  EXPECT_TRUE(diagnosis.has_faults());
}

}  // namespace
}  // namespace wander::test
