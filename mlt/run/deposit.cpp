#include "mlt/run/deposit.h"

#include <cmath>
#include <limits>

#include "mlt/run/reliability.h"

namespace wander {

namespace {

int number_of_bins(const std::vector<int>& resolution) {
  int n = 1;
  for (const int r : resolution) n *= r;
  return n;
}

}  // namespace

std::vector<double> GroupFilm::by_length() const {
  return lengths_.keeps_any() ? lengths_.by_length() : values(by_length_);
}

GroupsFilm::GroupsFilm(std::vector<int> resolution)
    : resolution_(std::move(resolution)),
      mean_(static_cast<std::size_t>(number_of_bins(resolution_))),
      squares_(mean_.size()) {}

void GroupsFilm::add(const GroupFilm& film, double b, std::uint64_t steps) {
  const double scale = b * static_cast<double>(film.bins()) / static_cast<double>(steps);
  const std::vector<double> weights = film.weights();
  ++groups_;
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    const double value = scale * weights[i], delta = value - mean_[i];
    mean_[i] += delta / groups_;
    squares_[i] += delta * (value - mean_[i]);
  }
  for (const auto& [vertices, values] : film.lengths().scaled(scale)) {
    auto& sum = lengths_[vertices];
    sum.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
  }
}

void GroupsFilm::add_dark_group() {
  ++groups_;
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    const double delta = -mean_[i];
    mean_[i] += delta / groups_;
    squares_[i] += delta * (0 - mean_[i]);
  }
}

FilmEstimate GroupsFilm::estimate() const {
  FilmEstimate film{.shape = resolution_, .value = mean_};
  film.degrees_of_freedom = film.degrees_of_error = std::max(0, groups_ - 1);
  const double pairs = static_cast<double>(groups_) * (groups_ - 1);
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    const double variance = squares_[i] / pairs;
    film.standard_error.push_back(groups_ > 1 ? std::sqrt(variance)
                                              : std::numeric_limits<double>::quiet_NaN());
  }
  film.reliable = reliability_of_groups(film, static_cast<std::size_t>(groups_));
  film.by_length = lengths_;
  for (auto& [vertices, values] : film.by_length)
    for (double& value : values) value /= groups_;
  return film;
}

}  // namespace wander
