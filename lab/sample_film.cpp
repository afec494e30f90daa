#include "lab/sample_film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/film_statistics.h"
#include "work/pace.h"
#include "work/parallel.h"
#include "work/stopping_rule.h"

namespace wander {

namespace {

// Samples per unit of work: enough to hide the cost of merging a film, whatever the threads.
std::uint64_t samples_per_unit(int bins) {
  return std::max<std::uint64_t>(4096, static_cast<std::uint64_t>(bins) / 4);
}

// What one unit works in.
struct Slot {
  FilmSampler sample;
  SampleFilm film;
};

struct Limit {
  std::uint64_t samples;
  double seconds, error;

  explicit Limit(const Budget& budget)
      : samples(std::numeric_limits<std::uint64_t>::max()),
        seconds(std::numeric_limits<double>::infinity()),
        error(0) {
    if (const auto* count = std::get_if<SampleBudget>(&budget)) samples = count->samples;
    if (const auto* time = std::get_if<TimeBudget>(&budget)) seconds = time->seconds;
    if (const auto* target = std::get_if<ErrorBudget>(&budget)) error = target->relative;
  }
  double fraction(std::uint64_t done, double elapsed) const {
    return std::max(static_cast<double>(done) / static_cast<double>(samples), elapsed / seconds);
  }
};

// Of samples, rounded up to whole units: when to look at the error, if that is the budget.
class Looks {
 public:
  Looks(const Limit& limit, std::uint64_t per_unit)
      : limit_(limit), per_unit_(per_unit), goal_(limit.error > 0 ? first : limit.samples) {}

  std::uint64_t goal() const { return limit_.error > 0 ? up_to_whole_units() : goal_; }
  // Has the film come to its end?  Else the goal is moved.
  bool is_done(const SampleFilm& film, std::span<const int> shape) {
    if (!(limit_.error > 0)) return true;
    error_ = relative_error(film.estimate(shape));
    if (error_ <= limit_.error) return true;
    if (!std::isfinite(error_) && film.samples() >= samples_in_the_dark) return true;
    goal_ = next_look(film.samples(), error_, limit_.error);
    return false;
  }
  double fraction() const {
    return std::isfinite(error_) ? std::min(1.0, limit_.error * limit_.error / (error_ * error_))
                                 : 0;
  }

 private:
  static constexpr std::uint64_t first = 1 << 16;

  std::uint64_t up_to_whole_units() const { return ((goal_ - 1) / per_unit_ + 1) * per_unit_; }

  const Limit& limit_;
  std::uint64_t per_unit_, goal_;
  double error_ = std::numeric_limits<double>::infinity();
};

int bins_of(std::span<const int> shape) {
  int bins = 1;
  for (const int extent : shape) bins *= extent;
  return bins;
}

// The film under way.  A sample is known by its number, so units can be of any length.
class Sampling {
 public:
  Sampling(Run& run, std::span<const int> shape, int max_vertices,
           const std::function<FilmSampler()>& make)
      : run_(run),
        shape_(shape),
        limit_(run.session().budget),
        per_unit_(samples_per_unit(bins_of(shape))),
        film_(bins_of(shape), max_vertices) {
    for (int i = 0; i < slots_of(run); ++i)
      slots_.push_back({make(), {bins_of(shape), max_vertices}});
  }

  // As many samples as were asked for, or as the error takes.
  void to_the_goal() {
    Looks looks(limit_, per_unit_);
    do {
      fraction_of_error_ = looks.fraction();
      extend_to(looks.goal(), per_unit_);
    } while (!run_.is_interrupted() && !looks.is_done(film_, shape_));
  }

  // As many samples as there is time for.
  void until_time_is_up() {
    const auto threads = static_cast<std::uint64_t>(run_.threads());
    Pace pace(run_.spent(), limit_.seconds, units_per_round * threads * per_unit_);
    for (double now = run_.spent(); film_.samples() == 0 || !pace.is_over(now);
         now = run_.spent()) {
      const std::uint64_t count = pace.next(now, film_.samples());
      const std::uint64_t unit =
          std::clamp(count / (fewest_units * threads), per_unit_ / fewest_units / 4, per_unit_);
      const bool is_first = film_.samples() == 0;
      extend_to(film_.samples() + count, unit);
      if (run_.is_interrupted()) return;
      if (is_first) pace.end_at(limit_.seconds - time_of_an_estimate());
    }
  }

  const SampleFilm& film() const { return film_; }
  bool is_complete() const {
    return std::holds_alternative<SampleBudget>(run_.session().budget)
               ? film_.samples() == limit_.samples
               : !run_.is_interrupted();
  }

 private:
  static constexpr std::uint64_t units_per_round = 64, fewest_units = 16;  // of each thread

  void extend_to(std::uint64_t end, std::uint64_t per_unit) {
    const std::uint64_t first = film_.samples();
    const auto more = [&](std::uint64_t unit) {
      return !run_.is_interrupted() && (unit == 0 || run_.spent() < limit_.seconds);
    };
    const auto work = [&](std::uint64_t unit, int index) {
      Slot& slot = slots_[static_cast<std::size_t>(index)];
      slot.film.clear();
      Rng rng(run_.session().seed, Purpose::estimate, 0);
      const std::uint64_t begin = first + unit * per_unit;
      for (std::uint64_t i = begin; i < std::min(begin + per_unit, end); ++i) {
        rng.start(i);
        slot.sample(rng, slot.film);
        slot.film.end_sample();
      }
    };
    const auto merge = [&](std::uint64_t, int index) {
      film_.merge(slots_[static_cast<std::size_t>(index)].film);
      const double fraction =
          std::max(fraction_of_error_, limit_.fraction(film_.samples(), run_.spent()));
      run_.report({fraction, film_.samples(), run_.seconds(), "sampling"});
    };
    run_in_order(run_, {(end - first - 1) / per_unit + 1, more, work, merge});
  }
  double time_of_an_estimate() const {
    const double before = run_.spent();
    film_.estimate(shape_);
    return run_.spent() - before;
  }

  Run& run_;
  std::span<const int> shape_;
  Limit limit_;
  std::uint64_t per_unit_;
  SampleFilm film_;
  std::vector<Slot> slots_;
  double fraction_of_error_ = 0;
};

}  // namespace

Rendering sample_film(const char* method, std::span<const int> shape, int max_vertices,
                      const Session& session, const std::function<FilmSampler()>& make) {
  Run run(session);
  Sampling sampling(run, shape, max_vertices, make);
  if (std::holds_alternative<TimeBudget>(session.budget))
    sampling.until_time_is_up();
  else
    sampling.to_the_goal();
  Rendering rendering{.complete = sampling.is_complete(),
                      .method = method,
                      .samples = sampling.film().samples(),
                      .seed = session.seed,
                      .threads = run.threads(),
                      .film = sampling.film().estimate(shape)};
  rendering.seconds = run.seconds();
  rendering.processor_seconds = run.processor_seconds();
  return rendering;
}

}  // namespace wander
