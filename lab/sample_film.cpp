#include "lab/sample_film.h"

#include <algorithm>
#include <cereal/archives/binary.hpp>
#include <cereal/types/vector.hpp>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/large_sample_film.h"
#include "lab/archived_sums.h"
#include "lab/drive.h"

namespace wander {

namespace {

// Samples per unit of work: enough to hide the cost of merging a film, whatever the threads; of a
// list, so few that it stays small.
template <class Film>
constexpr std::uint64_t samples_per_unit(std::uint64_t bins) {
  if (std::same_as<Film, LargeSampleFilm>) return 4096;
  return std::max<std::uint64_t>(4096, bins / 4);
}

template <class Film>
Rendering rendering_of(const SamplingMethod& method, const Film& film, std::span<const int> shape) {
  Rendering found{.method = method.name, .samples = film.samples(), .film = film.estimate(shape)};
  add_doubts(found, film.techniques(), method.by_chance);
  return found;
}

// Sums over samples, and their number.
template <class Film>
class SampleFindings final : public Findings {
 public:
  SampleFindings(const SamplingMethod& method, std::vector<int> shape)
      : method_(method), shape_(std::move(shape)) {}

  void add(const Film& film) {
    if (film_)
      film_->merge(film);
    else
      film_ = film;
  }
  // To a film.
  void add_part(const typename Film::Part& part) { film_->merge(part); }
  Rendering rendering() const override { return rendering_of(method_, *film_, shape_); }

 private:
  SamplingMethod method_;
  std::vector<int> shape_;
  std::optional<Film> film_;
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
template <class Film>
class SampleRun final : public LiveRun {
 public:
  SampleRun(const SamplingMethod& method, std::span<const int> shape, int max_vertices,
            const FilmLayout& layout, const Run& run, const std::function<FilmSampler()>& make)
      : method_(method),
        run_(run),
        shape_(shape.begin(), shape.end()),
        max_vertices_(max_vertices),
        layout_(layout),
        per_unit_(samples_per_unit<Film>(values_of(shape))),
        film_(shape, max_vertices, layout) {
    for (int i = 0; i < slots_of(run); ++i) slots_.push_back({make(), {}, empty_part()});
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
    Film film = film_;
    film.merge(*open_);
    return film.estimate(shape_);
  }
  Rendering findings() const override {
    if (!open_) return rendering_of(method_, film_, shape_);
    Film film = film_;
    film.merge(*open_);
    return rendering_of(method_, film, shape_);
  }
  std::unique_ptr<Findings> no_findings() const override {
    return std::make_unique<SampleFindings<Film>>(method_, shape_);
  }
  void add_to(Findings& all) const override {
    auto& found = dynamic_cast<SampleFindings<Film>&>(all);
    found.add(film_);
    if (open_) found.add_part(*open_);
  }

  void save(cereal::BinaryOutputArchive& archive) const override {
    archive(film_, open_.has_value());
    if (open_) archive(*open_);
  }
  void load(cereal::BinaryInputArchive& archive) override {
    bool has_open = false;
    archive(film_, has_open);
    open_.reset();
    if (has_open) archive(open_.emplace(empty_part()));
  }

 private:
  using Part = typename Film::Part;
  // What one unit works in.
  struct Slot {
    FilmSampler sample;
    Contributions found;
    Part film;
  };
  static constexpr std::uint64_t units_per_stride = 64, fewest_units = 16;  // of each thread

  Part empty_part() const { return {shape_, max_vertices_, layout_}; }

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
        slot.found.clear();
        slot.sample(rng, slot.found);
        slot.film.add(slot.found);
      }
    };
    const auto merge = [&](std::uint64_t, int index) {
      const Part& made = slots_[static_cast<std::size_t>(index)].film;
      if (made.samples() < per_unit)
        open_ = made;
      else
        film_.merge(made);
      tell(samples());
    };
    run_in_order(run_, {(end - first - 1) / per_unit + 1, more, work, merge});
  }

  SamplingMethod method_;
  const Run& run_;
  std::vector<int> shape_;
  int max_vertices_;
  FilmLayout layout_;
  std::uint64_t per_unit_;
  Film film_;                 // of whole units
  std::optional<Part> open_;  // of the one that is not yet whole
  std::vector<Slot> slots_;
};

}  // namespace

std::unique_ptr<LiveRun> make_sample_run(const SamplingMethod& method, std::span<const int> shape,
                                         int max_vertices, const FilmLayout& layout,
                                         const Run& execution,
                                         const std::function<FilmSampler()>& make) {
  if (layout.is_large(shape))
    return std::make_unique<SampleRun<LargeSampleFilm>>(method, shape, max_vertices, layout,
                                                        execution, make);
  return std::make_unique<SampleRun<SampleFilm>>(method, shape, max_vertices, layout, execution,
                                                 make);
}

Rendering sample_film(const char* method, std::span<const int> shape, int max_vertices,
                      const Session& session, const std::function<FilmSampler()>& make) {
  Run execution(session);
  return drive(*make_sample_run(method, shape, max_vertices, {}, execution, make), execution);
}

}  // namespace wander
