#include "docs/shown_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <regex>

namespace graze::support {
namespace {

constexpr double kRounding = 1e-12;

const std::regex& number_pattern() {
  static const std::regex pattern(R"((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)");
  return pattern;
}

// One unit of the last digit that is written.
double last_place(const std::string& number) {
  const std::size_t mark = number.find_first_of("eE");
  const std::size_t point = number.find('.');
  const std::string digits = number.substr(0, mark);
  const int exponent = mark == std::string::npos ? 0 : std::atoi(number.c_str() + mark + 1);
  const int decimals = point == std::string::npos ? 0 : static_cast<int>(digits.size() - point) - 1;
  return std::pow(10.0, exponent - decimals);
}

std::string without_blanks(const std::string& text) {
  std::string words;
  for (const char c : text)
    if (c != ' ' && c != '\t') words += c;
  return words;
}

bool is_gap(const std::string& line) { return without_blanks(line) == ".."; }

// A line as what stands before, between and after its numbers.
struct Line {
  std::vector<std::string> texts, numbers;
};

Line parts_of(const std::string& line) {
  Line parts;
  std::size_t at = 0;
  for (std::sregex_iterator match(line.begin(), line.end(), number_pattern()), end; match != end;
       ++match) {
    const std::size_t place = static_cast<std::size_t>(match->position());
    parts.texts.push_back(without_blanks(line.substr(at, place - at)));
    parts.numbers.push_back(match->str());
    at = place + match->str().size();
  }
  parts.texts.push_back(without_blanks(line.substr(at)));
  return parts;
}

// Both are below the size of rounding, so that their signs and digits mean nothing.
bool both_vanish(const std::string& shown, const std::string& printed) {
  return std::abs(std::stod(shown)) < kRounding && std::abs(std::stod(printed)) < kRounding;
}

// Whether the lines of `shown` from i on stand in `printed` from `at` on; `farthest` is then the
// last line of `shown` that was looked for.
bool stands_at(const std::vector<std::string>& shown, std::size_t i,
               const std::vector<std::string>& printed, std::size_t at, bool to_end,
               std::size_t& farthest) {
  for (; i < shown.size(); ++i, ++at) {
    if (is_gap(shown[i])) {
      if (i + 1 == shown.size()) return true;
      for (std::size_t next = at; next <= printed.size(); ++next)
        if (stands_at(shown, i + 1, printed, next, to_end, farthest)) return true;
      return false;
    }
    farthest = std::max(farthest, i);
    if (at >= printed.size() || !shows_line(shown[i], printed[at])) return false;
  }
  farthest = std::max(farthest, i);
  return !to_end || at >= printed.size();
}

std::vector<std::string> without_empty_lines(const std::vector<std::string>& lines) {
  std::vector<std::string> rest;
  for (const std::string& line : lines)
    if (!without_blanks(line).empty()) rest.push_back(line);
  return rest;
}

}  // namespace

std::vector<std::string> numbers_in(const std::string& text) {
  std::vector<std::string> numbers;
  for (std::sregex_iterator match(text.begin(), text.end(), number_pattern()), end; match != end;
       ++match)
    numbers.push_back(match->str());
  return numbers;
}

bool is_rounding(const std::string& shown, const std::string& printed) {
  // What is printed is decimal, and a half of the last digit shown may go either way.
  constexpr double kHalf = 0.5 * (1.0 + 1e-9);
  return shown == printed ||
         std::abs(std::stod(shown) - std::stod(printed)) <= kHalf * last_place(shown);
}

bool shows_line(const std::string& shown, const std::string& printed) {
  const std::size_t cut = shown.size() > 3 ? shown.rfind(" ..") : std::string::npos;
  const bool open_end = cut != std::string::npos && cut + 3 == shown.size();
  const Line a = parts_of(open_end ? shown.substr(0, cut) : shown), b = parts_of(printed);
  const std::size_t count = a.numbers.size();
  if (open_end ? b.numbers.size() < count : b.numbers.size() != count) return false;
  for (std::size_t i = 0; i <= count; ++i) {
    std::string text = a.texts[i], other = b.texts[i];
    if (i == count && open_end) other = other.substr(0, text.size());
    if (i < count && both_vanish(a.numbers[i], b.numbers[i])) {
      if (!text.empty() && text.back() == '-') text.pop_back();
      if (!other.empty() && other.back() == '-') other.pop_back();
    } else if (i < count && !is_rounding(a.numbers[i], b.numbers[i])) {
      return false;
    }
    if (text != other) return false;
  }
  return true;
}

std::string difference(const std::vector<std::string>& shown,
                       const std::vector<std::string>& printed, bool from_start) {
  const std::vector<std::string> a = without_empty_lines(shown), b = without_empty_lines(printed);
  std::size_t farthest = 0;
  const std::size_t last = from_start ? 0 : b.size();
  for (std::size_t at = 0; at <= last; ++at)
    if (stands_at(a, 0, b, at, from_start, farthest)) return {};
  if (farthest >= a.size()) return "more is printed than is shown, and no line \"..\" says so";
  return "not printed: " + a[farthest];
}

}  // namespace graze::support
