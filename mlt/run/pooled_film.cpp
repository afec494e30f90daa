#include "mlt/run/pooled_film.h"

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

double sum(const std::vector<double>& terms) {
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

// E̅ and S̅ of one run.
class RunMeans {
 public:
  explicit RunMeans(std::span<const GroupFindings> groups) {
    for (const GroupFindings& group : groups) {
      const PooledParts& parts = group.parts.front();
      const double part = sum(parts.of_chains().weights()), whole = sum(group.film->weights());
      groups_.push_back({.samples = static_cast<double>(group.seeds->samples),
                         .mass = group.scale * whole,
                         .deposits = {parts.easy_light(), group.scale * part}});
      all_ += groups_.back();
    }
  }

  std::size_t groups() const { return groups_.size(); }
  Parts mean() const { return scaled(all_.deposits); }
  Parts mean_without(std::size_t g) const { return without(g, all_.deposits, groups_[g].deposits); }
  // Of a part of all deposits; and without those of a group, of which it has these.
  Parts scaled(const Parts& deposits) const { return all_.means(deposits); }
  Parts without(std::size_t g, Parts deposits, const Parts& of_group) const {
    Totals rest = all_;
    rest.add(groups_[g], -1);
    deposits.add(of_group, -1);
    return rest.mass > 1e-12 * all_.mass ? rest.means(deposits) : Parts{not_known, not_known};
  }
  double samples() const { return all_.samples; }
  double mass() const { return all_.mass; }

 private:
  struct Totals {
    double samples = 0, mass = 0;  // of the chains: all deposits
    Parts deposits{};

    Totals& operator+=(const Totals& other) { return add(other, 1); }
    Totals& add(const Totals& other, double weight) {
      samples += weight * other.samples;
      mass += weight * other.mass;
      deposits.add(other.deposits, weight);
      return *this;
    }
    Parts means(const Parts& of) const {
      return {samples > 0 ? of.of_samples / samples : 0, mass > 0 ? of.of_chains / mass : 0};
    }
  };

  std::vector<Totals> groups_;
  Totals all_;
};

// What the film is told apart by, and what a group brings to each of them: its samples' part, and its deposits in light.
struct ByBins {
  static std::vector<Parts> deposits(const GroupFindings& group) {
    const std::vector<double> of_samples = group.parts.front().of_samples().weights(),
                              of_chains = group.parts.front().of_chains().weights();
    std::vector<Parts> all;
    all.reserve(of_samples.size());
    for (std::size_t j = 0; j < of_samples.size(); ++j)
      all.push_back({of_samples[j], group.scale * of_chains[j]});
    return all;
  }
  // A bin is as many times its share of the film as there are bins.
  static double unit(std::size_t bins) { return static_cast<double>(bins); }
};
// At n - 2 the paths of n vertices.
struct ByLengths {
  static std::vector<Parts> deposits(const GroupFindings& group) {
    const std::vector<double> of_samples = group.parts.front().easy_light_by_length(),
                              of_chains = group.parts.front().of_chains().by_length();
    std::vector<Parts> all;
    for (std::size_t n = 0; n < of_samples.size(); ++n)
      all.push_back({of_samples[n], n < of_chains.size() ? group.scale * of_chains[n] : 0});
    return all;
  }
  static double unit(std::size_t) { return 1; }
};

// The same of each bin, or of each length.
template <class By>
class RunSums {
 public:
  explicit RunSums(std::span<const GroupFindings> groups) : groups_(groups), means_(groups) {
    for (const GroupFindings& group : groups) {
      const std::vector<Parts>& found = deposits_.emplace_back(By::deposits(group));
      sums_.resize(found.size());
      for (std::size_t j = 0; j < sums_.size(); ++j) sums_[j] += found[j];
    }
  }

  std::size_t count() const { return sums_.size(); }

  const RunMeans& means() const { return means_; }
  Parts at(std::size_t bin) const { return in_units(means_.scaled(sums_[bin])); }
  // Without group g.
  Parts at(std::size_t bin, std::size_t g) const {
    return in_units(means_.without(g, sums_[bin], deposits_[g][bin]));
  }
  // Of paths of each length: `samples`, `chains` are what E and S are multiplied by.
  void add_lengths(std::map<int, std::vector<double>>& films, double samples, double chains) const {
    const auto add = [&films](const GroupFilm& film, double factor) {
      for (const auto& [vertices, values] : film.lengths().scaled(factor)) {
        auto& sum = films[vertices];
        sum.resize(values.size());
        for (std::size_t j = 0; j < values.size(); ++j) sum[j] += values[j];
      }
    };
    const auto bins = static_cast<double>(sums_.size());
    for (const GroupFindings& group : groups_) {
      add(group.parts.front().of_samples(), samples * bins / means_.samples());
      if (means_.mass() > 0)
        add(group.parts.front().of_chains(), chains * bins * group.scale / means_.mass());
    }
  }

 private:
  Parts in_units(const Parts& share) const { return Parts{}.add(share, By::unit(sums_.size())); }

  std::span<const GroupFindings> groups_;
  RunMeans means_;
  std::vector<Parts> sums_;                   // by bin, or length
  std::vector<std::vector<Parts>> deposits_;  // by group, and then the same
};

// The shares of runs of so many groups.
std::vector<RunShare> shares_of(std::span<const GroupFindings> groups,
                                std::span<const int> groups_of_runs) {
  double all = 0;
  for (const GroupFindings& group : groups) all += group.weight;
  std::vector<RunShare> shares;
  for (std::size_t first = 0; const int count : groups_of_runs) {
    shares.push_back(share_of_run(count, groups[first].weight, all));
    first += static_cast<std::size_t>(count);
  }
  return shares;
}

// All runs, and what becomes of them without one group.
template <class By>
class Pool {
 public:
  Pool(std::span<const GroupFindings> groups, std::span<const int> groups_of_runs,
       const Constant& constant)
      : constant_(constant), shares_(shares_of(groups, groups_of_runs)) {
    for (std::size_t first = 0; const int count : groups_of_runs) {
      runs_.emplace_back(groups.subspan(first, static_cast<std::size_t>(count)));
      first += static_cast<std::size_t>(count);
    }
    level_ = constant.b.value / mean().light(constant.b.value);
    for (std::size_t p = 0; p < runs_.size(); ++p)
      for (std::size_t g = 0; g < runs_[p].means().groups(); ++g) {
        const double b = constant.without[levels_.size()], pull = shares_[p].pull;
        Parts rest = mean();
        rest.add(runs_[p].means().mean_without(g), pull).add(runs_[p].means().mean(), -pull);
        levels_.push_back(b / rest.light(b));
      }
  }

  std::size_t count() const { return runs_.front().count(); }
  double level() const { return level_; }
  Parts mean() const {
    Parts sum;
    for (std::size_t p = 0; p < runs_.size(); ++p)
      sum.add(runs_[p].means().mean(), shares_[p].share);
    return sum;
  }
  // I_j; and the same without each group.
  double value(std::size_t bin, std::vector<double>& without) const {
    Parts all;
    for (std::size_t p = 0; p < runs_.size(); ++p) all.add(runs_[p].at(bin), shares_[p].share);
    without.clear();
    for (std::size_t p = 0; p < runs_.size(); ++p) {
      const Parts of_run = runs_[p].at(bin);
      for (std::size_t g = 0; g < runs_[p].means().groups(); ++g) {
        const std::size_t k = without.size();
        Parts rest = all;
        rest.add(runs_[p].at(bin, g), shares_[p].pull).add(of_run, -shares_[p].pull);
        without.push_back(levels_[k] * rest.light(constant_.without[k]));
      }
    }
    return level_ * all.light(constant_.b.value);
  }
  // s E_j
  double of_samples(std::size_t bin) const {
    double sum = 0;
    for (std::size_t p = 0; p < runs_.size(); ++p)
      sum += shares_[p].share * runs_[p].at(bin).of_samples;
    return level_ * sum;
  }
  std::map<int, std::vector<double>> by_length() const {
    std::map<int, std::vector<double>> films;
    for (std::size_t p = 0; p < runs_.size(); ++p)
      runs_[p].add_lengths(films, level_ * shares_[p].share,
                           level_ * shares_[p].share * constant_.b.value);
    return films;
  }

 private:
  const Constant& constant_;
  std::vector<RunSums<By>> runs_;
  std::vector<RunShare> shares_;  // by run
  double level_ = 1;              // s
  std::vector<double> levels_;    // without each group
};

}  // namespace

PooledFilm pooled_film(std::span<const GroupFindings> groups, std::span<const int> groups_of_runs,
                       const Constant& constant, std::vector<int> shape) {
  const Pool<ByBins> pool(groups, groups_of_runs, constant);
  const auto lit = std::ranges::count_if(groups, [](const auto& g) { return g.scale > 0; });
  const Jackknife jackknife(groups.size(), weights_of(groups));
  FilmEstimate film{.shape = std::move(shape)};
  std::vector<double> of_samples;
  FilmDegrees degrees(groups.size());
  std::vector<double> without;
  for (std::size_t j = 0; j < groups.front().film->bins(); ++j) {
    const double value = pool.value(j, without), error = jackknife.error(without);
    film.value.push_back(value);
    of_samples.push_back(pool.of_samples(j));
    film.standard_error.push_back(error);
    const double weight = degrees.add(value, error * error);
    for (std::size_t g = 0; g < groups.size(); ++g) degrees.move_bin(g, without[g] - value, weight);
  }
  degrees.tell(film);
  film.reliable = reliability_of_groups(film, static_cast<std::size_t>(lit));
  film.by_length = pool.by_length();
  return {std::move(film), pool.level() * pool.mean().of_samples / constant.b.value,
          std::move(of_samples)};
}

std::vector<LengthShare> pooled_lengths(std::span<const GroupFindings> groups,
                                        std::span<const int> groups_of_runs,
                                        const Constant& constant) {
  const Pool<ByLengths> pool(groups, groups_of_runs, constant);
  const Jackknife jackknife(groups.size(), weights_of(groups));
  std::vector<LengthShare> lengths;
  std::vector<double> without;
  for (std::size_t n = 0; n < pool.count(); ++n)
    if (const double value = pool.value(n, without); value > 0)
      lengths.push_back({{value, jackknife.error(without)}, static_cast<int>(n) + 2});
  return lengths;
}

Constant pooled_constant(std::span<const GroupFindings> groups,
                         std::span<const int> groups_of_runs) {
  double light = 0, squares = 0;
  for (const GroupFindings& group : groups) {
    light += group.parts.front().easy_light();
    squares += group.parts.front().easy_squares();
  }
  const std::vector<RunShare> shares = shares_of(groups, groups_of_runs);
  std::vector<RunMeans> runs;
  Parts mean;
  for (std::size_t first = 0; const int count : groups_of_runs) {
    runs.emplace_back(groups.subspan(first, static_cast<std::size_t>(count)));
    mean.add(runs.back().mean(), shares[runs.size() - 1].share);
    first += static_cast<std::size_t>(count);
  }
  const auto constant = [](const Parts& parts) { return parts.of_samples / (1 - parts.of_chains); };
  if (!(light > 0) || !(mean.of_chains < 1)) return {.failure = "samples carry no light"};
  Constant result{.b = {constant(mean), 0}, .effective_samples = light * light / squares};
  std::vector<double> deviations;
  for (std::size_t p = 0; p < runs.size(); ++p)
    for (std::size_t g = 0; g < runs[p].groups(); ++g) {
      Parts rest = mean;
      rest.add(runs[p].mean_without(g), shares[p].pull).add(runs[p].mean(), -shares[p].pull);
      result.without.push_back(constant(rest));
      deviations.push_back(std::pow(result.without.back() - result.b.value, 2));
    }
  result.b.standard_error = jackknife_error(result.without, weights_of(groups));
  result.degrees_of_freedom = jackknife_degrees(deviations);
  return result;
}

}  // namespace wander
