#include "draw/report/outcome_bars.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/figure/meanings.h"
#include "draw/figure/share_bars.h"
#include "draw/report/embedding.h"
#include "draw/report/numbers.h"
#include "lab/wording.h"
#include "statistics/number_text.h"

namespace wander::report {
namespace {

// No higher than half a page of paper, so that pages fill.
constexpr std::size_t bars_per_figure = 8;

// Outcome -> proposals.  Who is neither accepted nor failed for a reason of its own was refused by
// the acceptance test.
std::map<std::string, std::uint64_t> outcomes_of(const MutationRecord& mutation) {
  std::map<std::string, std::uint64_t> outcomes = mutation.failures;
  std::uint64_t told = mutation.accepted;
  for (const auto& [reason, count] : outcomes) told += count;
  outcomes[std::string(figure::accepted_word)] += mutation.accepted;
  if (told < mutation.proposed)
    outcomes[std::string(figure::refused_word)] += mutation.proposed - told;
  std::erase_if(outcomes, [](const auto& outcome) { return outcome.second == 0; });
  return outcomes;
}

struct Bars {
  std::vector<figure::ShareBar> bars;
  std::map<std::string, double> outcomes;  // of all bars
};

Bars bars_of(const Subject& subject) {
  Bars result;
  for (const std::size_t k : chain_contenders(subject))
    for (const MutationRecord& mutation : subject.details(k)->mutations) {
      if (mutation.proposed == 0) continue;
      const auto proposed = static_cast<double>(mutation.proposed);
      figure::ShareBar bar{fmt::format("{} of {}", figure::spoken(mutation.name), subject.label(k)),
                           fmt::format("{} proposals, mean a {}", count_in_words(proposed),
                                       number_text(mutation.mean_acceptance, 2))};
      for (const auto& [outcome, count] : outcomes_of(mutation)) {
        bar.shares[outcome] = static_cast<double>(count) / proposed;
        result.outcomes[outcome] += static_cast<double>(count);
      }
      result.bars.push_back(std::move(bar));
    }
  return result;
}

}  // namespace

void write_outcomes(Html& html, const Subject& subject) {
  const Bars all = bars_of(subject);
  const std::vector<figure::Part> parts = figure::outcome_parts(all.outcomes);
  for (std::size_t first = 0; first < all.bars.size(); first += bars_per_figure) {
    const auto begin = all.bars.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(bars_per_figure, all.bars.size() - first);
    const figure::Block block =
        figure::share_bars("", {begin, begin + static_cast<std::ptrdiff_t>(count)}, parts,
                           figure::block_width(figure_width));
    write_figure(
        html,
        figure::page("What became of the proposals",
                     "For each mutation the shares of proposals that were accepted, "
                     "rejected, and that failed for each reason.",
                     figure_width, {block}),
        "Each bar is all proposals of one mutation of one contender, in its first "
        "replicate at the last budget: plain where they were accepted, with the marks of the "
        "legend where they were rejected or failed. A mark means the same in every figure.");
  }
}

}  // namespace wander::report
