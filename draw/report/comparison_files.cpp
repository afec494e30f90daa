#include "draw/report/comparison_files.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "draw/report/report.h"
#include "lab/compare/comparison_csv.h"
#include "lab/compare/comparison_json.h"
#include "lab/reference_name.h"
#include "records/atomic_file.h"
#include "records/run_files.h"
#include "records/run_json.h"

namespace wander::compare {

RunRecord reference_record(const Runs& runs) {
  RunRecord record{.rendering = {.complete = runs.complete,
                                 .method = reference_method_word,
                                 .seed = 0,
                                 .threads = 0,
                                 .film = runs.reference.film},
                   .provenance = runs.provenance};
  record.rendering.warnings = {runs.reference.origin};
  return record;
}

bool holds_comparison(const std::filesystem::path& directory) {
  return holds_document(directory / "compare.json", comparison_schema);
}

void write_comparison(const Comparison& comparison, const std::filesystem::path& directory) {
  std::vector<StagedFile> files;
  const auto stage = [&](const char* name, const std::string& bytes) {
    files.emplace_back(directory / name, bytes);
  };
  stage("reference.json", to_json(reference_record(comparison.runs)).dump(1) + "\n");
  stage("compare.csv", to_csv(comparison));
  stage("report.html", report_html(comparison));
  stage("compare.json", to_json(comparison).dump(1) + "\n");
  for (StagedFile& file : files) file.commit();
}

}  // namespace wander::compare
