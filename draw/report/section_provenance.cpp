// What made the numbers, and the commands that make them again.
#include <fmt/format.h>

#include <algorithm>

#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"
#include "lab/dials.h"
#include "lab/scene_source.h"
#include "lab/shell_words.h"
#include "lab/wording.h"
#include "scenes/gallery_scenes.h"

namespace wander::report {
namespace {

constexpr const char* scene_file = "scene.json";

// The gallery's, if the text is that of one of its scenes.
std::string source_of(const Subject& subject) {
  for (std::size_t k = 0; k < gallery_scene_count; ++k)
    if (gallery_scenes[k].text == subject.runs().provenance.scene_text)
      return std::string(gallery_prefix) + gallery_scenes[k].name;
  return scene_file;
}

std::string command_of(const Subject& subject, const Run& run, const std::string& source) {
  const Contender& contender = subject.runs().contenders[run.contender];
  std::vector<std::string> words{"wander",
                                 "render",
                                 source,
                                 "-m",
                                 contender.method,
                                 "-b",
                                 subject.runs().budgets[run.budget],
                                 "-s",
                                 fmt::format("{}", run.seed)};
  if (!contender.dial.empty()) {
    words.push_back(find_dial(contender.dial).option());
    words.push_back(contender.setting);
  }
  words.push_back("-o");
  words.push_back(
      fmt::format("run-{}-{}-{}", run.contender + 1, run.budget + 1, run.replicate + 1));
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return quoted_for_shell(static_cast<int>(arguments.size()), arguments.data());
}

void write_commands(Html& html, const Subject& subject, const std::string& source) {
  html.element("h3", "Commands");
  html.element("p", "This comparison:");
  html.element("pre", subject.runs().provenance.command_line, {{"tabindex", "0"}});
  html.element("p",
               "A budget in samples gives the same bits for any number of threads. A budget in "
               "seconds makes as many samples as the machine allows: its runs are repeated in "
               "distribution only.");
  if (source == scene_file)
    html.element("p", fmt::format("Save the text of the scene below as {}.", scene_file));
  const auto scope = html.open("details");
  html.element("summary",
               fmt::format("The commands of all {}", counted(subject.runs().runs.size(), "run")));
  std::string lines;
  for (const Run& run : subject.runs().runs) lines += command_of(subject, run, source) + "\n";
  html.element("pre", lines, {{"tabindex", "0"}});
}

void write_runs(Html& html, const Subject& subject) {
  const Runs& runs = subject.runs();
  std::vector<std::string> names, budgets, replicates, seeds, samples, seed_samples;
  std::vector<double> seconds, seed_seconds;
  for (const Run& run : runs.runs) {
    names.push_back(subject.label(run.contender));
    budgets.push_back(runs.budgets[run.budget]);
    replicates.push_back(fmt::format("{}", run.replicate + 1));
    seeds.push_back(fmt::format("{}", run.seed));
    samples.push_back(fmt::format("{}", run.samples));
    seed_samples.push_back(fmt::format("{}", run.seed_samples));
    seconds.push_back(run.seconds);
    seed_seconds.push_back(run.seed_seconds);
  }
  Table table = named_rows("Every run, in the order in which they were made.", "contender", names);
  table.add_column({"budget"}, budgets);
  table.add_column({"replicate"}, replicates);
  table.add_column({"seed"}, seeds);
  table.add_column({"samples"}, samples);
  table.add_column({"time, s"}, aligned(seconds));
  table.add_column({"of which seed pass, s"}, aligned(seed_seconds));
  table.add_column({"samples of the seed pass"}, seed_samples);
  write_folded(html, "All runs: seeds, samples and times", table);
}

std::string threads_of(const Subject& subject) {
  std::vector<int> threads;
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    if (const Rendering* details = subject.details(k)) threads.push_back(details->threads);
  std::ranges::sort(threads);
  threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
  std::vector<std::string> words;
  for (const int count : threads) words.push_back(fmt::format("{}", count));
  return words.empty() ? "not known" : listed(words);
}

void write_facts(Html& html, const Subject& subject, const std::string& source) {
  const Runs& runs = subject.runs();
  double seconds = 0;
  for (const Run& run : runs.runs) seconds += run.seconds;
  const auto scope = html.open("dl");
  const auto item = [&](std::string_view term, std::string_view text) {
    html.element("dt", term);
    html.element("dd", text, {{"class", "hash"}});
  };
  item("program", "Wanderlight " + runs.provenance.version);
  if (const Origin& origin = runs.provenance.origin; !origin.commit.empty()) {
    item("built from",
         fmt::format("commit {} by {}, {}", origin.commit, origin.compiler, origin.build_type));
    item("run", fmt::format("{} on {}", origin.date, origin.cpu));
  }
  item("scene", source);
  item("its SHA-256", runs.provenance.scene_digest.text);
  for (const auto& [name, digest] : runs.provenance.scene_digest.files) item("of " + name, digest);
  item("reference", runs.reference.origin.empty() ? "none" : runs.reference.origin);
  item("runs",
       fmt::format("{}, {} of sampling together", runs.runs.size(), duration_in_words(seconds)));
  item("threads", threads_of(subject));
}

void write_scene_text(Html& html, const Subject& subject) {
  const auto scope = html.open("details");
  html.element("summary", "The text of the scene");
  html.element("pre", subject.runs().provenance.scene_text, {{"tabindex", "0"}});
}

}  // namespace

void write_provenance(Html& html, const Subject& subject) {
  const std::string source = source_of(subject);
  write_facts(html, subject, source);
  write_commands(html, subject, source);
  write_runs(html, subject);
  write_scene_text(html, subject);
}

}  // namespace wander::report
