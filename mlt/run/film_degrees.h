// How many degrees of freedom there are in a film whose errors are what its groups differ by: those of the error of all bins
// together, which few bright ones may decide, and those of the intervals of bins on average, where all that may be reliable by
// their own claim (core/reliability.h) count alike.  (Of a bin alone they would hardly be known.)
//
// With v_g what group g moves the film by, squared and summed over bins, (Σ v_g)² / Σ v_g² - 1 (statistics/jackknife.h); for
// intervals each bin in units of its own variance.  What samples of their own know of a bin has as many as there are samples, so
// that of a sum of both variances the groups' part counts [Satterthwaite 1946].
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/film_estimate.h"
#include "core/reliability.h"
#include "statistics/jackknife.h"

namespace wander {

class FilmDegrees {
 public:
  explicit FilmDegrees(std::size_t groups)
      : film_{std::vector<double>(groups)}, bins_{std::vector<double>(groups)} {}

  // A bin, by the variances that it has of groups and of samples, in squares of the unit of its value.  Returns its weight
  // among intervals.
  double add(double value, double of_groups, double of_samples = 0) {
    const double all = of_groups + of_samples;
    const bool is_known = all > 0 && value > 0 && value / all * value >= fewest_claimed_events;
    const double weight = is_known ? 1 / all : 0;
    film_.add(of_groups, of_samples);
    bins_.add(weight * of_groups, weight * of_samples);
    return weight;
  }
  // How far bins are off without a group: Σ d², and with the weights of the bins.
  void move(std::size_t group, double squares, double weighted) {
    film_.moved[group] += squares;
    bins_.moved[group] += weighted;
  }
  void move_bin(std::size_t group, double deviation, double weight) {
    move(group, deviation * deviation, weight > 0 ? weight * deviation * deviation : 0);
  }

  void tell(FilmEstimate& film) const {
    film.degrees_of_error = film_.degrees();
    film.degrees_of_freedom = bins_.variance > 0 ? bins_.degrees() : film.degrees_of_error;
  }

 private:
  struct Moved {
    std::vector<double> moved{};  // by group
    double variance = 0, of_samples = 0;

    void add(double of_groups, double samples) {
      variance += of_groups;
      of_samples += samples;
    }
    double degrees() const {
      constexpr double most = 1e6;
      const double ratio = variance > 0 ? 1 + of_samples / variance : 1;
      return std::min(jackknife_degrees(moved) * ratio * ratio, most);
    }
  };

  Moved film_, bins_;
};

}  // namespace wander
