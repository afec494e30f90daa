#include "tools/compare/lineup.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tools/failure.h"
#include "tools/parsing.h"

namespace wander::compare {

namespace {

bool has(const MethodName& method, const Dial& dial) { return dial.missing(method.name).empty(); }

// "DIAL=REST"; `form` is what the option takes.
std::pair<const Dial*, std::string_view> dial_in(std::string_view option, std::string_view form,
                                                 std::string_view text) {
  const std::size_t equals = text.find('=');
  const Dial& dial = find_dial(text.substr(0, equals));
  if (equals == std::string_view::npos || equals + 1 == text.size())
    throw UsageError(fmt::format("{} '{}': allowed is {}={}", option, text, dial.word, form));
  return {&dial, text.substr(equals + 1)};
}

// A value that the dial does not take is found when the command line is read.
std::string checked(const Dial& dial, std::string_view value) {
  Dials scratch;
  dial.set(scratch, value);
  return std::string(value);
}

void require_of_some(const Dial& dial, std::span<const MethodName* const> methods) {
  if (std::ranges::none_of(methods, [&](const MethodName* m) { return has(*m, dial); }))
    require_dial(dial, methods.front()->name);
}

Entrant entrant(const MethodName& method, std::span<const Setting> fixed) {
  Entrant entrant{
      .contender = {.label = std::string(method.name), .method = std::string(method.name)}};
  for (const Setting& setting : fixed) {
    if (!has(method, *setting.dial)) continue;
    setting.dial->set(entrant.dials, setting.value);
    entrant.settings.push_back(setting);
  }
  return entrant;
}

// The base point but for this dial.
Entrant turned(Entrant base, const Dial& dial, const std::string& value) {
  base.contender.dial = dial.word;
  base.contender.setting = value;
  base.contender.label += fmt::format(" {}={}", dial.word, value);
  dial.set(base.dials, value);
  std::erase_if(base.settings, [&](const Setting& s) { return s.dial == &dial; });
  base.settings.push_back({&dial, value});
  return base;
}

void require_distinct(std::span<const Entrant> entrants) {
  for (std::size_t i = 0; i < entrants.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (entrants[i].contender.label == entrants[j].contender.label)
        throw UsageError(
            fmt::format("'{}' would take part twice; name every method and setting once",
                        entrants[i].contender.label));
}

}  // namespace

std::vector<const MethodName*> parse_methods(std::string_view text) {
  std::vector<const MethodName*> methods;
  for (const std::string_view word : split(text, ',')) methods.push_back(&parse_method(word));
  return methods;
}

Setting parse_setting(std::string_view text) {
  const auto [dial, value] = dial_in("--dial", "VALUE", text);
  return {dial, checked(*dial, value)};
}

Sweep parse_sweep(std::string_view text) {
  auto [dial, values] = dial_in("--sweep", "VALUE,VALUE,...", text);
  const bool holds_commas = values.find(';') != std::string_view::npos;
  if (values.ends_with(';')) values.remove_suffix(1);
  Sweep sweep{dial, {}};
  for (const std::string_view value : split(values, holds_commas ? ';' : ','))
    sweep.values.push_back(checked(*dial, value));
  return sweep;
}

std::vector<Entrant> line_up(std::span<const MethodName* const> methods,
                             std::span<const Setting> fixed, std::span<const Sweep> sweeps) {
  for (const Setting& setting : fixed) require_of_some(*setting.dial, methods);
  for (const Sweep& sweep : sweeps) require_of_some(*sweep.dial, methods);
  std::vector<Entrant> entrants;
  for (const MethodName* method : methods) {
    const Entrant base = entrant(*method, fixed);
    entrants.push_back(base);
    for (const Sweep& sweep : sweeps) {
      if (!has(*method, *sweep.dial)) continue;
      for (const std::string& value : sweep.values)
        entrants.push_back(turned(base, *sweep.dial, value));
    }
  }
  require_distinct(entrants);
  return entrants;
}

}  // namespace wander::compare
