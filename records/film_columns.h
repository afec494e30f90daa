// The lists of a film in a run.json, taken out of the document while it is read: of 10⁷ bins it
// would be larger than the film many times over.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

class FilmColumns {
 public:
  // The document, in which the lists are empty; discarded if it is none.
  nlohmann::ordered_json read(const std::filesystem::path& path);
  // Into a film that has none.  Throws std::runtime_error if they differ in length.
  void move_to(FilmEstimate& film);

 private:
  // False if it was taken out.
  bool stays(int depth, nlohmann::ordered_json::parse_event_t event,
             const nlohmann::ordered_json& parsed);

  std::string part_, list_;  // the member of the document, and its member, that are being read
  std::vector<double> value_, standard_error_;
  std::vector<bool> reliable_;
};

}  // namespace wander
