#include "scenes/format/scene_file_nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "scenes/format/json_text.h"

namespace wander {

namespace {

constexpr std::size_t longest_word = 64;  // of longer ones only the beginning is compared
constexpr std::size_t most_words = 12;    // that a message lists

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// A letter in the wrong case is a third of a mistake.
int cost(char a, char b) {
  if (a == b) return 0;
  return lower(a) == lower(b) ? 1 : 3;
}

// Optimal string alignment (Damerau, Levenshtein), in thirds of an edit.
int edit_distance(std::string_view a, std::string_view b) {
  std::array<std::vector<int>, 3> rows;  // the current one and the two above it
  for (auto& row : rows) row.resize(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = 3 * static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& above = rows[(i + 2) % 3];
    row[0] = 3 * static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 3, row[j - 1] + 3, above[j - 1] + cost(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], rows[(i + 1) % 3][j - 2] + 3);
    }
  }
  return rows[a.size() % 3][b.size()];
}

struct Nearest {
  std::string word;
  int distance = std::numeric_limits<int>::max();  // in thirds of an edit
};

Nearest nearest(std::string_view word, const std::vector<std::string>& known) {
  Nearest best;
  for (const std::string& candidate : known) {
    const int distance = edit_distance(word.substr(0, longest_word),
                                       std::string_view(candidate).substr(0, longest_word));
    if (distance < best.distance) best = {candidate, distance};
  }
  return best;
}

// Up to half of the letters may be wrong.
bool is_likely(const Nearest& found, std::string_view word) {
  return 2 * found.distance <= 3 * static_cast<int>(std::min(word.size(), longest_word));
}

}  // namespace

std::string likely_word(std::string_view word, const std::vector<std::string>& known) {
  const Nearest found = nearest(word, known);
  return is_likely(found, word) ? found.word : "";
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  if (known.empty()) return "none is known here";
  std::vector<std::string> listed;
  for (std::size_t i = 0; i < std::min(known.size(), most_words); ++i)
    listed.push_back(excerpt(known[i]));
  const Nearest found = nearest(word, known);
  const bool likely = is_likely(found, word);
  return fmt::format("{} \"{}\"{} allowed are {}{}", likely ? "did you mean" : "the nearest is",
                     excerpt(found.word), likely ? "?" : ";", fmt::join(listed, ", "),
                     known.size() > most_words ? ", ..." : "");
}

}  // namespace wander
