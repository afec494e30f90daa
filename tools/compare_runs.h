// The runs of a comparison, from its reference to the last replicate; whoever asks for them says who
// listens.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "lab/compare/forecast.h"
#include "tools/compare_task.h"
#include "work/session.h"

namespace wander::compare {

struct CompareHost {
  Session session;  // threads, interruption and report; the plan has the rest
  std::function<void(const Forecast&)> announce;
  std::string command_line;
};

// What is kept of them stands in the directory, if there is one.  Throws CommandFailure where all of
// them fail, and RunFileError.
Runs runs_of(CompareTask& task, const CompareOptions& options, const CompareHost& host,
             const std::optional<std::filesystem::path>& directory);

}  // namespace wander::compare
