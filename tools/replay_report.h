// One replayed step for people, as a table of every factor, and for programs, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lab/replay.h"

namespace wander {

std::string text_of_replay(const Replay& replay);
nlohmann::ordered_json json_of_replay(const Replay& replay);

}  // namespace wander
