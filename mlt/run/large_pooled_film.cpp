#include "mlt/run/large_pooled_film.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mlt/run/film_degrees.h"
#include "mlt/run/reliability.h"
#include "mlt/run/run_shares.h"
#include "statistics/jackknife.h"

namespace wander {

namespace {

constexpr std::size_t bins_of_tile = 256;  // so that what all films have of them stays in the cache

struct OfBin {
  double value = 0, variance = 0;
};

// By luminance, summed over all bins.
template <class ValueOfBin>
double luminance_of(std::size_t bins, int channels, ValueOfBin&& value) {
  const auto step = static_cast<std::size_t>(channels);
  double sum = 0;
  for (std::size_t k = 0; k < step; ++k) {
    double of_channel = 0;
    for (std::size_t j = k; j < bins; j += step) of_channel += value(j);
    sum += luminance_weight(channels, k) * of_channel;
  }
  return sum;
}

// One run: its share of all, what its samples say, and what each of its films of chains does.
class RunLight {
 public:
  RunLight(const SharedLight& run, std::span<const GroupFindings> groups, int channels)
      : run_(run), channels_(channels), masses_(static_cast<std::size_t>(run.films->count())) {
    std::vector<double> members(masses_.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto f = static_cast<std::size_t>(run.films->film_of_group(static_cast<int>(g)));
      double light = 0;
      for (const double weight : groups[g].film->weights()) light += weight;
      masses_[f] += groups[g].scale / groups[g].weight * light;
      ++members[f];
    }
    for (std::size_t f = 0; f < masses_.size(); ++f) mass_ += masses_[f] /= members[f];
    samples_ = static_cast<double>(run.samples->samples());
    for (std::size_t f = 0; f < masses_.size(); ++f) {
      parts_.push_back(luminance_of(bins(), channels, [&](std::size_t j) { return part(f, j); }));
      const double rest = mass_ - masses_[f];
      per_rest_.push_back(rest > 1e-12 * mass_ ? 1 / rest : not_known);
    }
  }

  std::size_t films() const { return masses_.size(); }
  std::size_t bins() const { return run_.films->bins(); }
  double weight() const { return run_.weight * static_cast<double>(films()); }
  bool is_lit(std::size_t film) const { return masses_[film] > 0; }
  const SharedLight& light() const { return run_; }
  // S_j / pixels of the mean of all films' deposits.
  double scale_of_mean() const {
    return mass_ > 0 ? static_cast<double>(films()) * run_.scale / mass_ : 0;
  }

  // E_j / pixels
  OfBin of_samples(std::size_t bin) const {
    const auto [sum, squares] = run_.samples->sums(bin);
    const double mean = sum / samples_;
    return {mean, std::max(0.0, squares / samples_ - mean * mean) / (samples_ - 1)};
  }
  double mean_of_samples() const {
    return luminance_of(bins(), channels_, [&](std::size_t j) { return of_samples(j).value; });
  }
  // A term of S_j / pixels: what a film has of it.
  double part(std::size_t film, std::size_t bin) const {
    return run_.scale * run_.films->deposits(film, bin);
  }
  // Of the sum of all films' parts.
  double of_chains(double sum) const { return mass_ > 0 ? sum / mass_ : 0; }
  // With M the mass of all films and m that of one, which has a part d of the sum S M, by how much S changes without it:
  //   (S M - d) / (M - m) - S = (S m - d) / (M - m).
  double change_without(double whole, double part, std::size_t film) const {
    return (whole * masses_[film] - part) * per_rest_[film];
  }
  double mean_of_chains() const {
    return of_chains(std::accumulate(parts_.begin(), parts_.end(), 0.0));
  }
  double change_of_mean_without(std::size_t film) const {
    return change_without(mean_of_chains(), parts_[film], film);
  }

 private:
  const SharedLight& run_;
  int channels_;
  std::vector<double> masses_, parts_;  // by film: all its light, and the part that is in it
  std::vector<double> per_rest_;        // 1 / (M - m) of each film
  double mass_ = 0, samples_ = 0;
};

void add_lengths(std::map<int, std::vector<double>>& films, const SharedLight& run,
                 std::span<const int> shape, double samples, double chains) {
  const auto add = [&films](int vertices, const std::vector<double>& values, double factor) {
    auto& sum = films[vertices];
    sum.resize(values.size());
    for (std::size_t j = 0; j < values.size(); ++j) sum[j] += factor * values[j];
  };
  for (const auto& [vertices, values] : run.samples->by_length(shape))
    add(vertices, values, samples);
  for (std::size_t n = 0; n < run.films->lengths(); ++n) {
    const std::vector<double> mean = run.films->mean_of_length(n);
    if (!mean.empty()) add(static_cast<int>(n) + 2, mean, chains);
  }
}

// All runs, by their weights.
class LargePool {
 public:
  LargePool(std::span<const SharedLight> runs, std::span<const GroupFindings> groups,
            const Constant& constant, int channels)
      : b_(constant.b.value), without_(without_films(runs, constant)) {
    std::size_t first = 0;
    double all = 0;
    for (const SharedLight& run : runs) {
      const auto count = static_cast<std::size_t>(run.films->groups());
      all += runs_.emplace_back(run, groups.subspan(first, count), channels).weight();
      weights_.insert(weights_.end(), static_cast<std::size_t>(run.films->count()), run.weight);
      first += count;
    }
    double samples = 0, chains = 0;
    for (const RunLight& run : runs_) {
      shares_.push_back(share_of_run(static_cast<double>(run.films()), run.light().weight, all));
      const double share = shares_.back().share;
      samples += share * run.mean_of_samples();
      chains += share * run.mean_of_chains();
    }
    level_ = b_ / (samples + b_ * chains);
    of_samples_ = level_ * samples / b_;
    for (std::size_t p = 0; p < runs_.size(); ++p)
      for (std::size_t f = 0; f < runs_[p].films(); ++f) {
        const double b = without_[levels_.size()];
        const double moved = runs_[p].change_of_mean_without(f);
        levels_.push_back(b / (samples + b * (chains + shares_[p].pull * moved)));
      }
  }

  double light_of_samples() const { return of_samples_; }
  std::size_t bins() const { return runs_.front().bins(); }
  std::size_t films() const { return levels_.size(); }
  std::size_t lit() const {
    std::size_t count = 0;
    for (const RunLight& run : runs_)
      for (std::size_t f = 0; f < run.films(); ++f) count += run.is_lit(f) ? 1 : 0;
    return count;
  }

  // Of bins that lie side by side: values, those of the samples' part and their variances; and by film and bin, the
  // values of all without the film.
  struct Tile {
    explicit Tile(std::size_t films, std::size_t size)
        : value(size), of_samples(size), variance_of_samples(size), without(films * size) {}
    std::size_t size() const { return value.size(); }
    std::vector<double> value, of_samples, variance_of_samples, without;
  };
  Tile at(std::size_t begin, std::size_t size) const {
    Tile tile(films(), size);
    std::vector<double> chains(size);
    std::vector<std::vector<double>> of_chains;  // by run
    std::size_t first = 0;
    for (std::size_t p = 0; p < runs_.size(); first += runs_[p++].films()) {
      add_samples(p, begin, tile);
      const std::vector<double>& of_run = of_chains.emplace_back(
          put_parts(p, begin, std::span(tile.without).subspan(first * size), size));
      for (std::size_t i = 0; i < size; ++i) chains[i] += shares_[p].share * of_run[i];
    }
    first = 0;
    for (std::size_t p = 0; p < runs_.size(); first += runs_[p++].films())
      for (std::size_t f = 0; f < runs_[p].films(); ++f) {
        const double level = levels_[first + f], b = without_[first + f];
        double* const without = &tile.without[(first + f) * size];
        for (std::size_t i = 0; i < size; ++i) {
          const double moved = runs_[p].change_without(of_chains[p][i], without[i], f);
          without[i] = level * (tile.of_samples[i] + b * (chains[i] + shares_[p].pull * moved));
        }
      }
    for (std::size_t i = 0; i < size; ++i) {
      tile.value[i] = level_ * (tile.of_samples[i] + b_ * chains[i]);
      tile.of_samples[i] *= level_;
      tile.variance_of_samples[i] *= level_ * level_;
    }
    return tile;
  }
  std::span<const double> weights() const { return weights_; }
  std::map<int, std::vector<double>> by_length(std::span<const int> shape) const {
    std::map<int, std::vector<double>> films;
    const double pixels = static_cast<double>(bins()) / channels_of(shape);
    for (std::size_t p = 0; p < runs_.size(); ++p) {
      const double factor = level_ * shares_[p].share;
      add_lengths(films, runs_[p].light(), shape, factor,
                  factor * b_ * pixels * runs_[p].scale_of_mean());
    }
    return films;
  }

 private:
  void add_samples(std::size_t run, std::size_t begin, Tile& tile) const {
    const double share = shares_[run].share;
    for (std::size_t i = 0; i < tile.size(); ++i) {
      const OfBin found = runs_[run].of_samples(begin + i);
      tile.of_samples[i] += share * found.value;
      tile.variance_of_samples[i] += share * share * found.variance;
    }
  }
  // The parts of a run's films on bins, by film and bin; returns S_j / pixels.
  std::vector<double> put_parts(std::size_t run, std::size_t begin, std::span<double> parts,
                                std::size_t size) const {
    const RunLight& of = runs_[run];
    std::vector<double> sums(size);
    for (std::size_t f = 0; f < of.films(); ++f)
      for (std::size_t i = 0; i < size; ++i) sums[i] += parts[f * size + i] = of.part(f, begin + i);
    for (double& sum : sums) sum = of.of_chains(sum);
    return sums;
  }

  double b_;
  std::vector<double> without_;  // b without each film
  std::vector<RunLight> runs_;
  std::vector<RunShare> shares_;          // by run
  std::vector<double> weights_, levels_;  // by film
  double level_ = 1, of_samples_ = 0;
};

}  // namespace

PooledFilm pooled_film(std::span<const SharedLight> runs, std::span<const GroupFindings> groups,
                       const Constant& constant, std::vector<int> shape) {
  const int channels = channels_of(shape);
  const LargePool pool(runs, groups, constant, channels);
  const double pixels = static_cast<double>(pool.bins()) / channels;
  const Jackknife jackknife(pool.films(), pool.weights());
  FilmEstimate film{.shape = std::move(shape)};
  make_room(film);
  std::vector<double> part_of_samples;
  part_of_samples.reserve(pool.bins());
  FilmDegrees degrees(pool.films());
  std::vector<double> of_films, weights;  // by bin of a tile
  for (std::size_t begin = 0; begin < pool.bins(); begin += bins_of_tile) {
    const LargePool::Tile tile = pool.at(begin, std::min(bins_of_tile, pool.bins() - begin));
    of_films.resize(tile.size());
    weights.clear();
    jackknife.errors(tile.without, of_films);
    for (std::size_t i = 0; i < tile.size(); ++i) {
      const double variance = tile.variance_of_samples[i];
      const double error = std::sqrt(variance + of_films[i] * of_films[i]);
      film.value.push_back(pixels * tile.value[i]);
      part_of_samples.push_back(pixels * tile.of_samples[i]);
      film.standard_error.push_back(pixels * error);
      weights.push_back(degrees.add(tile.value[i], of_films[i] * of_films[i], variance));
    }
    for (std::size_t f = 0; f < pool.films(); ++f) {
      double squares = 0, weighted = 0;
      for (std::size_t i = 0; i < tile.size(); ++i) {
        const double deviation = tile.without[f * tile.size() + i] - tile.value[i];
        squares += deviation * deviation;
        weighted += weights[i] * deviation * deviation;
      }
      degrees.move(f, squares, weighted);
    }
  }
  degrees.tell(film);
  film.reliable = reliability_of_groups(film, pool.lit());
  film.by_length = pool.by_length(film.shape);
  return {std::move(film), pool.light_of_samples(), std::move(part_of_samples)};
}

FilmEstimate total_film(std::span<const SharedLight> runs, const Constant& constant,
                        std::vector<int> shape) {
  const int channels = channels_of(shape);
  const std::size_t bins = runs.front().films->bins();
  const auto at = [runs](std::size_t j) {
    double sum = 0;
    for (const SharedLight& run : runs) sum += run.weight * run.scale * (*run.total)[j];
    return sum;
  };
  const double mass = luminance_of(bins, channels, at);
  // Chains that have yet to make a step show nothing.
  const double factor =
      mass > 0 ? constant.b.value * static_cast<double>(bins) / channels / mass : 0;
  FilmEstimate film{.shape = std::move(shape)};
  for (std::size_t j = 0; j < bins; ++j) film.value.push_back(factor * at(j));
  return film;
}

}  // namespace wander
