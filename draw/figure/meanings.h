// What each mark means: the one table that figures, legends and reports take their marks and words
// from.  No mark means two things, whatever its colour.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "draw/figure/hatching.h"
#include "draw/figure/marker.h"
#include "draw/figure/style.h"

namespace wander::figure {

// What became of a proposal: its name in records, in words, and the fill that stands for it.
struct OutcomeMark {
  std::string_view outcome, words;
  Fill fill;
};
inline constexpr std::string_view accepted_word = "accepted", refused_word = "metropolis";

// Accepted, refused by the acceptance test, and then all reasons of failure; in the order in which
// bars stack them.
std::span<const OutcomeMark> outcome_marks();
// An outcome that this program does not know is plain, and called by its name.
OutcomeMark mark_of_outcome(std::string_view outcome);

// Path classes by their share of the steps, the largest first; the last fill is of all the others.
inline constexpr std::size_t most_classes = 9;
std::span<const Fill> class_fills();

// Bins of a film that are not to be trusted, in the colour of the film.
Fill unreliable_fill(std::string_view colour);

// The insides of dielectrics, in drawings of scenes.
inline constexpr Fill clear_glass{Tile::line, 3, -45, 0.35, style::glass_mark, style::glass};
inline constexpr Fill rough_glass{Tile::dot, 2.4, 30, 0.45, style::glass_mark, style::glass};

// All of a kind, with what they mean: for a test that no mark means two things.
struct MeantFill {
  std::string meaning;
  Fill fill;
};
std::vector<MeantFill> all_fills();

struct MeantStroke {
  std::string_view meaning;
  style::Stroke stroke;
};
inline constexpr std::array strokes{MeantStroke{"accepted proposal", style::accepted},
                                    MeantStroke{"rejected proposal", style::rejected},
                                    MeantStroke{"guide", style::guide},
                                    MeantStroke{"reference, or path before a step", style::known},
                                    MeantStroke{"first film or contender", style::films[0]},
                                    MeantStroke{"second film or contender", style::films[1]},
                                    MeantStroke{"third film or contender", style::films[2]},
                                    MeantStroke{"fourth film or contender", style::films[3]},
                                    MeantStroke{"fifth film or contender", style::films[4]},
                                    MeantStroke{"sixth film or contender", style::films[5]},
                                    MeantStroke{"seventh film or contender", style::films[6]}};

}  // namespace wander::figure
