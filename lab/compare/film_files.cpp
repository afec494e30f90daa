#include "lab/compare/film_files.h"

#include <fmt/format.h>

#include <cctype>

namespace wander::compare {

namespace {

std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool kept =
        std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '=' || c == '_' || c == '-';
    if (kept || (!result.empty() && result.back() != '-')) result += kept ? c : '-';
  }
  while (result.ends_with('-')) result.pop_back();
  return result;
}

std::string name_of(const Runs& runs, std::size_t contender, std::size_t budget) {
  return fmt::format("{}-{}", plain(runs.contenders[contender].label), plain(runs.budgets[budget]));
}

}  // namespace

std::string film_file(const Runs& runs, std::size_t contender, std::size_t budget) {
  const std::string name = name_of(runs, contender, budget);
  std::size_t others = 0;  // of this name before
  for (std::size_t c = 0; c <= contender; ++c)
    for (std::size_t b = 0; b < (c < contender ? runs.budgets.size() : budget); ++b)
      if (name_of(runs, c, b) == name) ++others;
  return others == 0 ? fmt::format("{}/{}.exr", films_folder, name)
                     : fmt::format("{}/{}-{}.exr", films_folder, name, others + 1);
}

const Run* shown_run(const Runs& runs, std::size_t contender, std::size_t budget) {
  const Run* first = nullptr;
  for (const Run& run : runs.runs)
    if (run.contender == contender && run.budget == budget &&
        (first == nullptr || run.replicate < first->replicate))
      first = &run;
  return first;
}

}  // namespace wander::compare
