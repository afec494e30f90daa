#include "scenes/import/transform.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "scenes/format/json_text.h"
#include "scenes/import/number_words.h"

namespace wander {

namespace {

using Matrix = glm::dmat4;
using Vector = glm::dvec3;

class TransformReader {
 public:
  TransformReader(RotationAxis axis, Diagnosis& diagnosis) : axis_(axis), diagnosis_(diagnosis) {}

  Matrix of(const XmlElement& transform) {
    Matrix result(1);
    for (const XmlElement& step : transform.children) result = step_of(step) * result;
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        if (!std::isfinite(result[column][row])) {
          diagnosis_.fault(transform, "the numbers of the transform are too large");
          return Matrix(1);
        }
    return result;
  }

 private:
  Matrix step_of(const XmlElement& step) {
    if (step.tag == "translate") return translation(vector_of(step, Vector(0), diagnosis_));
    if (step.tag == "scale") return scaling(step);
    if (step.tag == "rotate") return rotation(step);
    if (step.tag == "matrix") return matrix(step);
    if (is_look_at(step.tag)) return look_at(step);
    diagnosis_.fault(step, fmt::format("a transform has no <{}>; allowed are translate, scale, "
                                       "rotate, matrix and lookat",
                                       excerpt(step.tag)));
    return Matrix(1);
  }

  static bool is_look_at(std::string_view tag) {
    return tag == "lookat" || tag == "lookAt" || tag == "look_at";
  }

  static Matrix translation(Vector v) {
    Matrix result(1);
    result[3] = {v, 1};
    return result;
  }

  Matrix scaling(const XmlElement& step) {
    Matrix result(1);
    const Vector factors = vector_of(step, Vector(1), diagnosis_);
    if (factors.x == 0 || factors.y == 0 || factors.z == 0)
      diagnosis_.fault(step, "a scale by 0 leaves nothing; factors are not 0");
    for (int axis = 0; axis < 3; ++axis)
      if (factors[axis] != 0) result[axis][axis] = factors[axis];
    return result;
  }

  Matrix rotation(const XmlElement& step) {
    const Vector axis = vector_of(step, Vector(0), diagnosis_);
    const auto degrees = number_in(step.attribute("angle"));
    const double length = std::hypot(axis.x, axis.y, axis.z);
    if (!degrees || !(length > 0)) {
      diagnosis_.fault(step, !degrees ? "a rotation has an angle, in degrees"
                                      : "a rotation has an axis, such as y=\"1\"");
      return Matrix(1);
    }
    const auto [sine, cosine] = sine_and_cosine(*degrees);
    const Vector a = axis_ == RotationAxis::normalized || is_one(length) ? axis / length : axis;
    if (axis_ == RotationAxis::as_given && !is_one(length))
      diagnosis_.note(step, "an axis whose length is not 1 distorts, as it does in Mitsuba 3");
    Matrix result(1);
    for (int column = 0; column < 3; ++column) {
      Vector unit(0);
      unit[column] = 1;
      const Vector turned =
          cosine * unit + sine * glm::cross(a, unit) + (1 - cosine) * a[column] * a;  // Rodrigues
      result[column] = {turned, 0};
    }
    return result;
  }

  static bool is_one(double length) { return std::abs(length - 1) < 1e-5; }  // digits of a file

  // Exact for quarters of a turn, for walls that meet.
  static std::pair<double, double> sine_and_cosine(double degrees) {
    const double quarters = degrees / 90;
    if (quarters != std::floor(quarters)) {
      const double angle = degrees * (std::numbers::pi / 180);
      return {std::sin(angle), std::cos(angle)};
    }
    constexpr double sines[] = {0, 1, 0, -1};
    const auto quarter = static_cast<std::size_t>(quarters - 4 * std::floor(quarters / 4)) % 4;
    return {sines[quarter], sines[(quarter + 1) % 4]};
  }

  Matrix matrix(const XmlElement& step) {
    const auto numbers = numbers_in(step.attribute("value"));
    if (!numbers || (numbers->size() != 16 && numbers->size() != 9)) {
      diagnosis_.fault(step, "a matrix has 16 numbers, or 9, row by row");
      return Matrix(1);
    }
    const std::size_t side = numbers->size() == 16 ? 4 : 3;
    Matrix result(1);
    for (std::size_t i = 0; i < numbers->size(); ++i)
      result[static_cast<int>(i % side)][static_cast<int>(i / side)] = (*numbers)[i];
    for (int column = 0; column < 4; ++column)
      if (result[column][3] != (column == 3 ? 1 : 0)) {
        diagnosis_.fault(step, "the last row of a matrix is 0 0 0 1");
        return Matrix(1);
      }
    return result;
  }

  // x points left, y up, z ahead.
  Matrix look_at(const XmlElement& step) {
    const auto read = [&](const char* name) -> std::optional<Vector> {
      const auto numbers = numbers_in(step.attribute(name));
      if (!numbers || numbers->size() != 3) return {};
      return Vector((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    };
    const auto origin = read("origin"), target = read("target");
    if (!origin || !target || (step.has("up") && !read("up"))) {
      diagnosis_.fault(step, "a lookat has origin, target and up, each of three numbers");
      return Matrix(1);
    }
    const Vector view = *target - *origin;
    const double distance = std::hypot(view.x, view.y, view.z);
    const Vector ahead = view / distance;
    const Vector up = read("up").value_or(Vector(0));
    const Vector left = glm::cross(up == Vector(0) ? any_across(ahead) : up, ahead);
    const double width = std::hypot(left.x, left.y, left.z);
    if (!(distance > 0) || !(width > 1e-12 * std::hypot(up.x, up.y, up.z))) {
      diagnosis_.fault(step, !(distance > 0) ? "origin and target are the same point"
                                             : "up lies along the view; choose one across it");
      return Matrix(1);
    }
    Matrix result(1);
    result[0] = {left / width, 0};
    result[1] = {glm::cross(ahead, left / width), 0};
    result[2] = {ahead, 0};
    result[3] = {*origin, 1};
    return result;
  }

  // As Mitsuba chooses it [Duff et al. 2017], so that the picture is not turned.
  static Vector any_across(Vector n) {
    const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z);
    return {sign * (n.x * n.x * a) + 1, sign * (n.x * n.y * a), -sign * n.x};
  }

  RotationAxis axis_;
  Diagnosis& diagnosis_;
};

}  // namespace

glm::dvec3 vector_of(const XmlElement& element, glm::dvec3 otherwise, Diagnosis& diagnosis) {
  static constexpr const char* axes[] = {"x", "y", "z"};
  if (element.has("value")) {
    const auto numbers = numbers_in(element.attribute("value"));
    const bool has_axes = element.has("x") || element.has("y") || element.has("z");
    if (numbers && numbers->size() == 3 && !has_axes)
      return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    if (numbers && numbers->size() == 1 && !has_axes && element.tag == "scale")
      return glm::dvec3((*numbers)[0]);
    diagnosis.fault(element,
                    fmt::format("\"{}\" is no value of a <{}>; give three numbers, or x, y and z",
                                excerpt(element.attribute("value")), element.tag));
    return otherwise;
  }
  glm::dvec3 result = otherwise;
  for (int axis = 0; axis < 3; ++axis) {
    if (!element.has(axes[axis])) continue;
    const auto number = number_in(element.attribute(axes[axis]));
    if (!number)
      diagnosis.fault(element, fmt::format("{} is \"{}\"; it is a finite number", axes[axis],
                                           excerpt(element.attribute(axes[axis]))));
    result[axis] = number.value_or(otherwise[axis]);
  }
  return result;
}

glm::dmat4 transform_of(const XmlElement& transform, RotationAxis axis, Diagnosis& diagnosis) {
  return TransformReader(axis, diagnosis).of(transform);
}

}  // namespace wander
