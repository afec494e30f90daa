#include "draw/figure/acceptance_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "draw/figure/meanings.h"
#include "draw/figure/share_bars.h"
#include "lab/wording.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

struct Tried {
  std::string mutation;
  double steps = 0, acceptance = 0;        // acceptance: Σ a
  std::map<std::string, double> outcomes;  // word -> steps
};

// Only mutations that were tried, in their order.
std::vector<Tried> tried_in(const Steps& steps) {
  std::vector<Tried> all;
  for (const std::string& name : steps.trajectory().mutations) all.push_back({name, 0, 0, {}});
  steps.each([&](const Step& step) {
    const auto tried = std::ranges::find(all, steps.mutation(step), &Tried::mutation);
    if (tried == all.end()) return;
    tried->steps += 1;
    tried->acceptance += steps.trajectory().acceptance[step.index];
    tried->outcomes[steps.accepted(step) ? std::string(accepted_word)
                                         : std::string(steps.reason(step))] += 1;
  });
  std::erase_if(all, [](const Tried& tried) { return tried.steps == 0; });
  return all;
}

// As far as they occur.
std::vector<Part> parts_of(const std::vector<Tried>& all) {
  std::map<std::string, double> counts;
  double total = 0;
  for (const Tried& tried : all) {
    total += tried.steps;
    for (const auto& [outcome, steps] : tried.outcomes) counts[outcome] += steps;
  }
  std::vector<Part> parts = outcome_parts(counts);
  for (Part& part : parts)
    part.legend += fmt::format(": {} of all", percent(counts[part.key] / total));
  return parts;
}

ShareBar bar_of(const Tried& tried) {
  ShareBar bar{
      spoken(tried.mutation),
      fmt::format("{} step{}, mean a {}", count_in_words(tried.steps), tried.steps == 1 ? "" : "s",
                  number_text(tried.acceptance / tried.steps, 2))};
  for (const auto& [outcome, steps] : tried.outcomes) bar.shares[outcome] = steps / tried.steps;
  return bar;
}

}  // namespace

Block acceptance_chart(const Steps& steps, double width) {
  const std::vector<Tried> all = tried_in(steps);
  std::vector<ShareBar> bars;
  for (const Tried& tried : all) bars.push_back(bar_of(tried));
  return share_bars(fmt::format("What became of the proposals, {}{}", in_words(steps),
                                all.empty() ? ": no step was chosen" : ""),
                    std::move(bars), parts_of(all), width);
}

}  // namespace wander::figure
