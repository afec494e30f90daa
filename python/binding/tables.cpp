// The tables of the program: methods, dials, mutations and the gallery.
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "draw/figure/style.h"
#include "lab/dials.h"
#include "lab/method.h"
#include "lab/parsing.h"
#include "python/binding/bindings.h"
#include "records/version.h"
#include "scenes/gallery_scenes.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

using Row = nb::typed<nb::dict, nb::str, nb::any>;
using Rows = nb::typed<nb::list, Row>;

nb::str text_of(std::string_view text) { return nb::str(text.data(), text.size()); }

Rows method_table() {
  Rows table;
  for (const Method& method : methods()) {
    nb::list words;
    for (const Dial& dial : dials())
      if (dial.is_of(method)) words.append(text_of(dial.word));
    nb::dict row;
    row["name"] = std::string(method.name);
    row["summary"] = std::string(method.summary);
    row["is_markov_chain"] = method.is_markov_chain();
    row["dials"] = words;
    table.append(row);
  }
  return table;
}

Rows dial_table() {
  Rows table;
  for (const Dial& dial : dials()) {
    nb::dict row;
    row["name"] = std::string(dial.word);
    row["value"] = std::string(dial.value);
    row["help"] = dial.help;
    table.append(row);
  }
  return table;
}

std::vector<std::string> gallery_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < gallery_scene_count; ++i) names.emplace_back(gallery_scenes[i].name);
  return names;
}

nb::tuple stroke_of(const figure::style::Stroke& stroke) {
  return nb::make_tuple(text_of(stroke.colour), text_of(stroke.dashes));
}

// Of figures: colours, and strokes as (colour, dashes).
Row style_table() {
  namespace style = figure::style;
  nb::list films;
  for (const style::Stroke& film : style::films) films.append(stroke_of(film));
  Row table;
  table["ink"] = text_of(style::ink);
  table["wall"] = text_of(style::wall);
  table["light"] = text_of(style::light);
  table["sensor"] = text_of(style::sensor);
  table["glass"] = text_of(style::glass_mark);
  table["accepted"] = stroke_of(style::accepted);
  table["rejected"] = stroke_of(style::rejected);
  table["films"] = films;
  return table;
}

}  // namespace

// Numbers as the command line takes them: one range for each, and one message.
void bind_numbers(nb::module_& module) {
  module.def(
      "seed_of", [](const std::string& text) { return parse_seed(text); }, nb::arg("text"));
  module.def(
      "threads_of", [](const std::string& text) { return text == "0" ? 0 : parse_threads(text); },
      nb::arg("text"), "0: all cores.");
  module.def(
      "count_of",
      [](const std::string& what, const std::string& text, std::uint64_t low, std::uint64_t high) {
        return parse_count(what, text, low, high);
      },
      nb::arg("what"), nb::arg("text"), nb::arg("low"), nb::arg("high"));
  module.def(
      "share_of",
      [](const std::string& what, const std::string& text) { return parse_share(what, text); },
      nb::arg("what"), nb::arg("text"));
}

void bind_tables(nb::module_& module) {
  bind_numbers(module);
  module.def("version", &program_version, "Of the program.");
  module.def("methods", &method_table, "Rows of name, summary, is_markov_chain and dials.");
  module.def("dials", &dial_table, "Rows of name, value and help.");
  module.def("style", &style_table, "Of figures: colours, and strokes as (colour, dashes).");
  module.def("gallery", &gallery_names, "Of the scenes that come with the program.");
}

}  // namespace wander::python
