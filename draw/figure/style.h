// How figures look: colours, line widths and sizes, in points.
//
// Light is red and the sensor blue; films take the palette of Okabe and Ito, which readers with any
// colour vision tell apart.  Nothing is told by colour alone: each role has its own marks too.
#pragma once

#include <array>
#include <string_view>

namespace wander::figure::style {

inline constexpr std::string_view font = "Helvetica, Arial, sans-serif";

inline constexpr std::string_view paper = "#ffffff";
inline constexpr std::string_view ink = "#222222";
inline constexpr std::string_view wall = "#404040";
inline constexpr std::string_view faint = "#e4e4e4";
inline constexpr std::string_view light = "#c8201e";
inline constexpr std::string_view sensor = "#005fa8";
inline constexpr std::string_view glass = "#edf3f6";
inline constexpr std::string_view glass_mark = "#7d97a6";

struct Stroke {
  std::string_view colour;
  std::string_view dashes;  // SVG's stroke-dasharray
};
inline constexpr Stroke neutral{"#808080", "none"};
inline constexpr Stroke guide{"#808080", "2 1.6"};
// A reference, and the path before a step: what is there already.
inline constexpr Stroke known{ink, "none"};
// Proposals, told apart by their dashes first.
inline constexpr Stroke accepted{"#4d88c4", "none"};
inline constexpr Stroke rejected{"#e07b00", "3.2 1.8"};
inline constexpr Stroke failed{"#b3478f", "1.2 1.2"};
// Around what is enlarged.
inline constexpr std::string_view zoom = "#2f7d4f";
inline constexpr std::array<Stroke, 7> films{{{"#0072b2", "none"},
                                              {"#d55e00", "4 1.6"},
                                              {"#009e73", "1.3 1.3"},
                                              {"#cc79a7", "6 1.5 1.3 1.5"},
                                              {"#e69f00", "2.6 1.3"},
                                              {"#56b4e9", "6 1.2 1.2 1.2 1.2 1.2"},
                                              {"#8c6d31", "9 2"}}};

// A column of a journal, and a page of two columns.
inline constexpr double column_width = 252;
inline constexpr double page_width = 516;

inline constexpr double title_size = 8.5;
inline constexpr double bold_width = 1.15;  // times the width of plain text
inline constexpr double label_size = 7.5;   // titles of axes
inline constexpr double small_size = 7;     // ticks and legends
inline constexpr double margin = 6;

}  // namespace wander::figure::style
