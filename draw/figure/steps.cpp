#include "draw/figure/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace wander::figure {
namespace {

std::string_view word(const std::vector<std::string>& words, std::int32_t index) {
  if (index < 0 || static_cast<std::size_t>(index) >= words.size()) return "none";
  return words[static_cast<std::size_t>(index)];
}

}  // namespace

Steps::Steps(const Trajectory& trajectory, const StepFilter& filter, Projection projection)
    : trajectory_(&trajectory),
      filter_(filter),
      projection_(std::move(projection)),
      chains_(filter.chains),
      first_(std::clamp(filter.first, 0, trajectory.draws)),
      end_(std::clamp(filter.end, first_, trajectory.draws)) {
  if (!chains_.empty()) return;
  chains_.resize(static_cast<std::size_t>(trajectory.chains));
  std::iota(chains_.begin(), chains_.end(), 0);
}

bool Steps::is_chosen(const Step& step) const {
  const Trajectory& t = *trajectory_;
  if (filter_.mutation && t.mutation[step.index] != *filter_.mutation) return false;
  if (!filter_.path_class) return true;
  const auto from = before(step);
  return t.state.path_class[step.index] == *filter_.path_class ||
         t.proposed.path_class[step.index] == *filter_.path_class ||
         (from && from->path_class() == *filter_.path_class);
}

std::string_view Steps::mutation(const Step& step) const {
  return word(trajectory_->mutations, trajectory_->mutation[step.index]);
}

std::string_view Steps::reason(const Step& step) const {
  return word(trajectory_->reasons, trajectory_->reason[step.index]);
}

std::optional<Steps::State> Steps::before(const Step& step) const {
  const Trajectory& t = *trajectory_;
  if (!accepted(step)) return State{&t.state, step.index};
  if (step.draw == 0 && !t.start.vertices.empty())
    return State{&t.start, static_cast<std::size_t>(step.chain)};
  if (step.draw == 0 || t.every != 1) return std::nullopt;
  return State{&t.state, step.index - 1};
}

std::vector<Vector> Steps::drawn(std::span<const double> coordinates) const {
  if (projection_) return projection_(coordinates);
  const auto axes = static_cast<std::size_t>(trajectory_->dimension);
  std::vector<Vector> line;
  for (std::size_t at = 0; at + axes <= coordinates.size(); at += axes) {
    const Vector v{coordinates[at], coordinates[at + 1]};
    if (std::isfinite(v.x) && std::isfinite(v.y)) line.push_back(v);
  }
  return line;
}

std::vector<std::vector<Vector>> Steps::attempt(const Step& step) const {
  const RecordedAttempts& attempts = trajectory_->attempts;
  const auto axes = static_cast<std::size_t>(trajectory_->dimension);
  const auto points = static_cast<std::size_t>(attempts.max_points);
  const std::span<const double> all =
      std::span(attempts.position).subspan(step.index * points * axes, points * axes);
  const auto is_point = [&](std::size_t k) {
    return std::ranges::all_of(all.subspan(k * axes, axes),
                               [](double x) { return std::isfinite(x); });
  };
  std::vector<std::vector<Vector>> lines;
  for (std::size_t first = 0; first < points;) {
    std::size_t end = first;
    while (end < points && is_point(end)) ++end;
    if (end > first) lines.push_back(drawn(all.subspan(first * axes, (end - first) * axes)));
    first = end + 1;
  }
  return lines;
}

std::optional<Vector> Steps::failure(const Step& step) const {
  const auto& column = trajectory_->attempts.failure;
  const auto axes = static_cast<std::size_t>(trajectory_->dimension);
  if ((step.index + 1) * axes > column.size()) return std::nullopt;
  const std::vector<Vector> spot = drawn(std::span(column).subspan(step.index * axes, axes));
  if (spot.empty()) return std::nullopt;
  return spot.front();
}

std::vector<Vector> Steps::path(const RecordedPaths& paths, std::size_t index) const {
  const int count = std::clamp(paths.vertices[index], 0, trajectory_->max_vertices);
  const auto axes = static_cast<std::size_t>(trajectory_->dimension);
  return drawn(std::span(paths.position)
                   .subspan(index * static_cast<std::size_t>(trajectory_->max_vertices) * axes,
                            static_cast<std::size_t>(count) * axes));
}

std::string_view Steps::path_class(const RecordedPaths& paths, std::size_t index) const {
  return word(trajectory_->classes, paths.path_class[index]);
}

std::string in_words(const Steps& steps) {
  const Trajectory& t = steps.trajectory();
  const StepFilter& filter = steps.filter();
  const auto chains = steps.chains();
  std::string text = chains.size() == 1 ? fmt::format("chain {}", chains.front())
                                        : fmt::format("{} chains", chains.size());
  if (steps.draws() == 0) return text + ", no draws";
  text += fmt::format(", draws {} to {}", steps.number(steps.first()),
                      steps.number(steps.first() + steps.draws() - 1));
  if (filter.mutation) text += fmt::format(", mutation {}", word(t.mutations, *filter.mutation));
  if (filter.path_class) text += fmt::format(", class {}", word(t.classes, *filter.path_class));
  return text;
}

}  // namespace wander::figure
