#include "draw/report/embedding.h"

#include <fmt/format.h>

namespace wander::report {
namespace {

void replace_all(std::string& text, std::string_view old, std::string_view by) {
  for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size()))
    text.replace(at, old.size(), by);
}

// Only within tags; what a text says stays.
std::string with_prefix(std::string_view svg, const std::string& prefix) {
  std::string result;
  while (!svg.empty()) {
    const std::size_t open = std::min(svg.find('<'), svg.size());
    result += svg.substr(0, open);
    svg.remove_prefix(open);
    const std::size_t end = svg.empty() ? 0 : svg.find('>') + 1;
    std::string tag(svg.substr(0, end));
    svg.remove_prefix(end);
    replace_all(tag, " id=\"", " id=\"" + prefix + "-");
    replace_all(tag, "url(#", "url(#" + prefix + "-");
    replace_all(tag, "href=\"#", "href=\"#" + prefix + "-");
    result += tag;
  }
  return result;
}

void replace_first(std::string& text, std::string_view old, std::string_view by) {
  if (const auto at = text.find(old); at != std::string::npos) text.replace(at, old.size(), by);
}

}  // namespace

std::string embedded(std::string_view svg_document, const std::string& prefix) {
  std::string svg = with_prefix(svg_document.substr(svg_document.find("<svg")), prefix);
  replace_first(svg, " role=\"img\"",
                fmt::format(" role=\"img\" aria-labelledby=\"{0}-title {0}-desc\"", prefix));
  // Lengths in an SVG are points, and so is the width that it was laid out for.
  const auto from = svg.find(" width=\"") + 8, end = svg.find('"', from);
  replace_first(
      svg, " role=", fmt::format(" style=\"--own-width: {}\" role=", svg.substr(from, end - from)));
  replace_first(svg, "<title>", fmt::format("<title id=\"{}-title\">", prefix));
  replace_first(svg, "<desc>", fmt::format("<desc id=\"{}-desc\">", prefix));
  return svg;
}

void write_figure(Html& html, std::string_view svg_document, std::string_view caption,
                  Ground ground, Breadth breadth) {
  const int number = html.next_number();
  const std::string kind = ground == Ground::page ? "chart" : "picture";
  const auto scope =
      html.open("figure", {{"class", breadth == Breadth::page ? kind : kind + " column"}});
  {
    // Keys scroll a figure that is wider than the screen.
    const std::string id = fmt::format("figure-{}", number);
    const auto view = html.open("div", {{"class", "view"},
                                        {"role", "group"},
                                        {"tabindex", "0"},
                                        {"aria-labelledby", id + "-title"}});
    html.markup(embedded(svg_document, id));
  }
  html.element("figcaption", caption);
}

}  // namespace wander::report
