// Whether one can read the words of a picture: none lie over others, and none leave the picture.
#pragma once

#include <algorithm>
#include <array>
#include <regex>
#include <string>
#include <vector>

namespace graze::support {

struct PictureText {
  std::string words;
  double left, right, top, bottom;
};

// A letter of DejaVu Sans is wider than half its size on average, and those that rise are higher.
inline PictureText picture_text(const std::string& words, double x, double y, bool upright,
                                double size, const std::string& anchor) {
  const double length = 0.5 * size * static_cast<double>(words.size());
  const double from = anchor == "start" ? 0.0 : anchor == "end" ? -length : -0.5 * length;
  const double above = 0.6 * size, below = 0.1 * size;
  if (upright) return {words, x - above, x + below, y - from - length, y - from};
  return {words, x + from, x + from + length, y - above, y + below};
}

// Of a picture in SVG as gnuplot writes it; letters beyond ASCII count once.
inline std::vector<PictureText> texts_of_picture(const std::string& svg) {
  static const std::regex text(
      R"re(<g transform="translate\(([-\d.]+),([-\d.]+)\)( rotate\([-\d.]+\))?"[^>]*)re"
      R"re( font-size="([\d.]+)"\s+text-anchor="(\w+)">\s*<text>(.*?)</text>)re");
  static const std::regex tag("<[^>]*>"), entity("&\\w+;"), later_byte("[\x80-\xBF]");
  std::vector<PictureText> texts;
  for (std::sregex_iterator match(svg.begin(), svg.end(), text), end; match != end; ++match) {
    std::string words = std::regex_replace((*match)[6].str(), tag, "");
    words = std::regex_replace(std::regex_replace(words, entity, "x"), later_byte, "");
    if (words.find_first_not_of(' ') == std::string::npos) continue;
    texts.push_back(picture_text(words, std::stod((*match)[1]), std::stod((*match)[2]),
                                 (*match)[3].matched, std::stod((*match)[4]), (*match)[5]));
  }
  return texts;
}

// A line for each; nothing where all can be read.
inline std::string unreadable_texts(const std::string& svg) {
  std::smatch size;
  if (!std::regex_search(svg, size, std::regex(R"re(viewBox="0 0 (\S+) (\S+)")re")))
    return "no picture\n";
  const double width = std::stod(size[1]), height = std::stod(size[2]);
  const std::vector<PictureText> texts = texts_of_picture(svg);
  if (texts.size() < 4) return "hardly a word in the picture\n";
  std::string found;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const PictureText& a = texts[i];
    if (std::min(a.left, a.top) < -1.0 || a.right > width + 1.0 || a.bottom > height + 1.0)
      found += "leaves the picture: " + a.words + "\n";
    for (std::size_t k = 0; k < i; ++k) {
      const PictureText& b = texts[k];
      if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
        found += "lies over \"" + b.words + "\": " + a.words + "\n";
    }
  }
  return found;
}

}  // namespace graze::support
