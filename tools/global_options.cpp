// The options that every verb shares.
#include <algorithm>
#include <array>
#include <utility>

#include "lab/failure.h"
#include "lab/nearest.h"
#include "lab/parsing.h"
#include "tools/command.h"
#include "tools/verb.h"

namespace wander {

namespace {

ProgressMode parse_progress(std::string_view text) {
  constexpr std::array modes{ProgressMode::automatic, ProgressMode::bar, ProgressMode::json,
                             ProgressMode::none};
  const auto found = std::ranges::find(progress_words, text);
  if (found == progress_words.end())
    throw UsageError(unknown_word("progress", text, progress_words));
  return modes[static_cast<std::size_t>(found - progress_words.begin())];
}

}  // namespace

void add_global_options(Command verb, Global& global) {
  const char* group = "Options of every verb";
  verb.set_help_flag("-h,--help", "print this help and exit").group(group);
  verb.add_flag("--json", global.json, "print exactly one JSON document on stdout").group(group);
  verb.add_option(
          "-t,--threads",
          [&global](const std::string& text) { global.threads = parse_threads(text); },
          "threads to compute with (default: all cores)")
      .type_name("N")
      .group(group);
  verb.add_option(
          "-s,--seed", [&global](const std::string& text) { global.seed = parse_seed(text); },
          "seed of the random numbers (default: 1)")
      .type_name("N")
      .group(group);
  verb.add_option(
          "-o,--out", [&global](const std::string& text) { global.out = text; },
          "where the output goes; - is standard output, where that is possible")
      .type_name("PATH")
      .group(group);
  verb.add_flag("--force", global.force, "replace an output that exists").group(group);
  verb.add_flag("-q,--quiet", global.quiet, "say nothing but errors").group(group);
  verb.add_flag("-v,--verbose", global.verbose, "say what is being done").group(group);
  verb.add_option(
          "--progress",
          [&global](const std::string& text) { global.progress = parse_progress(text); },
          "auto (default: a bar on a terminal), bar, json or none")
      .type_name("HOW")
      .group(group);
}

void examine_with(Command verb, Global& global, std::function<void(Examination&)> examine) {
  verb.preparse_callback([&global, examine = std::move(examine)] { global.examine = examine; });
}

}  // namespace wander
