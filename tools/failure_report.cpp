#include "tools/failure_report.h"

#include <algorithm>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lab/failure.h"
#include "mlt/seeds/nothing_found.h"
#include "records/atomic_file.h"
#include "records/run_record.h"
#include "scenes/format/scene_file.h"
#include "scenes/import/import_fault.h"
#include "tools/console.h"
#include "tools/examination.h"

namespace wander {

namespace {

struct Told {
  ExitCode code;
  std::string message;
  nlohmann::ordered_json faults;  // of a scene; the message has their places
};

ExitCode exit_code_of(const std::exception& problem) {
  if (const auto* failure = dynamic_cast<const CommandFailure*>(&problem)) return failure->code();
  if (dynamic_cast<const SceneFileError*>(&problem) != nullptr) return ExitCode::invalid_input;
  if (dynamic_cast<const ImportError*>(&problem) != nullptr) return ExitCode::invalid_input;
  if (dynamic_cast<const RunFileError*>(&problem) != nullptr) return ExitCode::invalid_input;
  if (dynamic_cast<const NothingComputed*>(&problem) != nullptr) return ExitCode::interrupted;
  return ExitCode::failure;
}

std::string message_of(const std::exception& problem) {
  if (dynamic_cast<const std::bad_alloc*>(&problem) != nullptr) return "out of memory";
  return problem.what();
}

Told told(const std::exception& problem) {
  Told told{exit_code_of(problem), message_of(problem), nlohmann::ordered_json::array()};
  if (const auto* invalid = dynamic_cast<const SceneFileError*>(&problem))
    for (const Fault& fault : invalid->faults)
      told.faults.push_back({{"line", fault.line},
                             {"column", fault.column},
                             {"pointer", fault.pointer},
                             {"what", fault.what}});
  if (const auto* invalid = dynamic_cast<const ImportError*>(&problem))
    for (const ImportFault& fault : invalid->faults)
      told.faults.push_back({{"file", fault.file},
                             {"line", fault.line},
                             {"column", fault.column},
                             {"path", fault.path},
                             {"what", fault.what}});
  return told;
}

// Each message once: contenders of a comparison may be refused in the same words.
std::vector<Told> all_told(const std::exception& problem) {
  const auto* several = dynamic_cast<const Failures*>(&problem);
  if (several == nullptr) return {told(problem)};
  std::vector<Told> all;
  for (const std::exception_ptr& found : several->found) {
    try {
      std::rethrow_exception(found);
    } catch (const std::exception& one) {
      Told next = told(one);
      if (std::ranges::find(all, next.message, &Told::message) == all.end())
        all.push_back(std::move(next));
    }
  }
  return all;
}

ExitCode exit_code_of(const std::vector<Told>& all) {
  const bool usage =
      std::ranges::any_of(all, [](const Told& one) { return one.code == ExitCode::usage; });
  return usage ? ExitCode::usage : all.front().code;
}

nlohmann::ordered_json error_document(const std::vector<Told>& all) {
  std::string message;
  nlohmann::ordered_json faults = nlohmann::ordered_json::array();
  for (const Told& one : all) {
    message += (message.empty() ? "" : "\n") + one.message;
    faults.insert(faults.end(), one.faults.begin(), one.faults.end());
  }
  return {{"error", {{"message", message}, {"faults", faults}}}};
}

}  // namespace

ExitCode report_failure(const std::exception& problem, const Global& global) {
  const std::vector<Told> all = all_told(problem);
  for (const Told& one : all) {
    // Faults of a scene are lines FILE:LINE:COL: that editors follow, so nothing stands before
    // them.
    if (!one.faults.empty())
      print_note(one.message + "\n");
    else
      print_error(one.message);
  }
  if (global.json) {
    try {
      print_json(error_document(all));
    } catch (const OutputError&) {
      // Nobody listens on stdout; stderr and the exit code tell.
    }
  }
  return exit_code_of(all);
}

}  // namespace wander
