// Who takes part in a comparison: methods, each at settings of its dials.
//
// Every method starts at the base point, where all dials are as usual or as --dial says.  Each
// --sweep adds, to every method that has its dial, one contender for each of its settings, the
// other dials being as at the base point: sweeps are made one after the other, not multiplied.  A
// setting that is the base point itself adds none, but is named in its label: "mlt large_step=0.3
// (default)", or "(base)" where --dial has turned it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/compare/runs.h"
#include "lab/job.h"

namespace wander::compare {

// A dial, turned.
struct Setting {
  const Dial* dial;
  std::string value;
};

struct Sweep {
  const Dial* dial;
  std::vector<std::string> values;
};

// A contender and what render() needs of it.
struct Entrant {
  Contender contender;
  const Method* method = nullptr;
  std::vector<Setting> settings{};  // of dials that the method has
  Dials dials{};                    // what these settings make
  std::optional<Job> job{};         // once the scene is read
};

// Each throws UsageError that says what is allowed.
std::vector<const Method*> parse_methods(std::string_view text);  // "bdpt,mlt"
Setting parse_setting(std::string_view text);                     // "DIAL=VALUE"
// "DIAL=V1,V2,…".  Values that hold commas themselves are parted by semicolons.
Sweep parse_sweep(std::string_view text);

// `max_vertices` is what the scene says, if that is known.  Throws UsageError where a dial is of no
// method, or a contender would take part twice.
std::vector<Entrant> line_up(std::span<const Method* const> methods, std::span<const Setting> fixed,
                             std::span<const Sweep> sweeps, std::optional<int> max_vertices);

}  // namespace wander::compare
