// What is asked of a picture, of each kind of result what its pictures have.
#pragma once

#include <fmt/format.h>

#include <string>

#include "graze/record/record_names.hpp"
#include "graze/report/picture/picture_request.hpp"
#include "options/option.hpp"

namespace graze {

// What the pictures of a result have that may be asked for, besides title and style.
struct PictureFeatures {
  bool ranges = false;       // of the axes
  bool scales = false;       // of the axes, logarithmic or in decibels
  bool labels = false;       // beside special points and curves
  bool multipliers = false;  // of branches
};
inline constexpr PictureFeatures kAllFeatures = {true, true, true, true};
template <class Record>
inline constexpr PictureFeatures kFeatures = {.ranges = true};
template <>
inline constexpr PictureFeatures kFeatures<CheckRecord> = {};
template <>
inline constexpr PictureFeatures kFeatures<ModesRecord> = {};
template <>
inline constexpr PictureFeatures kFeatures<OrbitRecord> = {};
template <>
inline constexpr PictureFeatures kFeatures<BranchRecord> = kAllFeatures;
template <>
inline constexpr PictureFeatures kFeatures<LociRecord> = {
    .ranges = true, .scales = true, .labels = true};
template <>
inline constexpr PictureFeatures kFeatures<DiagramRecord> = kAllFeatures;
template <>
inline constexpr PictureFeatures kFeatures<MapRecord> = {.ranges = true, .labels = true};

// A parameter may be below zero, but is no size.
inline constexpr AxisScale kParameterScales[] = {AxisScale::kLinear, AxisScale::kLog};

TextReader reads_range(const char* letter,
                       AxisRequest& axis);    // "A:B", "A:" or ":B"
TextReader reads_size(PictureRequest& plot);  // "W:H" or "W", mm
TextReader reads_font(PictureFont& font);     // "FAMILY", "FAMILY,POINTS" or ",POINTS"

void describe(auto& v, PictureRequest& o, const PictureFeatures& features) {
  v.heading(kPicturesGroup);
  v.option("plot", o.file, "FILE",
           "Draw a picture into this .svg, .png or .pdf, the gnuplot script and its data are kept "
           "beside it; or into this .html, a page to look into with a browser",
           Letter{'p'});
  const Needs picture{{"plot"}};
  v.option("title", o.title, "TEXT",
           "Line at the head of the picture, or none (default: the scene's title and what --set "
           "changed)",
           picture);
  v.choice("style", o.style, kPictureStyles, "STYLE",
           "paper: for the column of a page; slide: twice as large, with heavier lines", picture);
  v.text("size", reads_size(o), "W:H", "Width and height of the picture, mm, or its width alone",
         picture);
  v.text("font", reads_font(o.font), "FAMILY,POINTS",
         "Family of its words, size of the names of its axes in points, or both", picture);
  if (features.labels)
    v.choice("labels", o.labels, kLabelChoices, "WHICH",
             "Words beside the curves: none, the ids of special points, or (p,k) as well", picture);
  const auto range = [&](const char* letter, const char* which, AxisRequest& axis) {
    v.text(fmt::format("{}_range", letter), reads_range(letter, axis), "A:B",
           fmt::format("What the {} axis shows, in SI units; either end may be left out", which),
           picture);
  };
  if (features.ranges) range("x", "horizontal", o.x), range("y", "vertical", o.y);
  if (features.scales) {
    v.choice("x_scale", o.x.scale, kParameterScales, "SCALE",
             "Scale of the horizontal axis: linear or log", picture);
    v.choice("y_scale", o.y.scale, kAxisScales, "SCALE",
             "Scale of the vertical axis: linear, log, or dB (20 log10, re 1 of the SI unit)",
             picture);
  }
  if (features.multipliers)
    v.flag("multipliers", o.multipliers,
           "Show the largest multiplier along the branches in a panel below", picture);
}

}  // namespace graze
