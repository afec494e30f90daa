#include "lab/compare/long_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "core/film_statistics.h"
#include "lab/compare/reference.h"
#include "lab/compare/reference_pool.h"
#include "lab/compare/schedule.h"
#include "lab/failure.h"
#include "lab/wording.h"
#include "mlt/seeds/nothing_found.h"

namespace wander::compare {

namespace {

constexpr std::size_t fresh_runs = 2;         // of each maker
constexpr double largest_excess = 1.5 * 1.5;  // over the variance that fresh runs would have

double samples_of(const LongRuns& runs) {
  double samples = 0;
  for (const Rendering& run : runs.runs) samples += static_cast<double>(run.samples);
  return samples;
}

const LongRuns* find(const std::vector<LongRuns>& known, const std::string& method) {
  const auto found = std::ranges::find(known, method, &LongRuns::made_by);
  return found == known.end() ? nullptr : &*found;
}

// Of each run that `worth.method` makes.
Budget budget_for(const Plan& plan, const Worth& worth, double longest) {
  const Budget& largest = plan.budgets.back().budget;
  const double effort = reference_effort(plan) / static_cast<double>(2 * fresh_runs);
  const bool is_time = std::holds_alternative<TimeBudget>(largest);
  if (is_time || !(longest > 0) || !(worth.seconds > 0)) return budget_of(effort, largest);
  const double seconds = effort / effort_of(largest) * longest;
  return budget_of(std::ceil(seconds / worth.seconds), largest);
}

double seconds_of(const Maker& maker) {
  if (const auto* time = std::get_if<TimeBudget>(&maker.budget)) return time->seconds;
  return effort_of(maker.budget) * maker.worth.seconds;
}

// What the fresh runs of this maker would be worth.
double fresh_information(const Maker& maker) {
  if (!(maker.worth.seconds > 0)) return 0;
  const double samples = seconds_of(maker) / maker.worth.seconds;
  return static_cast<double>(fresh_runs) * samples * maker.worth.information;
}

double known_information(const Maker& maker) {
  return samples_of(maker.runs) * maker.worth.information;
}

double sum(const std::vector<Maker>& makers, double (*information)(const Maker&)) {
  double total = 0;
  for (const Maker& maker : makers) total += information(maker);
  return total;
}

// The first two that find light; the first two if none does.
std::vector<Maker> best_two(const std::vector<Maker>& all) {
  std::vector<Maker> two;
  for (const Maker& maker : all)
    if (two.size() < 2 && (maker.worth.information > 0 || !(all.front().worth.information > 0)))
      two.push_back(maker);
  return two;
}

// Of those that are known well enough to confirm another, the two whose runs are worth most.
std::vector<Maker> known_two(std::vector<Maker> all) {
  std::erase_if(all, [](const Maker& maker) {
    const double known = known_information(maker);
    return !(known > 0 && known >= fresh_information(maker) / largest_excess);
  });
  std::ranges::stable_sort(all, std::ranges::greater{}, known_information);
  if (all.size() > 2) all.resize(2);
  return all;
}

class Seeds {
 public:
  Seeds(std::uint64_t seed, const std::vector<std::uint64_t>& taken)
      : seed_(seed), taken_(taken.begin(), taken.end()) {}

  std::uint64_t next() {
    while (!taken_.insert(reference_seed(seed_, run_)).second) ++run_;
    return reference_seed(seed_, run_);
  }

 private:
  std::uint64_t seed_, run_ = 0;
  std::set<std::uint64_t> taken_;
};

std::vector<Part> parts_of(const std::vector<Maker>& makers) {
  std::vector<Part> parts;
  for (const Maker& maker : makers)
    if (!maker.runs.runs.empty())
      parts.push_back(
          {maker.runs.made_by, maker.runs.runs,
           samples_of(maker.runs) * (maker.worth.information > 0 ? maker.worth.information : 1)});
  return parts;
}

[[noreturn]] void give_up(const std::vector<Maker>& makers) {
  std::string names;
  double samples = 0;
  for (const Maker& maker : makers) {
    names += (names.empty() ? "" : " and ") + maker.worth.method;
    samples += samples_of(maker.runs);
  }
  throw CommandFailure(
      ExitCode::failure,
      fmt::format("nothing to measure errors against: long runs of {}, {} samples together, found "
                  "no light; {}; else give a larger -b or --reference FILE",
                  names, count_in_words(samples), where_light_is_lost));
}

}  // namespace

LongPlan plan_reference(const Plan& plan, const std::vector<Worth>& worths,
                        const std::vector<LongRuns>& known, double longest) {
  std::vector<Maker> all;
  for (const Worth& worth : worths) {
    const LongRuns* runs = find(known, worth.method);
    all.push_back(
        {worth, runs ? *runs : LongRuns{worth.method, {}}, budget_for(plan, worth, longest)});
  }
  LongPlan result{best_two(all)};
  for (const LongRuns& runs : known)
    for (const Rendering& run : runs.runs) result.taken_seeds.push_back(run.seed);
  const double needed = sum(result.makers, fresh_information) / largest_excess;
  const std::vector<Maker> two = known_two(all);
  if (two.size() == result.makers.size() && sum(two, known_information) >= needed && needed > 0) {
    result.makers = two;
    return result;
  }
  result.more = fresh_runs;
  for (const Maker& maker : result.makers)
    result.seconds += static_cast<double>(fresh_runs) * seconds_of(maker);
  return result;
}

double effort_of(const LongPlan& plan) {
  double effort = 0;
  for (const Maker& maker : plan.makers)
    effort += static_cast<double>(plan.more) * effort_of(maker.budget);
  return effort;
}

Reference make_reference(const Plan& plan, LongPlan reference, const ReferenceCache& cache,
                         Course& course, const std::vector<int>& shape, Runs& runs) {
  Seeds seeds(plan.seed, reference.taken_seeds);
  for (std::size_t i = 0; i < reference.more; ++i)
    for (Maker& maker : reference.makers) {
      if (course.is_interrupted()) break;
      const std::string what =
          fmt::format("reference: {} {}", maker.worth.method, text_of(maker.budget));
      try {
        Rendering run = course.render(course.usual(find_method(maker.worth.method)), maker.budget,
                                      seeds.next(), what);
        if (run.samples == 0) continue;
        const bool is_worth_keeping = run.complete && !is_dark(run.film);
        maker.runs.runs.push_back(std::move(run));
        if (is_worth_keeping) cache.store(maker.runs, runs.warnings);
      } catch (const NoLightFound& dark) {
        runs.warnings.push_back(fmt::format("{} failed: {}", what, dark.what()));
      }
    }
  runs.complete = runs.complete && !course.is_interrupted();
  const std::vector<Part> parts = parts_of(reference.makers);
  if (parts.empty() && !runs.complete) return no_reference(shape);
  if (parts.empty()) give_up(reference.makers);
  Reference made = pooled_reference(parts);
  if (is_dark(made.film) && runs.complete) give_up(reference.makers);
  if (!runs.complete) made.origin += "; interrupted";
  return made;
}

}  // namespace wander::compare
