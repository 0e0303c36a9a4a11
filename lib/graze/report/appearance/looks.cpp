#include "graze/report/appearance/looks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace graze {
namespace {

const std::vector<Look> kLines = {
    {.id = "virtual", .title = "inadmissible", .colour = kGrey, .width = 0.9},
    {.id = "open", .title = "stability open", .colour = kBlack, .dashes = {2, 3}},
    {.id = "unstable", .title = "unstable", .colour = kVermillion, .dashes = {8, 5}},
    {.id = "stable", .title = "stable", .colour = kBlue, .width = 2.2}};

Look mark(const char* id, const char* title, const char* colour, MarkShape shape, bool open,
          double size) {
  return {.id = id,
          .title = title,
          .colour = colour,
          .width = 1.2,
          .mark = shape,
          .open = open,
          .size = size};
}

// No two of one shape, none of them a sweep's dot.
const std::vector<Look> kSpecial = {
    mark("LP", "fold (LP)", kBlack, MarkShape::kCircle, true, 0.9),
    mark("BP", "branch point (BP)", kBlack, MarkShape::kCross, false, 1.0),
    mark("PD", "period doubling (PD)", kPurple, MarkShape::kSquare, false, 0.75),
    mark("NS", "torus (NS)", kSky, MarkShape::kDiamond, false, 1.0),
    mark("GR", "grazing (GR)", kGreen, MarkShape::kUp, true, 1.0),
    mark("CH", "chatter ends (CH)", kOrange, MarkShape::kDown, true, 1.0),
    mark("LO", "lift-off (LO)", kOrange, MarkShape::kPentagon, true, 1.0),
    mark("GS", "grazing-sliding (GS)", kSky, MarkShape::kUp, false, 0.9),
    mark("CS", "crossing-sliding (CS)", kPurple, MarkShape::kDown, false, 0.9),
    mark("SS", "switching-sliding (SS)", kOrange, MarkShape::kPlus, false, 1.0),
    mark("AS", "adding-sliding (AS)", kGreen, MarkShape::kStar, false, 1.0),
    mark("UZ", "level (UZ)", kIndigo, MarkShape::kPentagon, false, 0.9),
    mark("EX", "extreme (EX)", kVermillion, MarkShape::kDiamond, true, 1.0)};
const Look kVirtualSpecial =
    mark("virtual point", "inadmissible special point", kGrey, MarkShape::kDot, false, 0.6);
const Look kUnknownSpecial = mark("", "", kBlack, MarkShape::kSquare, true, 0.9);
const Look kCodimensionTwo =
    mark("codimension two", "codimension two", kBlack, MarkShape::kDot, false, 0.8);

const std::vector<Look> kLoci = {
    {.id = "LP", .title = "fold (LP)", .colour = kBlack},
    {.id = "PD", .title = "period doubling (PD)", .colour = kPurple, .dashes = {10, 4}},
    {.id = "NS", .title = "torus (NS)", .colour = kSky, .dashes = {10, 3, 2, 3}},
    {.id = "GR", .title = "grazing (GR)", .colour = kGreen, .dashes = {4, 4}},
    {.id = "CH", .title = "chatter ends (CH)", .colour = kOrange, .dashes = {14, 3, 2, 3, 2, 3}},
    {.id = "UZ", .title = "level (UZ)", .colour = kIndigo, .width = 1.4},
    {.id = "EX", .title = "extreme (EX)", .colour = kVermillion, .dashes = {2, 4}},
    {.id = "virtual", .title = "inadmissible", .colour = kGrey, .width = 0.9}};

Look dot(const char* id, const char* title, const char* colour) {
  return mark(id, title, colour, MarkShape::kDot, false, 0.35);
}
const std::vector<Look> kDots = {
    dot("periodic", "sweep: periodic", kBlack), dot("wild", "sweep: not periodic", kGrey),
    dot("largest", "largest exponent", kIndigo), dot("lower", "other exponents", kOrange),
    mark("cut", "exponents, cut off", kOrange, MarkShape::kDown, false, 0.35)};

Look ground(const char* id, const char* title, const char* colour) {
  return {.id = id, .title = title, .colour = colour, .width = 0.0};
}
// Grounds light enough for lines and words upon them (after P. Tol, Colour Schemes,
// SRON/EPS/TN/09-002, 2021, the light scheme).
const std::vector<Look> kGrounds = {
    ground("clear", "no impact", "#C4E4F2"),
    ground("(1,1)", "(1,1)", "#77AADD"),
    ground("(2,2)", "(2,2)", "#FFAABB"),
    ground("sticks", "sticks", kStuckShade),
    ground("wild", "not periodic, or chaos", "#5A5A5A"),
    ground("torus", "torus", "#C9AE97"),
    ground("other", "other motions", "#BBBBBB"),
    ground("asked and more", "the asked motion and others", "#CCDDAA"),
    ground("several", "several motions, without the asked one", "#D9CBE4"),
    ground("differs", "two motions that differ", kVermillion),
    ground("none", "no motion", "#E8E8E8"),
    ground("blank", "nothing to show, or not run", "#FFFFFF"),
};
constexpr std::array kOtherGrounds = {"#44BB99", "#EE8866", "#BBCC33", "#B79AD0", "#AAAA00"};
constexpr std::array kWithoutMotion = {"#E8E8E8", "#D0D0D0", "#A8A8A8", "#888888"};
constexpr std::array kCurves = {kBlue, kVermillion, kGreen, kOrange, kPurple, kSky};

// One for each colour of curves.
const std::array<std::vector<int>, kCurves.size()> kCurveDashes = {
    {{}, {8, 4}, {3, 3}, {10, 3, 2, 3}, {14, 3, 2, 3, 2, 3}, {2, 4}}};

const Look* found(std::span<const Look> looks, const std::string& id) {
  const auto at =
      std::find_if(looks.begin(), looks.end(), [&](const Look& look) { return look.id == id; });
  return at == looks.end() ? nullptr : &*at;
}

std::string words(const Look& look) {
  if (look.mark == MarkShape::kNone) {
    if (look.width == 0.0) return "ground";
    if (look.dashes.empty()) return "full line";
    std::string dashes;
    for (const int length : look.dashes)
      dashes += (dashes.empty() ? "" : " ") + std::to_string(length);
    return "dashes " + dashes;
  }
  static constexpr std::array kShapes = {"",        "dot",         "circle",        "square",
                                         "diamond", "triangle up", "triangle down", "pentagon",
                                         "cross",   "plus",        "star"};
  return std::string(look.open ? "open " : "") + kShapes[static_cast<std::size_t>(look.mark)];
}

}  // namespace

std::span<const Look> line_looks() { return kLines; }
std::span<const Look> special_looks() { return kSpecial; }
std::span<const Look> locus_looks() { return kLoci; }
std::span<const Look> dot_looks() { return kDots; }
std::span<const Look> ground_looks() { return kGrounds; }
std::span<const char* const> other_grounds() { return kOtherGrounds; }
std::span<const char* const> grounds_without_motion() { return kWithoutMotion; }
std::span<const char* const> curve_colours() { return kCurves; }

const Look& special_look(const std::string& label) {
  const Look* look = found(kSpecial, label);
  return look ? *look : kUnknownSpecial;
}
const Look& virtual_special_look() { return kVirtualSpecial; }
const Look& codimension_two_look() { return kCodimensionTwo; }
const Look& dot_look(const std::string& id) { return *found(kDots, id); }
const Look* fixed_ground(const std::string& id) { return found(kGrounds, id); }
const Look& ground_look(const std::string& id) { return *found(kGrounds, id); }

Look curve_look(std::size_t i) {
  constexpr std::size_t kCount = kCurves.size();
  return {.colour = kCurves[i % kCount], .dashes = kCurveDashes[(i + i / kCount) % kCount]};
}

std::vector<LookGroup> all_looks() {
  std::vector<LookGroup> groups = {{"Branches", {kLines.rbegin(), kLines.rend()}},
                                   {"Special points", kSpecial},
                                   {"Loci of special points", kLoci},
                                   {"Sweeps and exponents", kDots},
                                   {"Grounds of maps and regions", kGrounds},
                                   {"Phases and stops", {}}};
  groups[1].looks.push_back(kVirtualSpecial);
  groups[2].looks.push_back(kCodimensionTwo);
  std::size_t next = 0;
  for (const char* colour : kOtherGrounds)
    groups[4].looks.push_back(
        ground("", fmt::format("other motions by number of cells, {}", ++next).c_str(), colour));
  for (std::size_t i = 1; i < kWithoutMotion.size(); ++i)
    groups[4].looks.push_back(
        ground("", fmt::format("no motion, for reason {}", i + 1).c_str(), kWithoutMotion[i]));
  groups[5].looks = {ground("", "behind a stop", kStopShade), ground("", "stuck", kStuckShade)};
  return groups;
}

std::string looks_table() {
  std::string table = "||What|Colour|Drawn as|\n|---|---|---|---|\n";
  for (const LookGroup& group : all_looks()) {
    std::string head = group.name;
    for (const Look& look : group.looks) {
      table += fmt::format("|{}|{}|`{}`|{}|\n", head, look.title, look.colour, words(look));
      head.clear();
    }
  }
  return table;
}

}  // namespace graze
