#include "lab/methods.h"

#include <array>

#include "lab/failure.h"
#include "lab/world_methods.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 8> names{"pt",     "lt",   "bdpt",     "mlt",
                                                "pssmlt", "mmlt", "pt-naive", "lt-naive"};

void load(LiveRun& run, const std::string& state) {
  try {
    if (!state.empty()) restore(run, state);
  } catch (const std::exception& problem) {
    throw CommandFailure(
        ExitCode::invalid_input,
        std::string("the state in the checkpoint is not one that this build of the program reads "
                    "(") +
            problem.what() +
            "); carry the run on with the build that began it, or compute it anew, with --force "
            "instead of --continue");
  }
}

template <World W>
Rendering driven(const KeptRun& from, const description::Scene& description,
                 std::string_view method, const Dials& dials, const Session& session,
                 const Keeper& keeper) {
  Run execution(session);
  const WorldMethods<W> methods(description, dials, execution);
  const std::unique_ptr<LiveRun> run = methods.make(method);
  load(*run, from.state);
  Rendering rendering = drive(*run, execution, from.headway, keeper);
  methods.doubt(rendering);
  rendering.precision = name_of(dials.precision);
  return rendering;
}

}  // namespace

std::span<const std::string_view> method_names() { return names; }

void require_possible(std::string_view method, const description::Scene& scene) {
  if (method == "lt-naive" && scene.camera)
    throw UsageError(
        "lt-naive cannot see through a camera: its light paths must hit the sensor by chance, and "
        "no path hits a pinhole, nor a lens, which is no surface of the scene; use lt, or a sensor "
        "shape");
}

bool sees_all_light(std::string_view method, const description::Scene& scene) {
  return method != "lt" || !scene.camera || !requires_of(scene).specular;
}

Rendering render(const description::Scene& scene, std::string_view method, const Dials& dials,
                 const Session& session) {
  return carry_on({}, scene, method, dials, session, {});
}

Rendering carry_on(const KeptRun& from, const description::Scene& described,
                   std::string_view method, const Dials& dials, const Session& session,
                   const Keeper& keeper) {
  Session begun = session;
  begun.begun = session.clock->now();
  begun.begun->wall -= from.headway.wall_seconds;
  begun.begun->processor -= from.headway.processor_seconds;
  description::Scene description = described;
  description.max_vertices = dials.max_vertices.value_or(described.max_vertices);
  require_precision(dials.precision, description);
  const auto work =
      dials.precision == Precision::of_float ? &driven<FlatlandSingle> : &driven<Flatland>;
  return work(from, description, method, dials, begun, keeper);
}

}  // namespace wander
