#include "fuzz/damage.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace graze {
namespace {

struct Range {
  std::size_t from = 0, to = 0;
};

std::vector<Range> numbers_of(const std::string& text) {
  std::vector<Range> list;
  const auto digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!digit(i)) continue;
    std::size_t to = i;
    while (to < text.size() && (digit(to) || text[to] == '.' || text[to] == 'e' ||
                                (text[to] == '-' && to > 0 && text[to - 1] == 'e')))
      ++to;
    list.push_back({i, to});
    i = to;
  }
  return list;
}

std::vector<Range> lines_of(const std::string& text) {
  std::vector<Range> list;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = text.find('\n', from);
    const std::size_t to = end == std::string::npos ? text.size() : end + 1;
    list.push_back({from, to});
    from = to;
  }
  return list;
}

void change_number(std::string& text, Draw& draw) {
  const std::vector<Range> numbers = numbers_of(text);
  if (numbers.empty()) return;
  const Range at = draw.of(numbers);
  text.replace(at.from, at.to - at.from, odd_number(draw));
}

void change_line(std::string& text, Draw& draw) {
  const std::vector<Range> lines = lines_of(text);
  if (lines.empty()) return;
  const Range at = draw.of(lines), other = draw.of(lines);
  const std::string line = text.substr(at.from, at.to - at.from);
  switch (draw.below(3)) {
    case 0:
      text.erase(at.from, line.size());
      break;
    case 1:
      text.insert(at.from, line);
      break;
    default:
      text.insert(other.from, line);
  }
}

void change_bytes(std::string& text, Draw& draw) {
  static const std::vector<std::string> kPieces{"\"",
                                                "[",
                                                "]",
                                                "{",
                                                "}",
                                                "=",
                                                ",",
                                                "\n",
                                                "#",
                                                "-",
                                                ".",
                                                "[[stop]]\n",
                                                "nan",
                                                "inf",
                                                std::string(1, '\0'),
                                                "\x1b[2J",
                                                "\xff\xfe",
                                                "\xc2\x9b",
                                                "\r\n",
                                                "1e999",
                                                "true",
                                                "9223372036854775808",
                                                "'''",
                                                "\\u0000",
                                                "[[[[[[[[[[[[[[[["};
  const std::size_t at = draw.below(text.size() + 1);
  switch (draw.below(4)) {
    case 0:
      text.erase(at, 1 + draw.below(8));
      break;
    case 1:
      text.insert(at, draw.of(kPieces));
      break;
    case 2:
      if (at < text.size()) text[at] = static_cast<char>(draw.below(256));
      break;
    default:
      text.resize(at);  // cut off
  }
}

}  // namespace

std::string odd_number(Draw& draw) {
  static const std::vector<std::string> kOdd{"0",
                                             "-1",
                                             "1",
                                             "2",
                                             "-0.0",
                                             "1e-8",
                                             "1e-300",
                                             "1e-320",
                                             "1e40",
                                             "1e160",
                                             "1e300",
                                             "-1e300",
                                             "1e999",
                                             "nan",
                                             "inf",
                                             "-inf",
                                             "400",
                                             "401",
                                             "0.5",
                                             "0.8",
                                             "1.0",
                                             "1e-16",
                                             "1e16",
                                             "0.9999999999999999",
                                             "1e5",
                                             "123456789",
                                             "9223372036854775807",
                                             "9223372036854775808",
                                             "-9223372036854775808",
                                             "4294967296",
                                             "true",
                                             "\"\"",
                                             "[]",
                                             "[1, 2]",
                                             "{}",
                                             "1_0",
                                             "0x10",
                                             "07",
                                             "1e",
                                             "",
                                             "3.7",
                                             "12",
                                             "28.3",
                                             "1e-3"};
  return draw.of(kOdd);
}

std::string stretched(std::string text, Draw& draw) {
  static const std::vector<std::string> kPowers{"1", "-1", "3",  "-3",  "8",  "-8",
                                                "2", "-2", "16", "-16", "40", "-40"};
  for (std::size_t left = 1 + draw.below(2); left > 0; --left) {
    std::vector<Range> numbers = numbers_of(text);
    std::erase_if(numbers, [&](const Range& at) {
      return at.from < 2 || text.compare(at.from - 2, 2, "= ") != 0 ||
             text.find('e', at.from) < at.to;
    });
    if (numbers.empty()) return text;
    text.insert(draw.of(numbers).to, "e" + draw.of(kPowers));
  }
  return text;
}

std::string damaged(std::string text, Draw& draw) {
  for (std::size_t left = 1 + draw.below(4); left > 0; --left) {
    const std::size_t what = draw.below(10);
    if (what < 6)
      change_number(text, draw);
    else if (what < 8)
      change_line(text, draw);
    else
      change_bytes(text, draw);
  }
  return text;
}

}  // namespace graze
