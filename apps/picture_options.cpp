#include <fmt/format.h>

#include <optional>

#include "graze/base/errors.hpp"
#include "option_values.hpp"
#include "options/picture.hpp"

namespace graze {
namespace {

// An end of a range; none where nothing is written.
bool read_end(const std::string& text, std::optional<double>& end) {
  if (text.empty()) return true;
  end = number_in(text);
  return end.has_value();
}

void read_range(const char* letter, const std::string& text, AxisRequest& axis) {
  const std::size_t colon = text.find(':');
  axis.low.reset(), axis.high.reset();
  const bool read = colon != std::string::npos && text.size() > 1 &&
                    read_end(text.substr(0, colon), axis.low) &&
                    read_end(text.substr(colon + 1), axis.high) &&
                    !(axis.low && axis.high && *axis.low >= *axis.high);
  if (!read)
    throw InputError(
        fmt::format("--{}-range: '{}' is not allowed; give the ends in SI units with the smaller "
                    "one first, like "
                    "0.5:2, or one of them, like 0.5: or :2",
                    letter, text));
}

void read_size(const std::string& text, PictureRequest& plot) {
  const std::size_t colon = text.find(':');
  // From a thumbnail to a poster.
  const auto reads = [](const std::string& length, std::optional<double>& into) {
    into = number_in(length);
    return into && *into >= 20.0 && *into <= 2000.0;
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

TextReader reads_range(const char* letter, AxisRequest& axis) {
  return [letter, &axis](const std::string& text) { read_range(letter, text, axis); };
}
TextReader reads_size(PictureRequest& plot) {
  return [&plot](const std::string& text) { read_size(text, plot); };
}
TextReader reads_font(PictureFont& font) {
  return [&font](const std::string& text) { read_font(text, font); };
}

}  // namespace graze
