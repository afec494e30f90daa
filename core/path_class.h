// The class of a path as a number: a 1, then a bit for each vertex between the ends, light first,
// which is 1 where the vertex is specular.  So LDSE is 0b101.  Paths whose class needs more than 64
// bits share the number 0.
#pragma once

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "core/joined_path.h"

namespace wander {

using PathClass = std::uint64_t;

inline constexpr PathClass other_class = 0;
inline constexpr int most_classified = 65;  // vertices

// Of a Path or a JoinedPath.
template <class P>
PathClass path_class_of(const P& x) {
  if (x.size() > most_classified) return other_class;
  PathClass code = 1;
  for (int i = 1; i + 1 < x.size(); ++i) code = 2 * code + (is_specular(x[i].event) ? 1 : 0);
  return code;
}

// Such as LDSE; "other" for the number 0.
inline std::string name_of_class(PathClass code) {
  if (code == other_class) return "other";
  std::string letters = "L";
  for (int bit = static_cast<int>(std::bit_width(code)) - 2; bit >= 0; --bit)
    letters += letter((code >> bit & 1) != 0 ? Event::reflection : Event::scattering);
  return letters + letter(Event::detection);
}

// Classes as they are met, numbered from 1; 0 is for all that find no place any more.  Whoever counts by
// class keeps entries for those that were met alone, in room for all (room_for_classes): few ever are.
class ClassTable {
 public:
  static constexpr std::size_t most_classes = 255;

  ClassTable() : places_(2 * (most_classes + 1)), codes_(1, other_class) {
    codes_.reserve(most_classes + 1);
  }

  std::size_t index(PathClass code) {
    if (code == other_class) return 0;
    for (std::size_t place = code * 0x9E3779B97F4A7C15u >> 55;; place = (place + 1) & 511) {
      const std::size_t found = places_[place];
      if (found != 0 && codes_[found] == code) return found;
      if (found != 0) continue;
      if (codes_.size() > most_classes) return 0;
      places_[place] = static_cast<std::uint16_t>(codes_.size());
      codes_.push_back(code);
      return codes_.size() - 1;
    }
  }
  std::size_t size() const { return codes_.size(); }  // index 0 included
  PathClass code(std::size_t index) const { return codes_[index]; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(places_, codes_);
  }

 private:
  std::vector<std::uint16_t> places_;  // open addressing; at most half of them are taken
  std::vector<PathClass> codes_;
};

// Entries of the one class that there is from the start; those of the others come without an allocation.
template <class Entry>
std::vector<Entry> room_for_classes(std::size_t entries_of_class = 1) {
  std::vector<Entry> entries;
  entries.reserve((ClassTable::most_classes + 1) * entries_of_class);
  entries.resize(entries_of_class);
  return entries;
}

// The entries of a class, which may be new.
template <class Entry>
Entry* entries_of(std::vector<Entry>& entries, std::size_t index,
                  std::size_t entries_of_class = 1) {
  const std::size_t first = index * entries_of_class;
  if (entries.size() <= first) entries.resize(first + entries_of_class);
  return &entries[first];
}

}  // namespace wander
