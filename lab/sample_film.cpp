#include "lab/sample_film.h"

#include <algorithm>
#include <cereal/archives/binary.hpp>
#include <cereal/types/vector.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "lab/drive.h"

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

int bins_of(std::span<const int> shape) {
  int bins = 1;
  for (const int extent : shape) bins *= extent;
  return bins;
}

// Sums over samples, and their number.
class SampleFindings final : public Findings {
 public:
  SampleFindings(const char* method, std::vector<int> shape)
      : method_(method), shape_(std::move(shape)) {}

  void add(const SampleFilm& film) {
    if (film_)
      film_->merge(film);
    else
      film_ = film;
  }
  Rendering rendering() const override {
    return {.method = method_, .samples = film_->samples(), .film = film_->estimate(shape_)};
  }

 private:
  const char* method_;
  std::vector<int> shape_;
  std::optional<SampleFilm> film_;
};

// When a budget of time is spent.
double end_of(const Budget& budget) {
  const auto* time = std::get_if<TimeBudget>(&budget);
  return time ? time->seconds : std::numeric_limits<double>::infinity();
}

// The film under way.  A sample is known by its number, so units can be of any length.
//
// What is found shall not depend on where the run was stopped: the film is that of whole units,
// merged one by one, and of one that is not yet whole, which is made anew when the run goes on.
class SampleRun final : public LiveRun {
 public:
  SampleRun(const char* method, std::span<const int> shape, int max_vertices, const Run& run,
            const std::function<FilmSampler()>& make)
      : method_(method),
        run_(run),
        shape_(shape.begin(), shape.end()),
        max_vertices_(max_vertices),
        per_unit_(samples_per_unit(bins_of(shape))),
        film_(bins_of(shape), max_vertices) {
    for (int i = 0; i < slots_of(run); ++i)
      slots_.push_back({make(), {bins_of(shape), max_vertices}});
  }

  void advance(std::uint64_t samples) override {
    const std::uint64_t end = this->samples() + samples;
    open_.reset();
    extend_to(end, per_unit_);
  }
  void advance_freely(std::uint64_t samples) override {
    if (open_) film_.merge(*open_);
    open_.reset();
    const auto threads = static_cast<std::uint64_t>(run_.threads());
    const std::uint64_t unit =
        std::clamp(samples / (fewest_units * threads), per_unit_ / fewest_units / 4, per_unit_);
    extend_to(film_.samples() + samples, unit);
    if (open_) film_.merge(*open_);
    open_.reset();
  }
  std::uint64_t samples() const override {
    return film_.samples() + (open_ ? open_->samples() : 0);
  }
  std::uint64_t stride() const override {
    return units_per_stride * static_cast<std::uint64_t>(run_.threads()) * per_unit_;
  }
  std::uint64_t first_look() const override { return 1 << 16; }
  // At the end of a unit.
  std::uint64_t rest(std::uint64_t samples) const override {
    return ((samples - 1) / per_unit_ + 1) * per_unit_;
  }

  FilmEstimate preview() const override {
    if (!open_) return film_.estimate(shape_);
    SampleFilm film = film_;
    film.merge(*open_);
    return film.estimate(shape_);
  }
  Rendering findings() const override {
    return {.method = method_, .samples = samples(), .film = preview()};
  }
  std::unique_ptr<Findings> no_findings() const override {
    return std::make_unique<SampleFindings>(method_, shape_);
  }
  void add_to(Findings& all) const override {
    auto& found = dynamic_cast<SampleFindings&>(all);
    found.add(film_);
    if (open_) found.add(*open_);
  }

  void save(cereal::BinaryOutputArchive& archive) const override {
    archive(film_, open_.has_value());
    if (open_) archive(*open_);
  }
  void load(cereal::BinaryInputArchive& archive) override {
    bool has_open = false;
    archive(film_, has_open);
    open_.reset();
    if (has_open) archive(open_.emplace(bins_of(shape_), max_vertices_));
  }

 private:
  static constexpr std::uint64_t units_per_stride = 64, fewest_units = 16;  // of each thread

  void extend_to(std::uint64_t end, std::uint64_t per_unit) {
    const std::uint64_t first = film_.samples();
    if (first == end) return;
    const double time = end_of(run_.session().budget);
    const auto more = [&](std::uint64_t unit) {
      return !run_.is_interrupted() && (unit == 0 || run_.spent() < time);
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
      const SampleFilm& made = slots_[static_cast<std::size_t>(index)].film;
      if (made.samples() < per_unit)
        open_ = made;
      else
        film_.merge(made);
      tell(samples());
    };
    run_in_order(run_, {(end - first - 1) / per_unit + 1, more, work, merge});
  }

  const char* method_;
  const Run& run_;
  std::vector<int> shape_;
  int max_vertices_;
  std::uint64_t per_unit_;
  SampleFilm film_;                 // of whole units
  std::optional<SampleFilm> open_;  // of the one that is not yet whole
  std::vector<Slot> slots_;
};

}  // namespace

std::unique_ptr<LiveRun> make_sample_run(const char* method, std::span<const int> shape,
                                         int max_vertices, const Run& execution,
                                         const std::function<FilmSampler()>& make) {
  return std::make_unique<SampleRun>(method, shape, max_vertices, execution, make);
}

Rendering sample_film(const char* method, std::span<const int> shape, int max_vertices,
                      const Session& session, const std::function<FilmSampler()>& make) {
  Run execution(session);
  SampleRun run(method, shape, max_vertices, execution, make);
  return drive(run, execution);
}

}  // namespace wander
