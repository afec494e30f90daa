#include "draw/report/report.h"

#include <fmt/format.h>

#include <array>

#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/style_sheet.h"

namespace wander {
namespace {

using report::Html;
using report::Subject;

struct Section {
  std::string_view id, heading;
  void (*write)(Html& html, const Subject& subject);
};
constexpr std::array<Section, 10> sections{
    {{"verdict", "Verdict", report::write_verdict},
     {"scene", "The scene, and what it requires", report::write_scene},
     {"films", "Films", report::write_films},
     {"spread", "Spread between seeds", report::write_spread},
     {"errors", "Error against time and samples", report::write_errors},
     {"acceptance", "Acceptance, and reasons of refusal", report::write_acceptance},
     {"mixing", "Autocorrelation and effective samples", report::write_mixing},
     {"energy", "Energy by path length and class", report::write_energy},
     {"normalization", "Normalization", report::write_normalization},
     {"provenance", "Provenance: how to repeat every run", report::write_provenance}}};

std::string title_of(const Subject& subject) {
  constexpr std::size_t most_names = 4;
  const std::string scene = subject.scene.name.empty() ? "a scene" : subject.scene.name;
  return fmt::format("{}: {} compared", scene,
                     subject.contenders() <= most_names
                         ? report::listed(subject.labels())
                         : report::counted(subject.contenders(), "contender"));
}

// What the browser may load: nothing but the style and the pictures that are in this page.
constexpr std::string_view head =
    R"(<meta charset="utf-8"/>
<meta http-equiv="Content-Security-Policy" )"
    R"(content="default-src 'none'; style-src 'unsafe-inline'; img-src data:"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta name="color-scheme" content="light dark"/>
)";

void write_head(Html& html, const Subject& subject) {
  const auto scope = html.open("head");
  html.markup(head);
  html.element("title", title_of(subject));
  const auto style = html.open("style");
  html.markup(report::style_sheet());
}

void write_header(Html& html, const Subject& subject) {
  const auto scope = html.open("header");
  html.element("h1", title_of(subject));
  const auto& runs = subject.runs();
  html.element("p",
               fmt::format("{}; {}, {} each; Wanderlight {}.",
                           report::counted(subject.contenders(), "contender"),
                           report::counted(runs.budgets.size(), "budget"),
                           report::counted(runs.replicates, "replicate"), runs.provenance.version),
               {{"class", "about"}});
}

void write_contents(Html& html) {
  const auto scope = html.open("nav", {{"aria-label", "Sections"}});
  const auto list = html.open("ol");
  for (const Section& section : sections) {
    const auto item = html.open("li");
    html.element("a", section.heading, {{"href", fmt::format("#{}", section.id)}});
  }
}

void write_section(Html& html, const Section& section, const Subject& subject) {
  const std::string heading = fmt::format("{}-heading", section.id);
  const auto scope = html.open("section", {{"id", section.id}, {"aria-labelledby", heading}});
  html.element("h2", section.heading, {{"id", heading}});
  section.write(html, subject);
}

}  // namespace

std::string report_html(const compare::Comparison& comparison) {
  return report_html(comparison, report::scene_of(comparison));
}

std::string report_html(const compare::Comparison& comparison, const description::Scene& scene) {
  const Subject subject{comparison, scene};
  Html html;
  html.markup("<!DOCTYPE html>\n");
  {
    const auto document = html.open("html", {{"lang", "en"}});
    write_head(html, subject);
    const auto body = html.open("body");
    html.element("a", "Skip to the verdict", {{"class", "skip"}, {"href", "#verdict"}});
    write_header(html, subject);
    write_contents(html);
    const auto main = html.open("main");
    for (const Section& section : sections) write_section(html, section, subject);
  }
  return std::move(html).finish();
}

}  // namespace wander
