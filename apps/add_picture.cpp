#include "option_groups.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "graze/base/errors.hpp"
#include "option_values.hpp"

namespace graze {
namespace {

// A parameter may be below zero, but is no size.
constexpr AxisScale kParameterScales[] = {AxisScale::kLinear, AxisScale::kLog};

// An end of a range; none where nothing is written.
bool read_end(const std::string& text, std::optional<double>& end) {
  if (text.empty()) return true;
  double value = 0.0;
  if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value)) return false;
  end = value;
  return true;
}

// "A:B", "A:" or ":B".
void read_range(const std::string& option, const std::string& text, AxisRequest& axis) {
  const std::size_t colon = text.find(':');
  axis.low.reset(), axis.high.reset();
  const bool read = colon != std::string::npos && text.size() > 1 &&
                    read_end(text.substr(0, colon), axis.low) &&
                    read_end(text.substr(colon + 1), axis.high) &&
                    !(axis.low && axis.high && *axis.low >= *axis.high);
  if (!read)
    throw InputError(fmt::format(
        "{}: '{}' is not allowed; give the ends in SI units with the smaller one first, like "
        "0.5:2, or one of them, like 0.5: or :2",
        option, text));
}

// "W:H" or "W", mm.
void read_size(const std::string& text, PictureRequest& plot) {
  const std::size_t colon = text.find(':');
  // From a thumbnail to a poster.
  const auto reads = [](const std::string& length, std::optional<double>& into) {
    return read_end(length, into) && into && *into >= 20.0 && *into <= 2000.0;
  };
  std::optional<double> width, height;
  if (!reads(text.substr(0, colon), width) ||
      (colon != std::string::npos && !reads(text.substr(colon + 1), height)))
    throw InputError(fmt::format(
        "--size: '{}' is not allowed; give width and height in mm, each from 20 to 2000, like "
        "84:60, or the width alone",
        text));
  plot.size = PictureSize{*width, height};
}

// "FAMILY", "FAMILY,POINTS" or ",POINTS".
void read_font(const std::string& text, PictureFont& font) {
  const std::size_t comma = text.find(',');
  font = {};
  if (comma != 0) font.family = text.substr(0, comma);
  if (comma == std::string::npos && !text.empty()) return;
  if (comma == std::string::npos || !read_end(text.substr(comma + 1), font.points) ||
      !font.points || !(*font.points >= 2.0 && *font.points <= 100.0))
    throw InputError(fmt::format(
        "--font: '{}' is not allowed; give a family, a size of 2 to 100 points, or both, like "
        "'DejaVu Serif,8' or ,10",
        text));
}

}  // namespace

void add_picture(CLI::App* app, CommonOptions& command, const PictureFeatures& features) {
  PictureRequest& plot = command.plot;
  app->add_option(
         "-p,--plot", plot.file,
         "Draw a picture into this .svg, .png or .pdf, the gnuplot script and its data are "
         "kept beside it; or into this .html, a page to look into with a browser")
      ->type_name("FILE")
      ->group(kPicturesGroup);
  const auto fits = [](CLI::Option* option) { option->group(kPicturesGroup)->needs("--plot"); };
  fits(app->add_option("--title", plot.title,
                       "Line at the head of the picture, or none (default: the scene's title "
                       "and what --set changed)")
           ->type_name("TEXT"));
  fits(add_choice(app, "--style", plot.style, kPictureStyles,
                  "paper: for the column of a page; slide: twice as large, with heavier lines")
           ->type_name("STYLE"));
  fits(app->add_option_function<std::string>(
              "--size", [&plot](const std::string& text) { read_size(text, plot); },
              "Width and height of the picture, mm, or its width alone")
           ->type_name("W:H"));
  fits(app->add_option_function<std::string>(
              "--font", [&plot](const std::string& text) { read_font(text, plot.font); },
              "Family of its words, size of the names of its axes in points, or both")
           ->type_name("FAMILY,POINTS"));
  if (features.labels)
    fits(add_choice(app, "--labels", plot.labels, kLabelChoices,
                    "Words beside the curves: none, the ids of special points, or (p,k) as well")
             ->type_name("WHICH"));
  const auto axis = [&](const char* letter, const char* what, AxisRequest& of) {
    const std::string range = fmt::format("--{}-range", letter);
    if (features.ranges)
      fits(app->add_option_function<std::string>(
                  range, [range, &of](const std::string& text) { read_range(range, text, of); },
                  fmt::format("What the {} axis shows, in SI units; either end may be left out",
                              what))
               ->type_name("A:B"));
  };
  axis("x", "horizontal", plot.x);
  axis("y", "vertical", plot.y);
  if (features.scales) {
    fits(add_choice(app, "--x-scale", plot.x.scale, kParameterScales,
                    "Scale of the horizontal axis: linear or log")
             ->type_name("SCALE"));
    fits(
        add_choice(app, "--y-scale", plot.y.scale, kAxisScales,
                   "Scale of the vertical axis: linear, log, or dB (20 log10, re 1 of the SI unit)")
            ->type_name("SCALE"));
  }
  if (features.multipliers)
    fits(app->add_flag("--multipliers", plot.multipliers,
                       "Show the largest multiplier along the branches in a panel below"));
}

}  // namespace graze
