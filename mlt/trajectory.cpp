#include "mlt/trajectory.h"

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

// Fills the columns draw by draw, reading each log from its beginning.
class Columns {
 public:
  explicit Columns(Trajectory& trajectory) : t_(trajectory), classes_(trajectory.classes) {}

  void add(const StepLog& log, int draws) {
    std::size_t vertex = 0;  // of the log, that comes next
    for (int d = 0; d < draws; ++d) {
      const LoggedStep& step = log.steps()[static_cast<std::size_t>(d)];
      add_scalars(step);
      const std::size_t proposed = vertex;
      vertex += static_cast<std::size_t>(step.proposed_vertices);
      const std::size_t state = step.accepted() ? proposed : vertex;
      if (!step.accepted()) vertex += static_cast<std::size_t>(step.state_vertices);
      add_path(t_.proposed, log, proposed, step.proposed_vertices, step.proposed_film);
      add_path(t_.state, log, state, step.state_vertices, step.state_film);
    }
  }

 private:
  void add_scalars(const LoggedStep& step) {
    t_.mutation.push_back(step.mutation);
    t_.reason.push_back(step.reason);
    t_.accepted.push_back(step.accepted() ? 1 : 0);
    t_.acceptance.push_back(step.acceptance);
    t_.log_f.push_back(step.log_f);
    t_.log_f_current.push_back(step.log_f_current);
    t_.log_f_proposed.push_back(step.log_f_proposed);
    t_.log_forward.push_back(step.log_forward);
    t_.log_reverse.push_back(step.log_reverse);
  }

  void add_path(RecordedPaths& paths, const StepLog& log, std::size_t first, int count,
                const std::array<double, 2>& film) {
    const auto vertices = static_cast<std::size_t>(count);
    const auto axes = static_cast<std::size_t>(t_.dimension);
    const auto begin = log.positions().begin() + static_cast<std::ptrdiff_t>(first * axes);
    paths.position.insert(paths.position.end(), begin,
                          begin + static_cast<std::ptrdiff_t>(vertices * axes));
    paths.position.resize(
        paths.position.size() + (static_cast<std::size_t>(t_.max_vertices) - vertices) * axes,
        LoggedStep::none);
    paths.film.insert(paths.film.end(), film.begin(), film.begin() + t_.dimension - 1);
    paths.vertices.push_back(count);
    paths.path_class.push_back(
        count == 0 ? -1 : classes_.id(std::span(log.events()).subspan(first, vertices)));
  }

  Trajectory& t_;
  ClassTable classes_;
};

int longest_path(const StepLog& log, int draws) {
  int longest = 0;
  for (int d = 0; d < draws; ++d) {
    const LoggedStep& step = log.steps()[static_cast<std::size_t>(d)];
    longest = std::max({longest, step.state_vertices, step.proposed_vertices});
  }
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
  for (const StepLog& log : chains)
    t.max_vertices = std::max(t.max_vertices, longest_path(log, t.draws));
  reserve(t);
  Columns columns(t);
  for (const StepLog& log : chains) columns.add(log, t.draws);
  return t;
}

}  // namespace wander
