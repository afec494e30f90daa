// `run.json`, schema "wanderlight-run/1": the exact record of a run, and its way back.
// Numbers that are not finite are null, and read back as NaN.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "records/atomic_file.h"
#include "records/run_record.h"

namespace wander {

class JsonPlace;

inline constexpr const char* run_schema = "wanderlight-run/1";

nlohmann::ordered_json to_json(const RunRecord& run);
// The same with this for its film.
nlohmann::ordered_json to_json(const RunRecord& run, nlohmann::ordered_json film);
// As text, indented so far, which is never held as a whole: a film may have 10⁷ bins.  What is no
// UTF-8 is replaced.
void write_json(const RunRecord& run, int indent, const ByteSink& file);
// The "film" of a run; that of an image has no lists of values, which are in film.nc.
nlohmann::ordered_json to_json(const FilmEstimate& film, int dimension);
// The "provenance" of a run or comparison, and its way back; what is not known is left out.
nlohmann::ordered_json to_json(const Origin& origin);
Origin origin_from_json(const JsonPlace& document);

// A document that is not such a run throws RunFileError; `place` names it in the message.
RunRecord run_from_json(const JsonPlace& document, const std::string& place);
// Throws a std::exception if it is not a film.
FilmEstimate film_from_json(const JsonPlace& json);

// Reads run.json, the directory that holds it, a film.exr or a film.nc; none if the file is
// something else.  The film of an image comes from the film.nc beside its run.json; without that
// file it has no values.  Throws RunFileError if it is one of these but broken.
std::optional<RunRecord> find_run(const std::filesystem::path& path);
// The same without the film of an image, which may be large.
std::optional<RunRecord> find_run_alone(const std::filesystem::path& path);
// The same where a run is required: RunFileError if there is none.
RunRecord read_run(const std::filesystem::path& path);

}  // namespace wander
