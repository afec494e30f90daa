#include "lab/compare/lineup.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <utility>

#include "lab/failure.h"
#include "lab/parsing.h"

namespace wander::compare {

namespace {

// "DIAL=REST"; `form` is what the option takes.
std::pair<const Dial*, std::string_view> dial_in(std::string_view option, std::string_view form,
                                                 std::string_view text) {
  const std::size_t equals = text.find('=');
  const Dial& dial = find_dial(text.substr(0, equals));
  if (equals == std::string_view::npos || equals + 1 == text.size())
    throw UsageError(fmt::format("{} '{}': allowed is {}={}", option, text, dial.word, form));
  return {&dial, text.substr(equals + 1)};
}

// Tells what is refused of a dial by its word: its option is one of other verbs.
template <class Work>
void by_word(std::string_view option, const Dial& dial, Work&& work) {
  try {
    work();
  } catch (const UsageError& refused) {
    std::string why = refused.what();
    boost::replace_all(why, dial.option(), dial.word);
    throw UsageError(fmt::format("{}: {}", option, why));
  }
}

// A value that the dial does not take is found when the command line is read.
std::string checked(std::string_view option, const Dial& dial, std::string_view value) {
  Dials scratch;
  by_word(option, dial, [&] { dial.set(scratch, value); });
  return std::string(value);
}

void require_of_some(std::string_view option, const Dial& dial,
                     std::span<const Method* const> methods) {
  if (std::ranges::none_of(methods, [&](const Method* m) { return dial.is_of(*m); }))
    by_word(option, dial, [&] { require_dial(dial, *methods.front()); });
}

// A later one would undo the earlier.
void require_once_each(std::span<const Setting> fixed) {
  for (std::size_t i = 0; i < fixed.size(); ++i)
    for (std::size_t j = i + 1; j < fixed.size(); ++j)
      if (fixed[i].dial == fixed[j].dial)
        throw UsageError(
            fmt::format("--dial turns {0} twice, to {1} and to {2}; leave one, or sweep it: "
                        "--sweep '{0}={1};{2}'",
                        fixed[i].dial->word, fixed[i].value, fixed[j].value));
}

Entrant entrant(const Method& method, std::span<const Setting> fixed) {
  Entrant entrant{
      .contender = {.label = std::string(method.name), .method = std::string(method.name)},
      .method = &method};
  for (const Setting& setting : fixed) {
    if (!setting.dial->is_of(method)) continue;
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

// The order and the sum of weights do not matter, nor the order of parameters.
MutationWeights normalized(MutationWeights weights) {
  std::erase_if(weights, [](const MutationWeight& each) { return !(each.weight > 0); });
  std::ranges::sort(weights, {}, &MutationWeight::word);
  double sum = 0;
  for (const MutationWeight& each : weights) sum += each.weight;
  for (MutationWeight& each : weights) {
    each.weight /= sum;
    std::ranges::sort(each.parameters, {}, &ParameterSetting::name);
  }
  return weights;
}

// Who takes part so far, by what the dials come to.
class Lineup {
 public:
  explicit Lineup(std::optional<int> max_vertices) : max_vertices_(max_vertices) {}

  bool are_the_same(const Entrant& a, const Entrant& b) const {
    return a.contender.method == b.contender.method && resolved(a) == resolved(b);
  }
  void add(Entrant entrant) {
    for (const Entrant& other : entrants_)
      if (are_the_same(entrant, other))
        throw UsageError(
            fmt::format("'{}' would take part twice; name every method and setting once",
                        entrant.contender.label));
    entrants_.push_back(std::move(entrant));
  }
  std::vector<Entrant> all() && { return std::move(entrants_); }

 private:
  Dials resolved(const Entrant& entrant) const {
    Dials dials = entrant.dials;
    dials.mutations = normalized(std::move(dials.mutations));
    if (dials.estimator == StepEstimator::usual) dials.estimator = entrant.method->usual_estimator;
    if (!dials.max_vertices) dials.max_vertices = max_vertices_;
    return dials;
  }

  std::optional<int> max_vertices_;
  std::vector<Entrant> entrants_{};
};

// The base point, and the settings of the sweeps that are no other point.
void add_method(Lineup& lineup, Entrant base, std::span<const Sweep> sweeps) {
  const Entrant plain = base;
  std::vector<Entrant> others;
  std::vector<const Dial*> met;  // sweeps that hold the base point
  for (const Sweep& sweep : sweeps)
    for (const std::string& value : sweep.values) {
      Entrant other = turned(plain, *sweep.dial, value);
      if (!lineup.are_the_same(other, plain)) {
        others.push_back(std::move(other));
      } else if (std::ranges::find(met, sweep.dial) == met.end()) {
        met.push_back(sweep.dial);
        base.contender.label += fmt::format(" {}={}", sweep.dial->word, value);
      } else {
        lineup.add(std::move(other));
      }
    }
  const auto is_fixed = [&](const Dial* dial) {
    return std::ranges::find(plain.settings, dial, &Setting::dial) != plain.settings.end();
  };
  if (!met.empty())
    base.contender.label += std::ranges::any_of(met, is_fixed) ? " (base)" : " (default)";
  lineup.add(std::move(base));
  for (Entrant& other : others) lineup.add(std::move(other));
}

}  // namespace

std::vector<const Method*> parse_methods(std::string_view text) {
  std::vector<const Method*> methods;
  for (const std::string_view word : split(text, ',')) methods.push_back(&find_method(word));
  return methods;
}

Setting parse_setting(std::string_view text) {
  const auto [dial, value] = dial_in("--dial", "VALUE", text);
  return {dial, checked("--dial", *dial, value)};
}

Sweep parse_sweep(std::string_view text) {
  auto [dial, values] = dial_in("--sweep", "VALUE,VALUE,...", text);
  const bool holds_commas = values.find(';') != std::string_view::npos;
  if (values.ends_with(';')) values.remove_suffix(1);
  Sweep sweep{dial, {}};
  for (const std::string_view value : split(values, holds_commas ? ';' : ','))
    sweep.values.push_back(checked("--sweep", *dial, value));
  return sweep;
}

std::vector<Entrant> line_up(std::span<const Method* const> methods, std::span<const Setting> fixed,
                             std::span<const Sweep> sweeps, std::optional<int> max_vertices) {
  require_once_each(fixed);
  for (const Setting& setting : fixed) require_of_some("--dial", *setting.dial, methods);
  for (const Sweep& sweep : sweeps) require_of_some("--sweep", *sweep.dial, methods);
  Lineup lineup(max_vertices);
  for (const Method* method : methods) {
    std::vector<Sweep> own(sweeps.begin(), sweeps.end());
    std::erase_if(own, [&](const Sweep& sweep) { return !sweep.dial->is_of(*method); });
    add_method(lineup, entrant(*method, fixed), own);
  }
  return std::move(lineup).all();
}

}  // namespace wander::compare
