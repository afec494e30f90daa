#include "records/trajectory_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "records/trajectory_layout.h"

namespace wander {

namespace {

class CsvText {
 public:
  void add(double x) { fmt::format_to(end(), "{},", std::isnan(x) ? std::abs(x) : x); }
  void add(std::int64_t x) { fmt::format_to(end(), "{},", x); }
  void add(const std::string& word) { fmt::format_to(end(), "{},", word); }
  void end_row() { text_.back() = '\n'; }
  std::string take() { return std::move(text_); }

 private:
  std::back_insert_iterator<std::string> end() { return std::back_inserter(text_); }
  std::string text_;
};

void add_header(CsvText& csv, const Trajectory& t) {
  for (const char* name :
       {"chain", "draw", "mutation", "accepted", "acceptance_rate", "reason", "diverging", "lp",
        "log_f", "log_f_current", "log_f_proposed", "log_forward", "log_reverse"})
    csv.add(std::string(name));
  for (const std::string prefix : {"", "proposed_"}) {
    csv.add(prefix + "n_vertices");
    csv.add(prefix + "path_class");
    for (const std::string& name : film_names(t.dimension)) csv.add(prefix + name);
  }
  csv.end_row();
}

void add_path(CsvText& csv, const Trajectory& t, const RecordedPaths& paths, std::size_t i) {
  const auto axes = static_cast<std::size_t>(t.dimension) - 1;
  const std::int32_t id = paths.path_class[i];
  csv.add(std::int64_t{paths.vertices[i]});
  csv.add(id < 0 ? std::string() : t.classes[static_cast<std::size_t>(id)]);
  for (std::size_t k = 0; k < axes; ++k) csv.add(paths.film[i * axes + k]);
}

void add_row(CsvText& csv, const Trajectory& t, std::size_t i) {
  const auto draws = static_cast<std::size_t>(t.draws);
  const std::string& reason = t.reasons[static_cast<std::size_t>(t.reason[i])];
  csv.add(static_cast<std::int64_t>(i / draws));
  csv.add(static_cast<std::int64_t>(t.first_step + i % draws * t.every));
  csv.add(t.mutations[static_cast<std::size_t>(t.mutation[i])]);
  csv.add(std::int64_t{t.accepted[i]});
  csv.add(t.acceptance[i]);
  csv.add(reason);
  csv.add(std::int64_t{reason == "solver_failed" ? 1 : 0});
  csv.add(t.log_f[i]);
  csv.add(t.log_f[i]);
  csv.add(t.log_f_current[i]);
  csv.add(t.log_f_proposed[i]);
  csv.add(t.log_forward[i]);
  csv.add(t.log_reverse[i]);
  add_path(csv, t, t.state, i);
  add_path(csv, t, t.proposed, i);
  csv.end_row();
}

}  // namespace

std::string to_csv(const Trajectory& trajectory) {
  CsvText csv;
  add_header(csv, trajectory);
  for (std::size_t i = 0; i < trajectory.size(); ++i) add_row(csv, trajectory, i);
  return csv.take();
}

}  // namespace wander
