#include "lab/drive.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/film_statistics.h"
#include "lab/run_state.h"
#include "mlt/seeds/nothing_found.h"
#include "work/pace.h"

namespace wander {

namespace {

constexpr double rehearsed_after = 0.25;  // of the time of the samples
// The error of the seed pass may be so much of the target, if that is the budget: then b takes
// no more than a quarter of the variance.
constexpr double share_of_error = 0.5;

std::string warning_of_what_stays(double error, double target) {
  return fmt::format(
      "a part of the film's error, about {:.2g} %, stays, above the {:.2g} % asked for: no more "
      "independent samples are made, and mutations do not lessen what these left unknown; make the "
      "run anew with this budget",
      100 * error, 100 * target);
}

std::string warning_of_unknown_error(double target) {
  return fmt::format(
      "nothing tells the error of the film, so nobody knows whether it is below the {:.2g} % asked "
      "for; take a budget of samples or time",
      100 * target);
}

class Drive {
 public:
  Drive(LiveRun& run, Run& execution, const Headway& begin, const Keeper& keeper)
      : run_(run),
        execution_(execution),
        budget_(execution.session().budget),
        headway_(begin),
        keeper_(keeper),
        next_keeping_(execution.seconds() + keeper.first) {
    run_.watch([this](std::uint64_t samples) { report_samples(samples); });
  }
  ~Drive() { run_.watch({}); }
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  Rendering to_the_end() {
    if (const auto* error = std::get_if<ErrorBudget>(&budget_)) aim_at(error->relative);
    has_all_seeds_ = !run_.takes_seeds() || seed_pass();
    if (run_.takes_seeds() && run_.seeds().samples == 0 && execution_.is_interrupted())
      throw NothingComputed();
    if (run_.takes_seeds()) {
      require_worth(has_all_seeds_);
      // An interrupted seed pass goes on from where it was, not from the chains that now show what
      // it found, as few as there can be.
      if (!has_all_seeds_) keep();
      headway_.seed_seconds = execution_.seconds();
      run_.start(has_all_seeds_ ? run_.settings().chains_for(expected_steps()) : 1);
    }
    Rendering r = sampled();
    require_worth(r.complete || is_enough_to_keep());
    if (has_all_seeds_) write();
    return r;
  }

 private:
  // ---- the seed pass; false if it was interrupted

  bool seed_pass() {
    run_.prepare();
    seeds_begin_ = execution_.spent();
    if (const auto* error = std::get_if<ErrorBudget>(&budget_))
      seeds_to_error(share_of_error * error->relative);
    else if (const auto* time = std::get_if<TimeBudget>(&budget_))
      seeds_until(time->seconds);
    else
      seeds_for(std::get<SampleBudget>(budget_).samples);
    return !execution_.is_interrupted();
  }
  static double part(std::uint64_t of_each, std::uint64_t goal) {
    return goal > 0 ? static_cast<double>(of_each) / static_cast<double>(goal) : 1;
  }
  // Of each slice, which all have the same number; those beyond what is asked for only while they cost
  // little.  `fraction` of the budget is done after some.
  template <class Fraction>
  void seeds_to(std::uint64_t goal, std::uint64_t asked_for, Fraction&& fraction) {
    const auto is_enough = [&](const SeedPass& now) {
      return now.of_each() >= goal || (now.of_each() >= asked_for && now.is_costly());
    };
    for (SeedPass now = run_.seeds(); !is_enough(now) && !execution_.is_interrupted();) {
      run_.seed(std::min(run_.seed_stride(), goal - now.of_each()));
      now = run_.seeds();
      report(fraction(now), now.samples, "seed pass");
      keep_if_due();
    }
  }
  void seeds_for(std::uint64_t steps) {
    const auto share = static_cast<std::uint64_t>(run_.seed_share() * static_cast<double>(steps));
    const std::uint64_t slices = run_.seeds().slices;
    const std::uint64_t goal = std::max(run_.settings().fewest_seeds, share) / slices;
    seeds_to(goal, share / slices, [&](const SeedPass& now) {
      const double of_goal = part(now.of_each(), goal),
                   of_share = part(now.of_each(), share / slices);
      return std::max(of_goal, std::min(of_share, now.fraction_of_costs()));
    });
  }
  void seeds_to_error(double target) {
    const std::uint64_t fewest = run_.settings().fewest_seeds / run_.seeds().slices;
    const auto unknown = [](const SeedPass&) { return 0.0; };
    while (true) {
      if (headway_.seed_goal == 0)
        seeds_to(fewest, 0, unknown);
      else
        seeds_to(headway_.seed_goal, headway_.seed_goal, unknown);
      const SeedPass now = run_.seeds();
      if (execution_.is_interrupted()) return;
      if (!now.found_light && now.samples >= samples_in_the_dark) return;
      if (now.found_light && now.relative_error <= target) return;
      const double error = now.found_light ? now.relative_error : INFINITY;
      headway_.seed_goal =
          now.of_each() + (next_look(now.samples, error, target) - now.samples) / now.slices + 1;
    }
  }
  // Where the share is nothing, for the fewest seeds and no more than the usual time.
  void seeds_until(double seconds) {
    const std::uint64_t slices = run_.seeds().slices;
    const double asked_for = run_.seed_share();
    const double share = asked_for > 0 ? asked_for : ChainSettings::usual_seed_share;
    const std::uint64_t most =
        asked_for > 0 ? std::numeric_limits<std::uint64_t>::max() : run_.settings().fewest_seeds;
    // Rehearsed once and made once; of a short budget no more than half.
    const double left = seconds - seeds_begin_,
                 of_findings = std::min(2 * run_.seconds_of_findings(), left / 2);
    const double end = seeds_begin_ + share / (1 + share) * (left - of_findings);
    Pace pace(execution_.spent(), end, run_.seed_stride() * slices);
    std::uint64_t done = run_.seeds().samples;
    for (double now = execution_.spent(); done == 0 || (done < most && !pace.is_over(now));
         now = execution_.spent()) {
      const std::uint64_t count =
          std::max<std::uint64_t>(std::min(pace.next(now, done), most - done) / slices, 1);
      run_.seed(count);
      done += count * slices;
      report(now / seconds, done, "seed pass");
      if (execution_.is_interrupted()) return;
      keep_if_due();
    }
  }

  // ---- how many chains

  // In a time budget a step is taken to cost as much as a sample of the seed pass, which is too
  // much for most; how many steps an error takes is not known, so none are expected.
  std::uint64_t expected_steps() const {
    if (const auto* budget = std::get_if<SampleBudget>(&budget_)) return budget->samples;
    const auto* budget = std::get_if<TimeBudget>(&budget_);
    if (!budget) return 0;
    const double now = execution_.spent();
    return static_cast<std::uint64_t>(static_cast<double>(run_.seeds().samples) *
                                      std::max(0.0, budget->seconds - now) /
                                      std::max(now - seeds_begin_, 1e-9));
  }

  // ---- the samples

  Rendering sampled() {
    if (const auto* error = std::get_if<ErrorBudget>(&budget_)) return to_error(error->relative);
    if (const auto* time = std::get_if<TimeBudget>(&budget_))
      until(time->seconds);
    else
      advance_to(std::get<SampleBudget>(budget_).samples);
    return findings();
  }

  void advance_to(std::uint64_t target) {
    while (run_.samples() < target) {
      const std::uint64_t next = run_.rest(run_.samples() + run_.stride());
      run_.advance(std::min(next, target) - run_.samples());
      report_samples(run_.samples());
      if (execution_.is_interrupted()) return;
      keep_if_due();
    }
  }

  // The looks are those of a run that never stopped if it is carried on to the same error.
  void aim_at(double target) {
    if (headway_.target == target) return;
    headway_.target = target;
    headway_.seed_goal = headway_.goal = 0;
    headway_.looks.clear();
  }
  Rendering to_error(double target) {
    if (headway_.goal == 0) headway_.goal = run_.rest(run_.first_look());
    while (true) {
      advance_to(headway_.goal);
      Rendering r = findings();
      const double error = relative_error(r.film);
      if (error <= target || execution_.is_interrupted()) return r;
      if (!std::isfinite(error) && run_.samples() >= samples_in_the_dark) {
        if (mean_value(r.film) > 0) r.warnings.push_back(warning_of_unknown_error(target));
        return r;
      }
      if (const auto stays = what_stays(r.film, target)) {
        r.warnings.push_back(warning_of_what_stays(*stays, target));
        return r;
      }
      fraction_of_error_ =
          std::isfinite(error) ? std::min(1.0, target * target / (error * error)) : 0;
      headway_.goal = run_.rest(next_look(run_.samples(), error, target));
    }
  }

  // Of the error, because the seed pass has come to its end.
  std::optional<double> what_stays(const FilmEstimate& film, double target) {
    const double error = relative_error(film);
    if (!std::isfinite(error) || !run_.lacks_samples(share_of_error * target)) return {};
    std::vector<Look>& looks = headway_.looks;
    if (looks.empty() || looks.back().samples < run_.samples())
      looks.push_back({run_.samples(), error, film.degrees_of_error});
    return error_that_stays(looks, target);
  }

  // What comes after the samples is rehearsed once, so that its time is known.
  void until(double seconds) {
    const double begin = execution_.spent();
    const double rehearsal = begin + rehearsed_after * (seconds - begin);
    if (run_.samples() > 0 && begin >= seconds) return;
    bool is_rehearsed = false;
    Pace pace(begin, rehearsal, run_.stride());
    double now = begin;
    do {
      run_.advance_freely(pace.next(now, run_.samples()));
      report_samples(run_.samples());
      if (execution_.is_interrupted()) return;
      if (seconds - execution_.spent() > 2 * time_of_keeping_) keep_if_due();
      now = execution_.spent();
      if (is_rehearsed || !pace.is_over(now)) continue;
      is_rehearsed = true;
      run_.findings();
      const double before = std::exchange(now, execution_.spent());
      pace.end_at(seconds - (now - before));
    } while (!pace.is_over(now));
  }

  Rendering findings() {
    Rendering r = run_.findings();
    const auto* budget = std::get_if<SampleBudget>(&budget_);
    r.complete =
        has_all_seeds_ && (budget ? r.samples == budget->samples : !execution_.is_interrupted());
    r.seed = execution_.session().seed;
    r.threads = execution_.threads();
    r.seed_seconds = headway_.seed_seconds;
    r.seconds = execution_.seconds();
    r.processor_seconds = execution_.processor_seconds();
    return r;
  }

  // ---- reports and keeping

  double fraction(std::uint64_t samples) const {
    if (const auto* budget = std::get_if<SampleBudget>(&budget_))
      return static_cast<double>(samples) / static_cast<double>(budget->samples);
    if (const auto* budget = std::get_if<TimeBudget>(&budget_))
      return execution_.spent() / budget->seconds;
    return fraction_of_error_;
  }
  void report_samples(std::uint64_t samples) { report(fraction(samples), samples, "sampling"); }
  void report(double fraction, std::uint64_t samples, const char* phase) {
    execution_.report({fraction, samples, execution_.seconds(), phase});
  }

  void keep_if_due() {
    if (!keeper_.keep || !(keeper_.every > 0) || execution_.seconds() < next_keeping_) return;
    const double before = execution_.seconds();
    keep();
    next_keeping_ = execution_.seconds() + keeper_.every;
    time_of_keeping_ = execution_.seconds() - before;
  }
  bool is_enough_to_keep() const { return run_.samples() >= keeper_.least; }
  void require_worth(bool is_worth_its_place) const {
    if (keeper_.least > 0 && !is_worth_its_place)
      throw NothingComputed(fmt::format(
          "there were as many samples as the {} of the film in its place, which stays as "
          "it is",
          keeper_.least));
  }
  void keep() {
    if (is_enough_to_keep()) write();
  }
  void write() {
    if (!keeper_.keep) return;
    headway_.wall_seconds = execution_.seconds();
    headway_.processor_seconds = execution_.processor_seconds();
    headway_.samples = run_.samples();
    keeper_.keep(headway_, [this](std::ostream& bytes) { write_state(run_, bytes); });
  }

  LiveRun& run_;
  Run& execution_;
  const Budget& budget_;
  Headway headway_;
  const Keeper& keeper_;
  bool has_all_seeds_ = true;                  // the chains may be few enough to end all the same
  double seeds_begin_ = 0;                     // of execution_.spent()
  double next_keeping_, time_of_keeping_ = 0;  // of execution_.seconds()
  double fraction_of_error_ = 0;               // of the way to the target, when last seen
};

}  // namespace

ChainSettings fitted(ChainSettings settings, const Budget& budget) {
  const auto* count = std::get_if<SampleBudget>(&budget);
  if (!count) return settings;
  const auto most = static_cast<int>(std::min<std::uint64_t>(count->samples, 1 << 20));
  settings.chains_per_group = std::clamp(most / settings.groups, 1, settings.chains_per_group);
  settings.groups = std::min(settings.groups, most);
  return settings;
}

Rendering drive(LiveRun& run, Run& execution, const Headway& begin, const Keeper& keeper) {
  return Drive(run, execution, begin, keeper).to_the_end();
}

}  // namespace wander
