#include "records/trajectory_of_logs.h"

#include <algorithm>
#include <map>

namespace wander {

namespace {

class ClassTable {
 public:
  explicit ClassTable(std::vector<std::string>& names) : names_(names) {}

  std::int32_t id(std::span<const Event> events) {
    word_.clear();
    for (const Event event : events) word_ += letter(event);
    const auto [found, is_new] = ids_.emplace(word_, static_cast<std::int32_t>(names_.size()));
    if (is_new) names_.push_back(word_);
    return found->second;
  }

 private:
  std::vector<std::string>& names_;
  std::map<std::string, std::int32_t> ids_;
  std::string word_;
};

// Fills the columns draw by draw.
class Columns {
 public:
  explicit Columns(Trajectory& trajectory) : t_(trajectory), classes_(trajectory.classes) {}

  void add(const StepLog& log, int draws) {
    LoggedPath last;  // state, of class `last_id`
    std::int32_t last_id = no_class;
    add_path(t_.start, log, log.start(), class_of(log, log.start()));
    for (const LoggedStep& step : std::span(log.steps()).first(static_cast<std::size_t>(draws))) {
      add_scalars(step);
      const bool moved = step.state.first != last.first || last_id == no_class;
      if (moved) last_id = class_of(log, step.state);
      last = step.state;
      add_path(t_.state, log, step.state, last_id);
      add_path(t_.proposed, log, step.proposed,
               step.accepted() ? last_id : class_of(log, step.proposed));
      add_attempt(log, step.attempt);
    }
  }

 private:
  static constexpr std::int32_t no_class = -1;

  std::int32_t class_of(const StepLog& log, const LoggedPath& path) {
    if (path.vertices == 0) return no_class;
    return classes_.id(
        std::span(log.events()).subspan(path.first, static_cast<std::size_t>(path.vertices)));
  }

  void add_scalars(const LoggedStep& step) {
    t_.mutation.push_back(step.mutation);
    t_.reason.push_back(step.reason);
    t_.accepted.push_back(step.accepted() ? 1 : 0);
    t_.acceptance.push_back(step.acceptance);
    t_.log_f.push_back(step.state.log_f);
    t_.log_f_current.push_back(step.log_f_current);
    t_.log_f_proposed.push_back(step.proposed.log_f);
    t_.log_forward.push_back(step.log_forward);
    t_.log_reverse.push_back(step.log_reverse);
  }

  void add_path(RecordedPaths& paths, const StepLog& log, const LoggedPath& path,
                std::int32_t path_class) {
    const auto axes = static_cast<std::size_t>(t_.dimension);
    const auto vertices = static_cast<std::size_t>(path.vertices);
    const auto positions = std::span(log.positions()).subspan(path.first * axes, vertices * axes);
    paths.position.insert(paths.position.end(), positions.begin(), positions.end());
    paths.position.insert(paths.position.end(),
                          (static_cast<std::size_t>(t_.max_vertices) - vertices) * axes,
                          LoggedPath::no_number);
    paths.film.insert(paths.film.end(), path.film.begin(), path.film.begin() + t_.dimension - 1);
    paths.vertices.push_back(path.vertices);
    paths.path_class.push_back(path_class);
  }

  void add_attempt(const StepLog& log, const LoggedAttempt& attempt) {
    const auto axes = static_cast<std::size_t>(t_.dimension);
    const auto add = [&](std::vector<double>& column, const Attempt::Point& point) {
      column.insert(column.end(), point.begin(), point.begin() + static_cast<std::ptrdiff_t>(axes));
    };
    for (int k = 0; k < t_.attempts.max_points; ++k)
      add(t_.attempts.position, k < attempt.points
                                    ? log.attempts()[attempt.first + static_cast<std::size_t>(k)]
                                    : Attempt::nowhere);
    add(t_.attempts.failure, attempt.failure);
  }

  Trajectory& t_;
  ClassTable classes_;
};

int longest_path(const StepLog& log, int draws) {
  int longest = log.start().vertices;
  for (int d = 0; d < draws; ++d) {
    const LoggedStep& step = log.steps()[static_cast<std::size_t>(d)];
    longest = std::max({longest, step.state.vertices, step.proposed.vertices});
  }
  return longest;
}

int longest_attempt(const StepLog& log, int draws) {
  int longest = 0;
  for (int d = 0; d < draws; ++d)
    longest = std::max(longest, log.steps()[static_cast<std::size_t>(d)].attempt.points);
  return longest;
}

void reserve(Trajectory& t) {
  const std::size_t size = t.size(), axes = static_cast<std::size_t>(t.dimension);
  for (RecordedPaths* paths : {&t.state, &t.proposed}) {
    paths->position.reserve(size * static_cast<std::size_t>(t.max_vertices) * axes);
    paths->film.reserve(size * (axes - 1));
    paths->vertices.reserve(size);
    paths->path_class.reserve(size);
  }
  for (auto* column : {&t.mutation, &t.reason}) column->reserve(size);
  for (auto* column : {&t.acceptance, &t.log_f, &t.log_f_current, &t.log_f_proposed, &t.log_forward,
                       &t.log_reverse})
    column->reserve(size);
  t.accepted.reserve(size);
  t.attempts.position.reserve(size * static_cast<std::size_t>(t.attempts.max_points) * axes);
  t.attempts.failure.reserve(size * axes);
}

}  // namespace

Trajectory make_trajectory(std::span<const StepLog> chains, const TraceWindow& window,
                           int dimension, std::span<const std::string_view> mutations) {
  Trajectory t;
  t.dimension = dimension;
  t.chains = static_cast<int>(chains.size());
  t.first_step = window.first;
  t.every = window.every;
  t.mutations.assign(mutations.begin(), mutations.end());
  t.reasons.assign(reason_names.begin(), reason_names.end());
  std::size_t draws = chains.empty() ? 0 : chains.front().steps().size();
  for (const StepLog& log : chains) draws = std::min(draws, log.steps().size());
  t.draws = static_cast<int>(draws);
  for (const StepLog& log : chains) {
    t.max_vertices = std::max(t.max_vertices, longest_path(log, t.draws));
    t.attempts.max_points = std::max(t.attempts.max_points, longest_attempt(log, t.draws));
  }
  t.attempts.max_points = std::max(1, t.attempts.max_points);
  reserve(t);
  Columns columns(t);
  for (const StepLog& log : chains) columns.add(log, t.draws);
  return t;
}

}  // namespace wander
