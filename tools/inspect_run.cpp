#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/film_statistics.h"
#include "core/tint.h"
#include "lab/failure.h"
#include "lab/method.h"
#include "lab/reference_doubts.h"
#include "lab/reference_name.h"
#include "lab/wording.h"
#include "records/film_layers.h"
#include "records/run_json.h"
#include "statistics/number_text.h"
#include "tools/console.h"
#include "tools/inspection.h"
#include "tools/summary.h"

namespace wander {

namespace {

using nlohmann::ordered_json;

// `mean` is that of their luminance.
ordered_json channel_means(const FilmEstimate& film) {
  const auto channels = static_cast<std::size_t>(channels_of(film.shape));
  std::vector<double> sums(channels);
  for (std::size_t i = 0; i < film.value.size(); ++i) sums[i % channels] += film.value[i];
  ordered_json json = ordered_json::object();
  for (std::size_t c = 0; c < channels; ++c)
    json[std::string(channel_names(channels)[c])] = finite_or_null(
        sums[c] * static_cast<double>(channels) / static_cast<double>(film.value.size()));
  return json;
}

ordered_json film_of(const FilmEstimate& film) {
  ordered_json json{{"shape", film.shape},
                    {"degrees_of_freedom", finite_or_null(film.degrees_of_freedom)}};
  if (film.shape.size() > 1)
    json["channels"] = channel_names(static_cast<std::size_t>(channels_of(film.shape)));
  if (film.value.empty()) return json;
  json["mean"] = finite_or_null(mean_value(film));
  if (channels_of(film.shape) > 1) json["channel_means"] = channel_means(film);
  json["relative_error"] = finite_or_null(relative_error(film));
  json["reliable_share"] =
      static_cast<double>(reliable_bins(film)) / static_cast<double>(film.value.size());
  return json;
}

std::string channel_lines(const FilmEstimate& film) {
  if (film.value.empty() || channels_of(film.shape) < 2) return "";
  std::vector<std::string> means;
  const ordered_json by_channel = channel_means(film);
  for (const auto& [name, mean] : by_channel.items())
    means.push_back(fmt::format("{} {}", name,
                                mean.is_null() ? "unknown" : number_text(mean.get<double>(), 6)));
  return fmt::format("  channels        mean {}\n", fmt::join(means, ", "));
}

std::string number(const ordered_json& value) {
  return value.is_null() ? "unknown" : number_text(value.get<double>());
}

std::string share(const ordered_json& value) {
  return value.is_null() ? "unknown" : percent(value.get<double>());
}

// What a film.exr does not hold is left out, not shown as zero.
void leave_out_what_an_image_lacks(ordered_json& json) {
  for (const char* key : {"threads", "seconds", "cpu_seconds", "seed_seconds", "precision"})
    json.erase(key);
  if (!json.contains("mutations")) return;
  for (ordered_json& mutation : json["mutations"])
    for (const char* key : {"accepted", "failures", "seconds", "squared_jump",
                            "longest_rejection_run", "by_length", "by_class"})
      mutation.erase(key);
}

}  // namespace

ordered_json inspect_run(const RunRecord& run) {
  ordered_json json{{"schema", "wanderlight-inspection/1"}, {"kind", "run"}};
  const ordered_json whole = to_json(run, film_of(run.rendering.film));
  for (const auto& [key, value] : whole.items())
    if (key != "schema") json[key] = value;
  json["scene"].erase("text");
  if (std::isnan(run.rendering.seconds)) leave_out_what_an_image_lacks(json);
  return json;
}

std::string made_by_lines(const Provenance& provenance) {
  const Origin& origin = provenance.origin;
  std::string text = fmt::format("  made by         {} (version {})\n", provenance.command_line,
                                 provenance.version);
  if (!origin.commit.empty())
    text += fmt::format("  built           from commit {} by {}, {}\n", origin.commit,
                        origin.compiler, origin.build_type);
  if (!origin.date.empty())
    text += fmt::format("  run             {} on {}\n", origin.date, origin.cpu);
  return text;
}

std::string text_of_run(const RunRecord& run) {
  const Provenance& provenance = run.provenance;
  std::string text = summary_of(run.rendering) + channel_lines(run.rendering.film);
  text += fmt::format("  scene           {}\n",
                      provenance.scene_name.empty() ? "without a name" : provenance.scene_name);
  text += fmt::format("  scene sha256    {}\n", provenance.scene_digest.text);
  text += made_by_lines(provenance);
  if (!origin_of(run.rendering).empty()) return text;  // which is no warning
  for (const std::string& warning : run.rendering.warnings)
    text += fmt::format("  warning         {}\n", warning);
  return text;
}

ordered_json compare_runs(const RunRecord& run, const RunRecord& reference) {
  const FilmEstimate &film = run.rendering.film, &expected = reference.rendering.film;
  if (film.shape != expected.shape || film.value.size() != expected.value.size() ||
      film.value.empty())
    throw UsageError(fmt::format(
        "the film has {}{}, its reference {}{}: nothing to compare", extent_in_words(film.shape),
        film.value.empty() ? " without values" : "", extent_in_words(expected.shape),
        expected.value.empty() ? " without values" : ""));
  const FilmComparison comparison = film_comparison(film, expected);
  return {{"reference",
           {{"name", name_of_reference(reference.rendering)},
            {"method", reference.rendering.method},
            {"samples", reference.rendering.samples},
            {"command_line", reference.provenance.command_line}}},
          {"same_scene",
           may_be_the_same(run.provenance.scene_digest, reference.provenance.scene_digest)},
          {"other_lengths", has_other_lengths(reference.rendering, run.rendering.max_vertices)
                                ? words_of_lengths(reference.rendering, run.rendering.max_vertices)
                                : ""},
          {"may_share_samples", may_share_samples(run, reference)},
          {"relative_rmse", finite_or_null(comparison.relative_rmse)},
          {"bins", comparison.bins},
          {"chi2_per_degree", finite_or_null(comparison.chi2_per_degree)},
          {"largest_z", comparison.bins > 0 ? finite_or_null(comparison.largest_z) : nullptr},
          {"covered_share", finite_or_null(comparison.covered_share)}};
}

std::string text_of_comparison(const ordered_json& comparison) {
  std::string text = fmt::format("against the reference ({})\n",
                                 comparison["reference"]["name"].get<std::string>());
  if (!comparison["same_scene"].get<bool>())
    text += fmt::format("  warning         the reference {}\n", doubt_of_another_scene);
  if (const auto& lengths = comparison["other_lengths"].get_ref<const std::string&>();
      !lengths.empty())
    text += fmt::format("  warning         the reference has {}\n", lengths);
  if (comparison["may_share_samples"].get<bool>())
    text += fmt::format("  warning         {}\n", doubt_of_one_seed);
  text += fmt::format("  relative RMSE   {}\n", share(comparison["relative_rmse"]));
  if (comparison["bins"].get<std::size_t>() == 0)
    return text + "  bins            none is reliable in both: nothing more can be compared\n";
  text += fmt::format("  chi2 / degree   {} over {} bins reliable in both; largest |z| {}\n",
                      number(comparison["chi2_per_degree"]), comparison["bins"].get<std::size_t>(),
                      number(comparison["largest_z"]));
  return text + fmt::format("  covered         {} of these bins, by 95 % t-intervals\n",
                            share(comparison["covered_share"]));
}

}  // namespace wander
