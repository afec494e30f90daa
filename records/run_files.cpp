#include "records/run_files.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "records/atomic_file.h"
#include "records/csv.h"
#include "records/exr.h"
#include "records/run_json.h"

namespace wander {

void write_run(const RunRecord& run, const description::Scene& scene,
               const std::filesystem::path& directory) {
  std::vector<StagedFile> files;
  files.emplace_back(directory / "film.exr", to_exr(run));
  if (run.rendering.film.shape.size() == 1)
    files.emplace_back(directory / "film.csv", [&](const ByteSink& file) {
      write_csv(run.rendering.film, bin_centers(scene), file);
    });
  files.emplace_back(directory / "run.json",
                     [&](const ByteSink& file) { write_json(run, 1, file); });
  for (StagedFile& file : files) file.commit();
}

bool holds_document(const std::filesystem::path& path, std::string_view schema) {
  // The schema is the first entry of the document.
  std::string beginning(64, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  const std::size_t key = beginning.find("\"schema\"");
  return key != std::string::npos && beginning.find(schema, key) != std::string::npos;
}

bool holds_run(const std::filesystem::path& directory) {
  return holds_document(directory / "run.json", run_schema);
}

}  // namespace wander
