#include "core/sample_film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/output/film_statistics.h"
#include "core/run.h"
#include "core/stopping_rule.h"

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

  std::uint64_t units() const { return (goal_ - 1) / per_unit_ + 1; }
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

  const Limit& limit_;
  std::uint64_t per_unit_, goal_;
  double error_ = std::numeric_limits<double>::infinity();
};

int bins_of(std::span<const int> shape) {
  int bins = 1;
  for (const int extent : shape) bins *= extent;
  return bins;
}

}  // namespace

Rendering sample_film(const char* method, std::span<const int> shape, int max_vertices,
                      const Session& session, const std::function<FilmSampler()>& make) {
  Run run(session);
  const Limit limit(session.budget);
  const int bins = bins_of(shape);
  const std::uint64_t per_unit = samples_per_unit(bins);
  SampleFilm film(bins, max_vertices);
  std::vector<Slot> slots;
  for (int i = 0; i < slots_of(run); ++i) slots.push_back({make(), {bins, max_vertices}});

  Looks looks(limit, per_unit);
  const auto count_of = [&](std::uint64_t unit) {
    return std::min(per_unit, limit.samples - unit * per_unit);
  };
  const auto more = [&](std::uint64_t unit) {
    return !run.is_interrupted() && (unit == 0 || run.seconds() < limit.seconds);
  };
  std::uint64_t done = 0;  // units
  do {
    const std::uint64_t first = done;
    const auto work = [&](std::uint64_t unit, int index) {
      Slot& slot = slots[static_cast<std::size_t>(index)];
      slot.film.clear();
      Rng rng(session.seed, Purpose::estimate, 0);
      for (std::uint64_t i = 0; i < count_of(first + unit); ++i) {
        rng.start((first + unit) * per_unit + i);
        slot.sample(rng, slot.film);
        slot.film.end_sample();
      }
    };
    const auto merge = [&](std::uint64_t, int index) {
      film.merge(slots[static_cast<std::size_t>(index)].film);
      const double fraction =
          std::max(looks.fraction(), limit.fraction(film.samples(), run.seconds()));
      run.report({fraction, film.samples(), run.seconds(), "sampling"});
    };
    run_in_order(run, {looks.units() - first, more, work, merge});
    done = looks.units();
  } while (!run.is_interrupted() && !looks.is_done(film, shape));

  Rendering rendering{.method = method,
                      .samples = film.samples(),
                      .seed = session.seed,
                      .threads = run.threads(),
                      .seconds = run.seconds(),
                      .film = film.estimate(shape)};
  const bool is_counted = std::holds_alternative<SampleBudget>(session.budget);
  rendering.complete = is_counted ? film.samples() == limit.samples : !run.is_interrupted();
  return rendering;
}

}  // namespace wander
