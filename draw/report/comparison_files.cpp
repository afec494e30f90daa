#include "draw/report/comparison_files.h"

#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <vector>

#include "core/image_shape.h"
#include "draw/report/report.h"
#include "lab/compare/comparison_csv.h"
#include "lab/compare/comparison_json.h"
#include "lab/compare/film_files.h"
#include "lab/compare/film_loan.h"
#include "lab/compare/kept_comparison.h"
#include "lab/reference_name.h"
#include "records/atomic_file.h"
#include "records/exr.h"
#include "records/run_files.h"
#include "records/run_json.h"

namespace wander::compare {

namespace fs = std::filesystem;

namespace {

constexpr const char *reference_of_rows = "reference.json", *table = "compare.csv",
                     *report = "report.html", *document = "compare.json";

// All that is known of the run that stands for a cell.
Rendering rendering_of(const Runs& runs, const Run& run) {
  if (run.contender < runs.details.size())
    if (const Rendering& details = runs.details[run.contender];
        details.samples > 0 && details.seed == run.seed && run.budget + 1 == runs.budgets.size())
      return details;
  return {.method = runs.contenders[run.contender].method,
          .samples = run.samples,
          .seed = run.seed,
          .seconds = run.seconds,
          .processor_seconds = run.processor_seconds,
          .seed_seconds = run.seed_seconds,
          .film = film_of(runs, run)};
}

class Files {
 public:
  explicit Files(const fs::path& directory) : directory_(directory) {}

  void stage(const std::string& name, const std::string& bytes) {
    files_.emplace_back(directory_ / name, bytes);
    names_.insert(directory_ / name);
  }
  void commit() { StagedFile::commit_together(files_); }
  // Of a former comparison.
  void remove_others() const {
    std::error_code absent;
    if (!names_.contains(directory_ / reference_of_rows))
      fs::remove(directory_ / reference_of_rows, absent);
    for (const auto& file : fs::directory_iterator(directory_ / films_folder, absent))
      if (file.path().extension() == ".exr" && !names_.contains(file.path()))
        fs::remove(file.path(), absent);
    fs::remove(directory_ / films_folder, absent);  // if it is empty
  }

 private:
  fs::path directory_;
  std::vector<StagedFile> files_;
  std::set<fs::path> names_;
};

void stage_images(const Runs& runs, Files& files) {
  files.stage(reference_image, to_exr(reference_record(runs)));
  for (std::size_t c = 0; c < runs.contenders.size(); ++c)
    for (std::size_t b = 0; b < runs.budgets.size(); ++b)
      if (const Run* run = shown_run(runs, c, b)) {
        Provenance provenance = runs.provenance;
        provenance.command_line = run->command;
        files.stage(film_file(runs, c, b), to_exr({rendering_of(runs, *run), provenance}));
      }
}

}  // namespace

RunRecord reference_record(const Runs& runs) {
  RunRecord record{.rendering = {.complete = runs.complete,
                                 .method = reference_method_word,
                                 .seed = 0,
                                 .threads = 0,
                                 .max_vertices = runs.reference.max_vertices,
                                 .film = runs.reference.film},
                   .provenance = runs.provenance};
  record.rendering.warnings = {runs.reference.origin};
  return record;
}

bool holds_comparison(const fs::path& directory) {
  return holds_document(directory / document, comparison_schema);
}

void remove_comparison(const fs::path& directory) {
  std::error_code absent;
  if (holds_kept_comparison(directory)) fs::remove_all(kept_in(directory), absent);
  if (!holds_comparison(directory)) return;
  Files(directory).remove_others();
  for (const char* name : {table, report, document}) fs::remove(directory / name, absent);
}

void write_comparison(const Comparison& comparison, const description::Scene& scene,
                      const fs::path& directory) {
  const Runs& runs = comparison.runs;
  const bool images = is_image(runs.reference.film.shape);
  if (images) fs::create_directory(directory / films_folder);
  Files files(directory);
  if (images)
    stage_images(runs, files);
  else
    files.stage(reference_of_rows, to_json(reference_record(runs)).dump(1) + "\n");
  files.stage(table, to_csv(comparison));
  files.stage(report, report_html(comparison, scene));
  files.stage(document, to_json(comparison).dump(1) + "\n");
  files.commit();
  files.remove_others();
}

}  // namespace wander::compare
