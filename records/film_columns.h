// The lists of a film in a run.json, taken out of the document while it is read: of 10⁷ bins it
// would be larger than the film many times over.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "records/key_limit.h"
#include "records/rendering.h"

namespace wander {

// Throws std::runtime_error unless what samples carry of a film has as many numbers as it, or none.
void require_parts_of(const Rendering& rendering);

class FilmColumns {
 public:
  // The document, in which the lists are empty; discarded if it is none.
  nlohmann::ordered_json read(const std::filesystem::path& path);
  // Into films that have none.  Throws std::runtime_error if they differ in length.
  void move_to(Rendering& rendering);

 private:
  // False if it was taken out.
  bool stays(int depth, nlohmann::ordered_json::parse_event_t event,
             const nlohmann::ordered_json& parsed);

  struct Lists {
    std::vector<double> value{}, standard_error{};
    std::vector<bool> reliable{};
  };
  static bool take(Lists& lists, const std::string& name, const nlohmann::ordered_json& parsed);

  std::vector<std::string> place_;  // the keys on the way to what is being read
  KeyLimit limit_;
  Lists film_, chains_, samples_;
};

}  // namespace wander
