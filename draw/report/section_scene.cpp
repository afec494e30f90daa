// The scene with the light in its space, and what it requires of a method.
#include <fmt/format.h>

#include <algorithm>

#include "core/requirements.h"
#include "draw/figure/fluence_figure.h"
#include "draw/figure/plane_picture.h"
#include "draw/figure/share_bars.h"
#include "draw/figure/space_figure.h"
#include "draw/report/embedding.h"
#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "lab/fluence.h"
#include "lab/wording.h"
#include "mutations/family_settings.h"

namespace wander::report {
namespace {

// A budget of walks, not of time: the same picture on every machine.
constexpr std::uint64_t walks = 50'000;
constexpr int columns = 128;

void write_fluence(Html& html, const Subject& subject) {
  const PlaneGrid grid = figure::grid_over(subject.scene, columns);
  Session session;
  session.budget = SampleBudget{walks};
  const Rendering picture = estimate_fluence(subject.scene, grid, session);
  write_figure(
      html, figure::fluence_figure(subject.scene, grid, picture, subject.scene.name),
      fmt::format("The scene and its fluence, the radiance integrated over all directions at each "
                  "point of the space: light tones are bright, on a logarithmic scale. Estimated "
                  "from {} walks of light, for orientation only; no number of this report rests "
                  "on it.",
                  count_in_words(static_cast<double>(walks))),
      Ground::paper);
}

void write_outline(Html& html, const Subject& subject) {
  write_figure(
      html,
      figure::space_figure(subject.scene,
                           {.title = subject.scene.name, .width = figure::style::column_width}),
      subject.scene.camera ? "The outline of the scene as its camera has it, with what is hidden."
                           : "The outline of the scene from outside, with what is hidden.",
      Ground::page, Breadth::column);
}

std::string or_none(std::vector<std::string> words) {
  std::ranges::transform(words, words.begin(), figure::spoken);
  return words.empty() ? "none" : listed(words);
}

void write_item(Html& html, std::string_view term, std::string_view text) {
  html.element("dt", term);
  html.element("dd", text);
}

void write_requirements(Html& html, const Subject& subject) {
  const Requirements needs = requires_of(subject.scene);
  const MutationChoice choice = choose_mutations(needs);
  const auto scope = html.open("dl");
  write_item(html, "dimensions", fmt::format("{}", needs.dimension));
  write_item(html, "longest paths", fmt::format("{} vertices", needs.max_vertices));
  write_item(html, "materials", or_none(needs.materials));
  write_item(html, "shapes", or_none(needs.shapes));
  write_item(html, "specular surfaces", needs.specular ? "yes" : "no");
  write_item(html, "caustics", needs.caustic_paths_possible ? "possible" : "not possible");
  write_item(html, "mutations of mlt", or_none(choice.taken));
  for (const auto& [name, reason] : choice.left_out)
    write_item(html, "left out: " + figure::spoken(name), reason);
}

}  // namespace

void write_scene(Html& html, const Subject& subject) {
  if (!subject.scene.description.empty()) html.element("p", subject.scene.description);
  if (subject.is_image())
    write_outline(html, subject);
  else
    write_fluence(html, subject);
  html.element("h3", "What the scene requires");
  write_requirements(html, subject);
}

}  // namespace wander::report
