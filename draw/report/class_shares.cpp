#include "draw/report/class_shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "draw/figure/meanings.h"
#include "draw/figure/share_bars.h"
#include "draw/report/embedding.h"
#include "draw/report/numbers.h"
#include "draw/report/table.h"
#include "lab/wording.h"

namespace wander::report {
namespace {

constexpr std::size_t classes_per_figure = 8;
using figure::most_classes;
constexpr const char* rest = "all other classes";

using Shares = std::map<std::string, double>;

Shares shares_of(const Rendering& details) {
  Shares shares;
  double steps = 0;
  for (const MutationRecord& mutation : details.mutations)
    for (const PathsRecord& paths : mutation.by_class) {
      shares[paths.path_class] += static_cast<double>(paths.proposed);
      steps += static_cast<double>(paths.proposed);
    }
  for (auto& [name, share] : shares) share /= steps;
  return shares;
}

// The largest by the sum over contenders, then the others as one.
std::vector<std::string> classes_of(const std::vector<Shares>& all) {
  Shares sums;
  for (const Shares& shares : all)
    for (const auto& [name, share] : shares) sums[name] += share;
  std::vector<std::string> names;
  for (const auto& [name, share] : sums) names.push_back(name);
  std::ranges::stable_sort(names, std::greater(), [&](const auto& name) { return sums[name]; });
  if (names.size() > most_classes) {
    names.resize(most_classes);
    names.push_back(rest);
  }
  return names;
}

Shares folded(const Shares& shares, const std::vector<std::string>& classes) {
  Shares result;
  for (const auto& [name, share] : shares)
    result[std::ranges::find(classes, name) != classes.end() ? name : rest] += share;
  return result;
}

std::string what_steps_tell_of_light(const Subject& subject) {
  const std::string of_mlt =
      subject.is_image()
          ? "For mlt these are no shares of the light unless its target is light: by default its "
            "chains come to all pixels alike, however dark, so classes that dim pixels show have "
            "more steps than light."
          : "For mlt, whose chains visit paths in proportion to f, this is the class's share of "
            "the "
            "light, as far as its chains know it.";
  return of_mlt +
         " pssmlt and mmlt weigh classes by what their samples and lengths hold, so theirs differ.";
}

void write_bars(Html& html, const Subject& subject, const std::vector<std::size_t>& contenders,
                const std::vector<Shares>& all, const std::vector<std::string>& classes) {
  std::vector<figure::Part> parts;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    const std::size_t mark = classes[k] == rest ? most_classes : k;
    parts.push_back({classes[k], figure::class_fills()[mark], classes[k]});
  }
  for (std::size_t first = 0; first < contenders.size(); first += classes_per_figure) {
    std::vector<figure::ShareBar> bars;
    for (std::size_t k = first; k < std::min(contenders.size(), first + classes_per_figure); ++k)
      bars.push_back({subject.label(contenders[k]),
                      fmt::format("{} class{}", all[k].size(), all[k].size() == 1 ? "" : "es"),
                      folded(all[k], classes)});
    write_figure(
        html,
        figure::page(
            "Time of the chains by path class",
            "For each contender the share of steps that begin at paths of each "
            "class.",
            figure_width,
            {figure::share_bars("", std::move(bars), parts, figure::block_width(figure_width))}),
        "The share of the mutations of each contender that were proposed while its chains "
        "were at a path of the class. L is the light, D a surface that scatters, S one that "
        "reflects or refracts as a mirror does, E the sensor. " +
            what_steps_tell_of_light(subject));
  }
}

void write_shares(Html& html, const Subject& subject, const std::vector<std::size_t>& contenders,
                  const std::vector<Shares>& all) {
  std::map<std::string, std::size_t> names;
  for (const Shares& shares : all)
    for (const auto& [name, share] : shares) names.emplace(name, 0);
  std::vector<std::string> classes;
  for (const auto& [name, count] : names) classes.push_back(name);
  std::ranges::stable_sort(classes, {}, [](const auto& name) { return name.size(); });
  Table table =
      named_rows("Share of the steps at paths of each class, in percent.", "class", classes);
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    std::vector<std::string> cells;
    for (const std::string& name : classes) {
      const auto found = all[k].find(name);
      cells.push_back(found == all[k].end() ? "none" : rounded(100 * found->second));
    }
    table.add_column({subject.label(contenders[k]) + ", %"}, cells);
  }
  write_folded(html, "All classes, in figures", table);
}

}  // namespace

void write_class_shares(Html& html, const Subject& subject) {
  const std::vector<std::size_t> contenders = chain_contenders(subject);
  html.element("h3", "By path class");
  if (contenders.empty()) {
    html.element("p",
                 "Classes are recorded of the states of Markov chains, and no contender is one.",
                 {{"class", "note"}});
    return;
  }
  std::vector<Shares> all;
  for (const std::size_t k : contenders) all.push_back(shares_of(*subject.details(k)));
  const std::vector<std::string> classes = classes_of(all);
  write_bars(html, subject, contenders, all, classes);
  write_shares(html, subject, contenders, all);
  html.element("p",
               "Methods without chains keep no classes; the lengths above hold all contenders.",
               {{"class", "note"}});
}

}  // namespace wander::report
