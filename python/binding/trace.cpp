// Chains whose steps are recorded, and steps that are taken apart.
#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "lab/engine.h"
#include "lab/failure.h"
#include "lab/replay.h"
#include "lab/trace.h"
#include "lab/trace_request.h"
#include "mlt/seeds/nothing_found.h"
#include "python/binding/bindings.h"
#include "python/binding/listening.h"
#include "python/binding/run_request.h"
#include "records/trajectory_netcdf.h"
#include "tools/replay_report.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

using Texts = std::map<std::string, std::string>;

TraceRequest request_of(int chains, std::pair<std::uint64_t, std::uint64_t> window,
                        std::uint64_t every) {
  if (chains < 1 || chains > most_traced_chains)
    throw UsageError("chains: allowed is a whole number from 1 to " +
                     std::to_string(most_traced_chains));
  if (window.first >= window.second || every < 1)
    throw UsageError(
        "steps, every and window: at least one step is recorded, from window[0] to window[1] - 1");
  const TraceRequest request{chains, {window.first, window.second, every}};
  require_bounded(request);
  return request;
}

// A netCDF file in the layout of ArviZ, and whether it has all draws that were asked for; no bytes
// if it was interrupted before the first.
std::pair<nb::bytes, bool> trace_of(const BoundScene& scene, const std::string& method,
                                    const Texts& dials, std::uint64_t seed, int threads, int chains,
                                    std::pair<std::uint64_t, std::uint64_t> window,
                                    std::uint64_t every, const std::string& command_line,
                                    nb::object progress) {
  require_traced(find_method(method));
  const TraceRequest wanted = request_of(chains, window, every);
  const RunRequest request{scene, method, dials, seed, command_line};
  request.require_sound();
  Listening listening(std::move(progress));
  const Session session = listening.session(seed, threads);
  std::string file;
  bool complete = false;
  try {
    listening.carry_out([&] {
      Trace made = trace(request.job(), session, wanted);
      complete = made.complete;
      file = to_netcdf({.trajectory = std::move(made.trajectory),
                        .complete = made.complete,
                        .method = method,
                        .seed = seed,
                        .normalization = made.normalization,
                        .provenance = provenance_of(scene.document, command_line)},
                       scene.document.scene);
    });
  } catch (const NothingComputed&) {
    return {nb::bytes("", 0), false};
  }
  return {nb::bytes(file.data(), file.size()), complete};
}

// The step as JSON, and as text for people.
std::pair<std::string, std::string> replay_of(const BoundScene& scene, const Texts& dials,
                                              std::uint64_t seed, int threads, int chain,
                                              std::uint64_t step) {
  const Method& method = *methods_that([](const Method& m) { return m.is_replayed(); }).front();
  if (chain < 0 || chain >= most_traced_chains)
    throw UsageError("chain: allowed is a whole number from 0 to " +
                     std::to_string(most_traced_chains - 1));
  const RunRequest request{scene, std::string(method.name), dials, seed, {}};
  request.require_sound();
  Listening listening{nb::object(nb::none())};
  const Session session = listening.session(seed, threads);
  std::string json, text;
  listening.carry_out([&] {
    const Replay replayed = replay(request.job(), session, chain, step);
    json = json_of_replay(replayed).dump();
    text = text_of_replay(replayed);
  });
  return {json, text};
}

}  // namespace

void bind_trace(nb::module_& module) {
  module.def("trace", &trace_of, nb::arg("scene"), nb::arg("method"), nb::arg("dials"),
             nb::arg("seed"), nb::arg("threads"), nb::arg("chains"), nb::arg("window"),
             nb::arg("every"), nb::arg("command_line"), nb::arg("progress").none(),
             "A netCDF file, and whether it is complete.");
  module.def("replay", &replay_of, nb::arg("scene"), nb::arg("dials"), nb::arg("seed"),
             nb::arg("threads"), nb::arg("chain"), nb::arg("step"), "A step as JSON and as text.");
}

}  // namespace wander::python
