#include <array>

#include "lab/engine.h"
#include "lab/family/compiled_worlds.h"
#include "lab/worlds.h"

namespace wander {

namespace {

template <World... Ws>
constexpr std::array<Engine, sizeof...(Ws)> engines_in(WorldList<Ws...>) {
  return {Engine{.world = kind_of<Ws>,
                 .hold = &hold_in<Ws>,
                 .merge = &merge_in<Ws>,
                 .trace = &trace_in<Ws>,
                 .replay = &replay_in<Ws>,
                 .check = &check_in<Ws>}...};
}
constexpr std::array engine_table = engines_in(CompiledWorlds{});

}  // namespace

std::span<const Engine> engines() { return engine_table; }

}  // namespace wander
