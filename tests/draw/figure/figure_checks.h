// What every test of figures needs: SVG read back, and a scene with everything in it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include "core/description.h"

namespace wander::figure {

namespace d = description;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// A tag with empty values: std::regex recurses for every character, and a path has many.
inline std::string without_values(const std::string& tag) {
  std::string shortened;
  bool in_value = false;
  for (const char c : tag) {
    if (c == '"') in_value = !in_value;
    if (!in_value || c == '"' || c == '<') shortened += c;
  }
  return shortened;
}

// Every tag is closed by its own name, in order; no bare markup in texts and attributes; no number
// that is not finite.
inline testing::AssertionResult is_well_formed(const std::string& svg) {
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
    const std::string bare = without_values(rest);
    if (!std::regex_match(bare, found, tag))
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

inline d::Quantity grey(double value) { return {{value, value, value}, false}; }

inline d::Shape segment(d::Coordinates from, d::Coordinates to) {
  d::Shape shape;
  shape.kind = d::Segment{from, to};
  return shape;
}

// A room with every material and kind of shape; the light on the ceiling shines down.
inline d::Scene room() {
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

// The text between `<g class="KIND">` and the end of that group.
inline std::string group(const std::string& svg, const std::string& kind) {
  const auto begin = svg.find("class=\"" + kind + "\"");
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find("</g>", begin) - begin);
}

}  // namespace wander::figure
