#include "records/run_files.h"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "records/atomic_file.h"
#include "records/csv.h"
#include "records/exr.h"
#include "records/film_netcdf.h"
#include "records/run_json.h"
#include "records/tone.h"

namespace wander {

namespace {

constexpr std::array of_rows{"film.csv"};
constexpr std::array of_images{"film.nc", "film.png"};

bool is_image(const FilmEstimate& film) { return film.shape.size() > 1; }

void stage_image(const RunRecord& run, double exposure, const std::filesystem::path& directory,
                 std::vector<StagedFile>& files) {
  files.emplace_back(directory / "film.nc",
                     [&](const ByteSink& file) { write_film_netcdf(run, file); });
  files.emplace_back(directory / "film.png", film_png(run.rendering.film, exposure));
}

void stage_row(const RunRecord& run, const description::Scene& scene,
               const std::filesystem::path& directory, std::vector<StagedFile>& files) {
  files.emplace_back(directory / "film.csv", [&](const ByteSink& file) {
    write_csv(run.rendering.film, bin_centers(scene), file);
  });
}

void remove_others(const std::filesystem::path& directory, std::span<const char* const> names) {
  std::error_code absent;
  for (const char* name : names) std::filesystem::remove(directory / name, absent);
}

}  // namespace

void write_run(const RunRecord& run, const description::Scene& scene,
               const std::filesystem::path& directory, double exposure) {
  const bool image = is_image(run.rendering.film);
  std::vector<StagedFile> files;
  files.emplace_back(directory / "film.exr", to_exr(run));
  if (image)
    stage_image(run, exposure, directory, files);
  else
    stage_row(run, scene, directory, files);
  files.emplace_back(directory / "run.json",
                     [&](const ByteSink& file) { write_json(run, 1, file); });
  StagedFile::commit_together(files);
  if (image)
    remove_others(directory, of_rows);
  else
    remove_others(directory, of_images);
}

void remove_run(const std::filesystem::path& directory) {
  if (!holds_run(directory)) return;
  remove_others(directory, of_rows);
  remove_others(directory, of_images);
  remove_others(directory, std::array{"film.exr", "run.json"});
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
