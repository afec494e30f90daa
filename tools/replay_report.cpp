#include "tools/replay_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tools/console.h"

namespace wander {

namespace {

using nlohmann::ordered_json;

std::string_view name_of(Event event) {
  switch (event) {
    case Event::emission:
      return "emission";
    case Event::scattering:
      return "scattering";
    case Event::reflection:
      return "reflection";
    case Event::transmission:
      return "transmission";
    case Event::detection:
      return "detection";
  }
  return "";
}

// ---- text

void add_path(std::string& text, const char* name, const ReplayedPath& path) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\npath {}: {}, at {:.9g} of the sensor\n", name, path.path_class,
                 fmt::join(path.film, ", "));
  fmt::format_to(out, "  {:>6}  {:<12}  {:>14}  {:>14}  {:>14}  {:>14}  {}\n", "vertex", "event",
                 "value", "G to next", "p from light", "p from sensor", "position");
  for (std::size_t i = 0; i < path.vertices.size(); ++i) {
    const ReplayedVertex& v = path.vertices[i];
    const bool last = i + 1 == path.vertices.size();
    fmt::format_to(out, "  {:>6}  {:<12}  {:>14.8g}  {:>14}  {:>14.8g}  {:>14.8g}  ({:.9g})\n", i,
                   name_of(v.event), v.value, last ? "" : fmt::format("{:.8g}", v.geometry),
                   v.from_light, v.from_sensor, fmt::join(v.position, ", "));
  }
}

void add_factor(std::string& text, std::string_view name, Scaled value) {
  fmt::format_to(std::back_inserter(text), "  {:<22}  {:>16.10g}  log {:.12g}\n", name,
                 value.value(), value.log());
}

void add_ratio(std::string& text, const Replay& replay) {
  const ReplayedProposal& p = *replay.proposal;
  const Scaled f_x = replay.x.f, f_y = p.y.f;
  text += "\nfactors of the acceptance ratio\n";
  add_factor(text, "f(x) = Π value Π G", f_x);
  add_factor(text, "f(y) = Π value Π G", f_y);
  add_factor(text, "s_m(x)", p.selection_x);
  add_factor(text, "s_m(y)", p.selection_y);
  add_factor(text, "T_m(x→y)", p.forward / Scaled(p.selection_x));
  add_factor(text, "T_m(y→x)", p.reverse / Scaled(p.selection_y));
  add_factor(text, "T(x→y) = s_m(x) T_m", p.forward);
  add_factor(text, "T(y→x) = s_m(y) T_m", p.reverse);
  add_factor(text, "f(y) T(y→x)", f_y * p.reverse);
  add_factor(text, "f(x) T(x→y)", f_x * p.forward);
  add_factor(text, "their ratio", (f_y * p.reverse) / (f_x * p.forward));
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  {:<22}  {:>16.10g}\n", "a = min(1, ratio)", replay.acceptance);
  fmt::format_to(out, "  {:<22}  {:>16.10g}  {}\n", "uniform number", p.decider,
                 replay.reason == Reason::none ? "below a: accepted" : "not below a: rejected");
}

// ---- JSON

ordered_json json_of(Scaled x) {
  return {{"value", finite_or_null(x.value())}, {"log", finite_or_null(x.log())}};
}

ordered_json json_of(const ReplayedPath& path) {
  ordered_json vertices = ordered_json::array();
  for (const ReplayedVertex& v : path.vertices)
    vertices.push_back({{"position", v.position},
                        {"event", name_of(v.event)},
                        {"value", finite_or_null(v.value)},
                        {"geometry", finite_or_null(v.geometry)},
                        {"from_light", finite_or_null(v.from_light)},
                        {"from_sensor", finite_or_null(v.from_sensor)}});
  vertices.back()["geometry"] = nullptr;
  return {{"path_class", path.path_class},
          {"film", path.film},
          {"f", json_of(path.f)},
          {"vertices", vertices}};
}

}  // namespace

std::string text_of_replay(const Replay& replay) {
  std::string text = fmt::format(
      "chain {}, step {}: {}, {}\n", replay.chain, replay.step, replay.mutation,
      replay.reason == Reason::none ? "accepted"
                                    : fmt::format("rejected: {}", name_of(replay.reason)));
  add_path(text, "x", replay.x);
  if (!replay.proposal) return text + "\nno path was proposed, so the state stays as it is\n";
  add_path(text, "y", replay.proposal->y);
  add_ratio(text, replay);
  return text;
}

ordered_json json_of_replay(const Replay& replay) {
  ordered_json json{{"schema", "wanderlight-replay/1"},
                    {"chain", replay.chain},
                    {"step", replay.step},
                    {"mutation", replay.mutation},
                    {"reason", name_of(replay.reason)},
                    {"accepted", replay.reason == Reason::none},
                    {"acceptance_rate", finite_or_null(replay.acceptance)},
                    {"x", json_of(replay.x)},
                    {"y", nullptr}};
  if (!replay.proposal) return json;
  const ReplayedProposal& p = *replay.proposal;
  json["y"] = json_of(p.y);
  json["selection"] = {{"x", p.selection_x}, {"y", p.selection_y}};
  json["mutation_forward"] = json_of(p.forward / Scaled(p.selection_x));
  json["mutation_reverse"] = json_of(p.reverse / Scaled(p.selection_y));
  json["forward"] = json_of(p.forward);
  json["reverse"] = json_of(p.reverse);
  json["ratio"] = json_of((p.y.f * p.reverse) / (replay.x.f * p.forward));
  json["uniform"] = p.decider;
  return json;
}

}  // namespace wander
