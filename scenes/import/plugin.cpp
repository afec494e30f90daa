#include "scenes/import/plugin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/format/json_text.h"
#include "scenes/format/scene_file_nearest.h"
#include "scenes/import/number_words.h"
#include "scenes/import/transform.h"

namespace wander {

std::string present_name(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto is = [](char c, char low, char high) { return c >= low && c <= high; };
    const bool is_upper = is(name[i], 'A', 'Z');
    if (is_upper && i > 0 && is(name[i - 1], 'a', 'z')) result += '_';
    result += is_upper ? static_cast<char>(name[i] - 'A' + 'a') : name[i];
  }
  return result;
}

Plugin::Plugin(const XmlElement& element, const ImportContext& context)
    : element_(element), context_(context) {
  for (const XmlElement& child : element.children) {
    if (!child.has("name")) continue;
    const std::string name = present_name(child.attribute("name"));
    if (!values_.emplace(name, &child).second)
      refuse(child, fmt::format("{} is given twice", excerpt(name)));
  }
}

const XmlElement& Plugin::where(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? element_ : *found->second;
}

void Plugin::refuse(const XmlElement& value, std::string_view what) const {
  context_.diagnosis.fault(value, what);
}

const XmlElement* Plugin::take(std::string_view name,
                               std::initializer_list<std::string_view> tags) {
  asked_.emplace_back(name);
  const auto found = values_.find(name);
  if (found == values_.end()) return nullptr;
  used_.insert(found->second);
  if (std::ranges::find(tags, found->second->tag) != tags.end()) return found->second;
  refuse(*found->second, fmt::format("{} is a <{}>; it is given by <{}>", name,
                                     excerpt(found->second->tag), fmt::join(tags, "> or <")));
  return nullptr;
}

double Plugin::number(std::string_view name, double otherwise) {
  const XmlElement* value = take(name, {"float", "integer"});
  if (value == nullptr) return otherwise;
  const auto number = number_in(value->attribute("value"));
  if (!number)
    refuse(*value, fmt::format("{} is \"{}\"; it is a finite number", name,
                               excerpt(value->attribute("value"))));
  return number.value_or(otherwise);
}

int Plugin::integer(std::string_view name, int otherwise) {
  const XmlElement* value = take(name, {"integer"});
  if (value == nullptr) return otherwise;
  const auto number = number_in(value->attribute("value"));
  if (number && *number == std::floor(*number) && std::abs(*number) < 1e9)
    return static_cast<int>(*number);
  refuse(*value,
         fmt::format("{} is \"{}\"; it is an integer", name, excerpt(value->attribute("value"))));
  return otherwise;
}

bool Plugin::flag(std::string_view name, bool otherwise) {
  const XmlElement* value = take(name, {"boolean"});
  if (value == nullptr) return otherwise;
  const std::string word = present_name(value->attribute("value"));
  if (word != "true" && word != "false")
    refuse(*value, fmt::format("{} is \"{}\"; it is true or false", name, excerpt(word)));
  return word == "true";
}

std::string Plugin::text(std::string_view name, std::string_view otherwise) {
  const XmlElement* value = take(name, {"string"});
  return value == nullptr ? std::string(otherwise) : value->attribute("value");
}

glm::dvec3 Plugin::point(std::string_view name, glm::dvec3 otherwise) {
  const XmlElement* value = take(name, {"point", "vector"});
  return value == nullptr ? otherwise : vector_of(*value, otherwise, context_.diagnosis);
}

glm::dmat4 Plugin::transform(std::string_view name) {
  const XmlElement* value = take(name, {"transform"});
  if (value == nullptr) return glm::dmat4(1);
  return transform_of(*value, context_.is_old() ? RotationAxis::normalized : RotationAxis::as_given,
                      context_.diagnosis);
}

Colour Plugin::colour(std::string_view name, double otherwise, Light light, double most) {
  const XmlElement* value = take(name, {"rgb", "srgb", "spectrum", "float", "texture", "ref"});
  if (value == nullptr) return {otherwise, otherwise, otherwise};
  const Colour colour = colour_of(*value, light, context_);
  if (std::ranges::any_of(colour, [&](double x) { return x < 0 || x > most; }))
    refuse(*value, fmt::format("{} is ({}); {}", name, fmt::join(colour, ", "),
                               light == Light::reflected ? "a reflectance is from 0 to 1"
                                                         : "it is not below 0"));
  return colour;
}

Colour Plugin::reflectance(std::string_view name, double otherwise) {
  return colour(name, otherwise, Light::reflected, 1);
}

Colour Plugin::radiance(std::string_view name, double otherwise) {
  return colour(name, otherwise, Light::emitted, std::numeric_limits<double>::infinity());
}

Colour Plugin::refraction(std::string_view name, double otherwise) {
  return colour(name, otherwise, Light::unbounded, std::numeric_limits<double>::infinity());
}

bool Plugin::is_of_tag(const XmlElement& child, std::string_view tag) const {
  const XmlElement* object = child.tag == "ref" ? context_.resolved(child) : &child;
  return object != nullptr && object->tag == tag;
}

std::vector<const XmlElement*> Plugin::objects(std::string_view tag) {
  std::vector<const XmlElement*> found;
  for (const XmlElement& child : element_.children) {
    if (used_.contains(&child) || !is_of_tag(child, tag)) continue;
    used_.insert(&child);
    found.push_back(context_.resolved(child));
  }
  return found;
}

void Plugin::ignore(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    asked_.emplace_back(name);
    if (const auto found = values_.find(name); found != values_.end()) used_.insert(found->second);
  }
}

void Plugin::done() {
  for (const XmlElement& child : element_.children) {
    if (used_.contains(&child)) continue;
    const std::string name = present_name(child.attribute("name"));
    const std::string object = fmt::format("{} \"{}\"", element_.tag, excerpt(element_.type()));
    if (child.tag == "ref" && context_.resolved(child) == nullptr) continue;  // told
    if (name.empty())
      refuse(child, fmt::format("<{}> is not known in a {}", excerpt(child.tag), object));
    else
      refuse(child, fmt::format("a {} has no property {} here; {}", object, excerpt(name),
                                suggestion(name, asked_)));
  }
}

}  // namespace wander
