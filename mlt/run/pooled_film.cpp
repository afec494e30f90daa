#include "mlt/run/pooled_film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "statistics/jackknife.h"

namespace wander {

namespace {

// A bin, or their mean: of one run, with or without one of its groups.
struct Parts {
  double of_samples = 0, of_chains = 0;  // E_j, S_j

  double light(double b) const { return of_samples + b * of_chains; }
  Parts& operator+=(const Parts& other) { return add(other, 1); }
  Parts& add(const Parts& other, double weight) {
    of_samples += weight * other.of_samples;
    of_chains += weight * other.of_chains;
    return *this;
  }
};

// Sums over the groups of one run.
class RunSums {
 public:
  explicit RunSums(std::span<const GroupFindings> groups)
      : groups_(groups), bins_(static_cast<double>(groups.front().film->bins())) {
    sums_.resize(groups.front().film->bins());
    for (const GroupFindings& group : groups) {
      samples_ += samples_of(group);
      double mass = 0;
      for (std::size_t j = 0; j < sums_.size(); ++j) mass += group.scale * group.film->weight(j);
      masses_.push_back(mass);
      mass_ += mass;
      Parts& whole = wholes_.emplace_back();
      for (std::size_t j = 0; j < sums_.size(); ++j) {
        const Parts of_bin = deposits(group, j);
        sums_[j] += of_bin;
        whole += of_bin;
      }
      all_ += whole;
    }
  }

  std::size_t groups() const { return groups_.size(); }
  Parts at(std::size_t bin) const { return scaled(sums_[bin], samples_, mass_, bins_); }
  Parts mean() const { return scaled(all_, samples_, mass_, 1); }
  // Without group g.
  Parts at(std::size_t bin, std::size_t g) const {
    return without(sums_[bin], deposits(groups_[g], bin), g, bins_);
  }
  Parts mean_without(std::size_t g) const { return without(all_, wholes_[g], g, 1); }
  // Of paths of each length: `samples`, `chains` are what E and S are multiplied by.
  void add_lengths(std::map<int, std::vector<double>>& films, double samples, double chains) const {
    const auto add = [&films](const GroupFilm& film, double factor) {
      for (const auto& [vertices, values] : film.lengths().scaled(factor)) {
        auto& sum = films[vertices];
        sum.resize(values.size());
        for (std::size_t j = 0; j < values.size(); ++j) sum[j] += values[j];
      }
    };
    for (const GroupFindings& group : groups_) {
      add(group.parts.front().of_samples(), samples * bins_ / samples_);
      if (mass_ > 0) add(group.parts.front().of_chains(), chains * bins_ * group.scale / mass_);
    }
  }

 private:
  static double samples_of(const GroupFindings& group) {
    return static_cast<double>(group.seeds->samples);
  }
  static Parts deposits(const GroupFindings& group, std::size_t bin) {
    return {group.parts.front().of_samples().weight(bin),
            group.scale * group.parts.front().of_chains().weight(bin)};
  }
  static Parts scaled(const Parts& sums, double samples, double mass, double bins) {
    return {bins * sums.of_samples / samples, mass > 0 ? bins * sums.of_chains / mass : 0};
  }
  Parts without(Parts sums, const Parts& of_group, std::size_t g, double bins) const {
    const double rest = mass_ - masses_[g];
    sums.add(of_group, -1);
    if (!(rest > 1e-12 * mass_)) return {not_known, not_known};
    return scaled(sums, samples_ - samples_of(groups_[g]), rest, bins);
  }

  std::span<const GroupFindings> groups_;
  double bins_, samples_ = 0, mass_ = 0;
  std::vector<double> masses_;        // by group: all its deposits
  std::vector<Parts> sums_, wholes_;  // by bin; by group
  Parts all_;
};

// All runs, and what becomes of them without one group.
class Pool {
 public:
  Pool(std::span<const GroupFindings> groups, std::span<const int> groups_of_runs,
       const Constant& constant)
      : constant_(constant) {
    double all = 0;
    for (const GroupFindings& group : groups) all += group.weight;
    for (std::size_t first = 0; const int count : groups_of_runs) {
      const auto of_run = groups.subspan(first, static_cast<std::size_t>(count));
      runs_.emplace_back(of_run);
      const double share = of_run.front().weight / all, size = static_cast<double>(count);
      shares_.push_back(size * share);
      // Without a group the mean of its run moves 1 / (size - 1) of how far the group is from it; that
      // of all groups, share / (1 - share).
      pulls_.push_back(size > 1 ? (size - 1) * share / (1 - share) : 1);
      first += of_run.size();
    }
    level_ = constant.b.value / mean().light(constant.b.value);
    for (std::size_t p = 0; p < runs_.size(); ++p)
      for (std::size_t g = 0; g < runs_[p].groups(); ++g) {
        const double b = constant.without[levels_.size()];
        Parts rest = mean();
        rest.add(runs_[p].mean_without(g), pulls_[p]).add(runs_[p].mean(), -pulls_[p]);
        levels_.push_back(b / rest.light(b));
      }
  }

  double level() const { return level_; }
  Parts mean() const {
    Parts sum;
    for (std::size_t p = 0; p < runs_.size(); ++p) sum.add(runs_[p].mean(), shares_[p]);
    return sum;
  }
  // I_j; and the same without each group.
  double value(std::size_t bin, std::vector<double>& without) const {
    Parts all;
    for (std::size_t p = 0; p < runs_.size(); ++p) all.add(runs_[p].at(bin), shares_[p]);
    without.clear();
    for (std::size_t p = 0; p < runs_.size(); ++p) {
      const Parts of_run = runs_[p].at(bin);
      for (std::size_t g = 0; g < runs_[p].groups(); ++g) {
        const std::size_t k = without.size();
        Parts rest = all;
        rest.add(runs_[p].at(bin, g), pulls_[p]).add(of_run, -pulls_[p]);
        without.push_back(levels_[k] * rest.light(constant_.without[k]));
      }
    }
    return level_ * all.light(constant_.b.value);
  }
  std::map<int, std::vector<double>> by_length() const {
    std::map<int, std::vector<double>> films;
    for (std::size_t p = 0; p < runs_.size(); ++p)
      runs_[p].add_lengths(films, level_ * shares_[p], level_ * shares_[p] * constant_.b.value);
    return films;
  }

 private:
  const Constant& constant_;
  std::vector<RunSums> runs_;
  std::vector<double> shares_, pulls_;  // by run
  double level_ = 1;                    // s
  std::vector<double> levels_;          // without each group
};

}  // namespace

PooledFilm pooled_film(std::span<const GroupFindings> groups, std::span<const int> groups_of_runs,
                       const Constant& constant, std::vector<int> shape) {
  const Pool pool(groups, groups_of_runs, constant);
  const auto lit = std::ranges::count_if(groups, [](const auto& g) { return g.scale > 0; });
  const std::vector<double> weights = weights_of(groups);
  FilmEstimate film{.shape = std::move(shape)};
  std::vector<double> without, deviations(groups.size());  // squared, of all bins together
  for (std::size_t j = 0; j < groups.front().film->bins(); ++j) {
    const double value = pool.value(j, without), error = jackknife_error(without, weights);
    film.value.push_back(value);
    film.standard_error.push_back(error);
    film.reliable.push_back(lit >= GroupsFilm::fewest_groups && value > 0 &&
                            value * value >= fewest_effective_samples * error * error);
    for (std::size_t g = 0; g < groups.size(); ++g)
      deviations[g] += (without[g] - value) * (without[g] - value);
  }
  film.degrees_of_freedom = jackknife_degrees(deviations);
  film.by_length = pool.by_length();
  return {std::move(film), pool.level() * pool.mean().of_samples / constant.b.value};
}

namespace {

// E̅ and S̅ of a run, by its groups.
struct RunMeans {
  explicit RunMeans(std::span<const GroupFindings> groups) {
    for (const GroupFindings& group : groups) {
      const PooledParts& parts = group.parts.front();
      samples.push_back(static_cast<double>(group.seeds->samples));
      easy.push_back(parts.easy_light());
      double part = 0, whole = 0;
      for (std::size_t j = 0; j < group.film->bins(); ++j) {
        part += parts.of_chains().weight(j);
        whole += group.film->weight(j);
      }
      hard.push_back(group.scale * part);
      mass.push_back(group.scale * whole);
    }
  }
  // Of all groups, or of all but one.
  Parts mean(std::size_t without = std::numeric_limits<std::size_t>::max()) const {
    double n = 0, e = 0, h = 0, m = 0;
    for (std::size_t g = 0; g < samples.size(); ++g) {
      if (g == without) continue;
      n += samples[g];
      e += easy[g];
      h += hard[g];
      m += mass[g];
    }
    return {n > 0 ? e / n : 0, m > 0 ? h / m : 1};
  }

  std::vector<double> samples, easy, hard, mass;
};

}  // namespace

Constant pooled_constant(std::span<const GroupFindings> groups,
                         std::span<const int> groups_of_runs) {
  double all = 0, light = 0, squares = 0;
  for (const GroupFindings& group : groups) {
    all += group.weight;
    light += group.parts.front().easy_light();
    squares += group.parts.front().easy_squares();
  }
  std::vector<RunMeans> runs;
  std::vector<double> pulls;  // as above
  Parts mean;
  for (std::size_t first = 0; const int count : groups_of_runs) {
    const auto of_run = groups.subspan(first, static_cast<std::size_t>(count));
    const double share = of_run.front().weight / all, size = static_cast<double>(count);
    mean.add(runs.emplace_back(of_run).mean(), share * size);
    pulls.push_back(size > 1 ? (size - 1) * share / (1 - share) : 1);
    first += of_run.size();
  }
  const auto constant = [](const Parts& parts) { return parts.of_samples / (1 - parts.of_chains); };
  if (!(light > 0) || !(mean.of_chains < 1)) return {.failure = "samples carry no light"};
  Constant result{.b = {constant(mean), 0}, .effective_samples = light * light / squares};
  std::vector<double> deviations;
  for (std::size_t p = 0; p < runs.size(); ++p)
    for (std::size_t g = 0; g < runs[p].samples.size(); ++g) {
      Parts rest = mean;
      rest.add(runs[p].mean(g), pulls[p]).add(runs[p].mean(), -pulls[p]);
      result.without.push_back(constant(rest));
      deviations.push_back(std::pow(result.without.back() - result.b.value, 2));
    }
  result.b.standard_error = jackknife_error(result.without, weights_of(groups));
  result.degrees_of_freedom = jackknife_degrees(deviations);
  return result;
}

}  // namespace wander
