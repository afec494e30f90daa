// Marks and what they mean: each means one thing, and figures and reports take them from one table.
#include "draw/figure/meanings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw/figure/share_bars.h"
#include "mlt/proposal.h"
#include "tests/draw/figure/figure_checks.h"

namespace wander::figure {
namespace {

// Tiles turned by this are the same again.
double symmetry(Tile tile) {
  switch (tile) {
    case Tile::line:
    case Tile::dash:
    case Tile::zigzag:
      return 180;
    case Tile::triangle:
      return 360;
    default:
      return 90;
  }
}

// What is left without colour: the shape, its direction, and how much of the tile it covers.
bool look_alike(const Fill& a, const Fill& b) {
  if (a.tile != b.tile) return false;
  if (a.tile == Tile::plain) return a.ground == b.ground;
  const double turn = symmetry(a.tile);
  const double between = std::abs(std::remainder(a.angle - b.angle, turn));
  const bool round = a.tile == Tile::dot || a.tile == Tile::ring;
  const double share_a = a.weight / a.spacing, share_b = b.weight / b.spacing;
  const bool as_heavy =
      std::max(share_a, share_b) < 1.4 * std::min(share_a, share_b) || share_a == share_b;
  return (round || between < 15) && as_heavy;
}

TEST(Meanings, NoFillHasTwo) {
  const std::vector<MeantFill> all = all_fills();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(look_alike(all[i].fill, all[k].fill))
          << all[i].meaning << " looks like " << all[k].meaning;
  // The wrong twin: a fill in another colour is the same mark.
  Fill other = all.front().fill;
  other.colour = "#123456";
  EXPECT_TRUE(look_alike(other, all.front().fill));
}

TEST(Meanings, NoStrokeHasTwo) {
  for (const MeantStroke& a : strokes)
    for (const MeantStroke& b : strokes)
      if (&a != &b) {
        EXPECT_FALSE(a.stroke.colour == b.stroke.colour && a.stroke.dashes == b.stroke.dashes)
            << a.meaning << " looks like " << b.meaning;
        if (a.stroke.dashes != "none") {
          EXPECT_NE(a.stroke.dashes, b.stroke.dashes) << a.meaning << ", " << b.meaning;
        }
      }
}

TEST(Meanings, EveryOutcomeOfAProposalHasAMark) {
  for (const std::string_view reason : reason_names)
    if (reason != "none") {
      EXPECT_EQ(std::ranges::count(outcome_marks(), reason, &OutcomeMark::outcome), 1) << reason;
    }
  EXPECT_EQ(outcome_marks().size(), reason_names.size());
}

// Whatever else occurs, in which order and in which of the figures.
TEST(Meanings, AnOutcomeHasTheSameMarkInEveryFigure) {
  const auto fill_of = [](const std::map<std::string, double>& counts) {
    for (const Part& part : outcome_parts(counts))
      if (part.key == "occluded") return part;
    return Part{};
  };
  const Part alone = fill_of({{"occluded", 1}});
  const Part among = fill_of({{"accepted", 3}, {"changed_class", 2}, {"occluded", 1}, {"new", 1}});
  const auto document = [](const Part& part) {
    Svg svg({10, 10}, "", "");
    return define_fill(svg, part.fill);
  };
  EXPECT_EQ(document(alone), document(among));
  EXPECT_EQ(alone.legend, "occluded");
  EXPECT_EQ(among.legend, "occluded");
}

TEST(Meanings, WhatNeverOccursIsNotExplained) {
  const std::vector<Part> parts = outcome_parts({{"occluded", 0}, {"a_new_one", 2}});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].legend, "a new one");
}

TEST(Meanings, EveryFillIsDrawn) {
  for (const MeantFill& meant : all_fills()) {
    Svg svg({10, 10}, "", "");
    const std::string paint = define_fill(svg, meant.fill);
    const std::string text = std::move(svg).finish();
    EXPECT_TRUE(is_well_formed(text));
    if (meant.fill.tile == Tile::plain) continue;
    EXPECT_EQ(paint.substr(0, 5), "url(#");
    EXPECT_EQ(count(text, "id=\"" + paint.substr(5, paint.size() - 6) + "\""), 1u) << meant.meaning;
  }
}

}  // namespace
}  // namespace wander::figure
