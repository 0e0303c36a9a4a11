#include "graze/report/picture/detail/picture_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace graze {
namespace {

// The name of a font without characters that gnuplot would interpret.
std::string plain_font(std::string family) {
  std::erase_if(family, [](char c) { return c == '\'' || c == ',' || c == '\n'; });
  return family;
}

// A layout is made for text of 8 points on a width of 12 cm, which is still legible in a column of
// 8 cm.
constexpr double kWidth = 12.0, kPoints = 8.0;

// Width of the sheet, cm.
double sheet_width(const PictureRequest& request) {
  if (request.size) return 0.1 * request.size->width;
  return request.style == PictureStyle::kSlide ? 2.0 * kWidth : kWidth;
}

// Height of each line of the title at the top, cm.
constexpr double kTitleRoom = 0.384, kTitleMargin = 0.156;
constexpr double kTitleLength = 76.0;  // characters that fit there, on a width of 12 cm

std::size_t characters_in(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// Cut to the length of a picture's title; the whole text is in the result.
std::string shortened(const std::string& text, std::size_t most) {
  if (characters_in(text) <= most) return text;
  std::string kept;
  std::size_t count = 0;
  for (const char c : text) {
    if ((c & 0xC0) != 0x80 && ++count >= most) break;
    kept += c;
  }
  return kept + "…";
}

}  // namespace

std::size_t Canvas::columns(std::size_t columns) const {
  // Text reduced to three quarters of a column is still legible.
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(static_cast<double>(columns) * width / kWidth + 0.25));
}

std::vector<std::string> caption_of(const PictureRequest& request, const RunInfo& info,
                                    double width) {
  const auto most = static_cast<std::size_t>(kTitleLength * width / kWidth);
  if (request.title == "none") return {};
  if (request.title) return {shortened(*request.title, most)};
  const std::string title = info.scene_title.empty()
                                ? std::filesystem::path(info.scene_file).filename().string()
                                : info.scene_title;
  std::string settings;
  for (const std::string& setting : info.settings)
    settings += (settings.empty() ? "" : ", ") + setting;
  if (title.empty() && settings.empty()) return {};
  if (settings.empty()) return {shortened(title, most)};
  const std::string both = title + " · " + settings;
  if (characters_in(both) <= most) return {both};
  return {shortened(title, most), shortened(settings, most)};
}

// The same picture in every file format. Points in units of `mark` look alike, too. In SVG gnuplot
// sets distances by the nominal size of the font, which therefore grows with the picture.
std::string terminal_of(const PictureRequest& request, const Canvas& canvas) {
  const std::string extension = std::filesystem::path(request.file).extension().string();
  const double size = canvas.scale, width = canvas.width;
  const double height = canvas.height + canvas.caption;
  const double weight = request.style == PictureStyle::kSlide ? 1.5 : 1.0, heavy = size * weight;
  const std::string family = plain_font(request.font.family);
  const auto pixels = [&](double across) {
    return fmt::format("{:.0f},{:.0f}", across / kWidth * size * width,
                       across / kWidth * size * height);
  };
  if (extension == ".png")
    return fmt::format(
        "set terminal pngcairo enhanced font '{},11' fontscale {:.4g} linewidth {:.4g} "
        "pointscale {:.4g} dashlength 0.7 size {} background '#FFFFFF'\n"
        "mark = 1\nlegend_line = 1\nsmall = ',8'\nmedium = ',9'\n",
        family, 2.95 * size, 3.0 * heavy, 3.4 * heavy, pixels(1360.0));
  if (extension == ".pdf")
    return fmt::format(
        "set terminal pdfcairo enhanced font '{},11' fontscale {:.4g} linewidth {:.4g} "
        "pointscale {:.4g} dashlength 0.7 size {:.4g}cm,{:.4g}cm background '#FFFFFF'\n"
        "mark = 1\nlegend_line = 1\nsmall = ',8'\nmedium = ',9'\n",
        family, 0.726 * size, 1.1 * heavy, 0.9 * heavy, size * width, size * height);
  return fmt::format(
      "set terminal svg enhanced font '{},{:.4g}' fontscale 1.59 linewidth {:.4g} "
      "dashlength 0.7 size {} background '#FFFFFF'\n"
      "mark = {:.4g}\nlegend_line = 1.4\nsmall = ',{:.4g}'\nmedium = ',{:.4g}'\n",
      family, 11.0 * size, 1.4 * heavy, pixels(640.0), 1.6 * weight, 8.0 * size, 9.0 * size);
}

namespace {

// Height of the caption at the top, cm.
double caption_height(const PictureRequest& request, const RunInfo& info, double width) {
  const std::vector<std::string> lines = caption_of(request, info, width);
  return lines.empty() ? 0.0 : kTitleMargin + kTitleRoom * static_cast<double>(lines.size());
}

}  // namespace

Canvas canvas_of(const PictureRequest& request, const RunInfo& info, double natural) {
  // A title always leaves some height to the picture.
  constexpr double kLeast = 1.0;
  const bool has_height = request.size && request.size->height;
  const double sheet = has_height ? 0.1 * *request.size->height : 0.0;
  Canvas canvas;
  if (request.font.points) {
    canvas.scale = *request.font.points / kPoints;
  } else {
    canvas.scale = sheet_width(request) / kWidth;
    // Text that would not fit is smaller.
    if (has_height)
      canvas.scale =
          std::min(canvas.scale, sheet / (natural + caption_height(request, info, kWidth)));
  }
  canvas.width = sheet_width(request) / canvas.scale;
  canvas.caption = caption_height(request, info, canvas.width);
  canvas.laid_out = canvas.height = natural;
  if (has_height) canvas.height = std::max(sheet / canvas.scale - canvas.caption, kLeast);
  return canvas;
}

}  // namespace graze
