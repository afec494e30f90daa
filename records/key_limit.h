// An object of ordered_json looks through all its keys to take one more.  No record has nearly as many
// keys as this lets an object have; those after them are left out, so that any file is read in linear time.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace wander {

class KeyLimit {
 public:
  static constexpr std::size_t most = 4'000;

  // For a callback of the parser, at each of its events: false where a key is one too many.
  bool keeps(int depth, nlohmann::ordered_json::parse_event_t event) {
    using Event = nlohmann::ordered_json::parse_event_t;
    const auto level = static_cast<std::size_t>(depth);
    if (event == Event::object_start) keys_.resize(level);
    if (event != Event::key) return true;
    keys_.resize(level);
    return ++keys_.back() <= most;
  }

 private:
  std::vector<std::size_t> keys_;  // so far, of each object on the way
};

}  // namespace wander
