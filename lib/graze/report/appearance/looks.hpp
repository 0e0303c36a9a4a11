// How every kind of thing looks, the same in all pictures and pages: its colour, the dashes of its
// line, its mark, its name in a legend. docs/gallery.md lists them.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace graze {

// Colours that colour-blind readers can distinguish (M. Okabe, K. Ito, Color Universal Design,
// 2008; purple is P. Tol's, dark enough for a line on a tinted ground).
inline constexpr const char* kBlue = "#0072B2";
inline constexpr const char* kVermillion = "#D55E00";
inline constexpr const char* kGreen = "#009E73";
inline constexpr const char* kBlack = "#000000";
inline constexpr const char* kOrange = "#E69F00";
inline constexpr const char* kSky = "#56B4E9";
inline constexpr const char* kPurple = "#AA3377";
inline constexpr const char* kGrey = "#999999";
inline constexpr const char* kIndigo = "#332288";
inline constexpr const char* kStopShade = "#DDDDDD";
inline constexpr const char* kStuckShade = "#F2C35E";

// What a mark is drawn as; those that are `open` are outlines on the paper's white.
enum class MarkShape { kNone, kDot, kCircle, kSquare, kDiamond, kUp, kDown, kPentagon, kCross, kPlus, kStar };

struct Look {
  std::string id = {};     // "stable", "LP", "clear"
  std::string title = {};  // of the legend: "fold (LP)"
  std::string colour = kBlue;
  // Lengths of strokes and of the gaps behind them, in widths of the line; empty: solid.
  std::vector<int> dashes = {};
  double width = 1.8;  // of the line, points
  MarkShape mark = MarkShape::kNone;
  bool open = false;
  double size = 1.0;  // of the mark, relative
};

// Lines of branches, in the order of drawing: orbits that an experiment shows lie on top.
// virtual, open, unstable, stable
std::span<const Look> line_looks();

// Special points, by label; a locus of such points has the colour of its mark.
std::span<const Look> special_looks();
const Look& special_look(const std::string& label);  // of one unknown as well
const Look& virtual_special_look();

// Loci of special points, "LP" to "CH"; "virtual" for virtual solutions.
std::span<const Look> locus_looks();
const Look& codimension_two_look();

// Dots of a sweep: periodic, not periodic, and of exponents: largest, lower, and cut off, at the
// edge of an axis beyond which they lie.
std::span<const Look> dot_looks();
const Look& dot_look(const std::string& id);

// Grounds of cells, by their settled motion: the motions that always look alike, then the colours
// that others get by their number of cells.
std::span<const Look> ground_looks();
const Look& ground_look(const std::string& id);   // of an id that is there
const Look* fixed_ground(const std::string& id);  // null where none always looks alike
std::span<const char* const> other_grounds();
// Grounds for cells without a motion, assigned in order of their texts.
std::span<const char* const> grounds_without_motion();

// Colours of curves that share a panel, one after the other.
std::span<const char* const> curve_colours();

// Line `i` of curves that share a panel: neighbours differ by more than their colour, and no two of
// 36 are alike.
Look curve_look(std::size_t i);

// All looks in groups, for the table of the gallery.
struct LookGroup {
  std::string name;
  std::vector<Look> looks;
};
std::vector<LookGroup> all_looks();
// That table, in Markdown.
std::string looks_table();

}  // namespace graze
