// Dials as options of a verb.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/dials.h"

namespace wander {

class Command;  // tools/command.h

struct DialOptions {
  Dials dials;
  std::vector<std::pair<const Dial*, std::string>> turned{};  // those that were given, and how

  // Throws UsageError if the method does not have a dial that was given.
  void require_for(const Method& method) const;
};

// The dials of these words.
void add_dial_options(Command verb, std::span<const std::string_view> words,
                      const std::shared_ptr<DialOptions>& options);
// All of them.
void add_dial_options(Command verb, const std::shared_ptr<DialOptions>& options);

// Those of the chains themselves, whatever becomes of their steps.
inline constexpr std::string_view chain_dials[] = {"mutations", "max_vertices", "precision",
                                                   "large_step", "kernel"};

}  // namespace wander
