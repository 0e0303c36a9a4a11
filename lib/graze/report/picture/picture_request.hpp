// Options of a picture besides its contents.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "graze/report/chart/axis.hpp"

namespace graze {

// A requested axis; what is not given follows from the data.
struct AxisRequest {
  std::optional<double> low, high;  // SI
  AxisScale scale = AxisScale::kLinear;
};

// The labels beside the curves: the ids of special points, and also the (p, k) of orbits.
enum class LabelChoice { kNone, kSpecial, kAll };

// For the column of a paper, or for a wall: heavier lines and marks on a larger sheet.
enum class PictureStyle { kPaper, kSlide };

// Millimetres; without a given height it follows from the contents.
struct PictureSize {
  double width = 120.0;
  std::optional<double> height{};
};

// For all texts; the names of axes are `points` large, labels and numbers at tics 8/11 of it.
struct PictureFont {
  std::string family = "DejaVu Sans";
  std::optional<double> points{};  // none: by the width, 8 of 120 mm
};

struct PictureRequest {
  // Only a file name, without other requests.
  PictureRequest(std::string name)
      : file(std::move(name)) {}                    // NOLINT(google-explicit-constructor)
  PictureRequest(const char* name) : file(name) {}  // NOLINT(google-explicit-constructor)
  PictureRequest() = default;

  bool empty() const { return file.empty(); }  // no picture is asked for

  std::string file;                  // .svg, .png or .pdf
  std::optional<std::string> title;  // the line at the top, or "none"; else scene and settings
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
