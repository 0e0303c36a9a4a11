// What is asked of a picture besides what it shows.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "graze/report/chart/axis.hpp"

namespace graze {

// An axis as its reader wants it; what is not given follows from what is drawn.
struct AxisRequest {
  std::optional<double> low, high;  // SI
  AxisScale scale = AxisScale::kLinear;
};

// Which words stand beside the curves: the ids of special points, and the (p, k) of orbits too.
enum class LabelChoice { kNone, kSpecial, kAll };

// For the column of a paper, or for a wall: heavier lines and marks on a larger sheet.
enum class PictureStyle { kPaper, kSlide };

// Millimetres; the height follows from what is drawn where it is not given.
struct PictureSize {
  double width = 120.0;
  std::optional<double> height{};
};

// Of all words; the names of axes are `points` large, what is beside curves and at tics 8/11 of it.
struct PictureFont {
  std::string family = "DejaVu Sans";
  std::optional<double> points{};  // none: by the width, 8 of 120 mm
};

struct PictureRequest {
  // A name alone asks for nothing else.
  PictureRequest(std::string name)
      : file(std::move(name)) {}                    // NOLINT(google-explicit-constructor)
  PictureRequest(const char* name) : file(name) {}  // NOLINT(google-explicit-constructor)
  PictureRequest() = default;

  bool empty() const { return file.empty(); }  // no picture is asked for

  std::string file;                  // .svg, .png or .pdf
  std::optional<std::string> title;  // the line at the head, or "none"; else scene and settings
  LabelChoice labels = LabelChoice::kAll;
  PictureStyle style = PictureStyle::kPaper;
  bool multipliers = false;  // of branches, in a panel of their own
  AxisRequest x, y;
  std::optional<PictureSize> size{};
  PictureFont font{};
};

inline constexpr LabelChoice kLabelChoices[] = {LabelChoice::kNone, LabelChoice::kSpecial,
                                                LabelChoice::kAll};
inline constexpr PictureStyle kPictureStyles[] = {PictureStyle::kPaper, PictureStyle::kSlide};

const char* name_of(LabelChoice choice);  // "special"
const char* name_of(PictureStyle style);  // "paper"

}  // namespace graze
