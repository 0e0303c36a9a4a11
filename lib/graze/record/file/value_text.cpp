#include "graze/record/file/detail/value_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

namespace graze {
namespace {

constexpr std::string_view kInfinite = "\"inf\"", kMinusInfinite = "\"-inf\"";
constexpr std::string_view kNoNumber = "\"nan\"", kMinusNoNumber = "\"-nan\"";

template <class T>
T number_of(std::string_view word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) throw UnreadableText();
  return value;
}

}  // namespace

void TextWriter::separate() {
  if (!is_first_) text_ += ',';
  is_first_ = false;
}

void TextWriter::open() {
  separate();
  text_ += '[';
  is_first_ = true;
}

void TextWriter::close() {
  text_ += ']';
  is_first_ = false;
}

void TextWriter::word(std::string_view text) {
  separate();
  text_ += text;
}

void TextWriter::whole(long long value) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", value);
}

void TextWriter::real(double value) {
  if (std::isfinite(value)) {
    separate();
    fmt::format_to(std::back_inserter(text_), "{}", value);
  } else if (std::isnan(value)) {
    word(std::signbit(value) ? kMinusNoNumber : kNoNumber);
  } else {
    word(value > 0.0 ? kInfinite : kMinusInfinite);
  }
}

void TextWriter::quoted(const std::string& text) {
  separate();
  text_ += '"';
  for (const char letter : text) {
    if (letter == '"' || letter == '\\')
      text_ += '\\', text_ += letter;
    else if (static_cast<unsigned char>(letter) < 0x20)
      fmt::format_to(std::back_inserter(text_), "\\u{:04x}", static_cast<unsigned>(letter));
    else
      text_ += letter;
  }
  text_ += '"';
}

void TextReader::take(char expected) {
  if (left_.empty() || left_.front() != expected) throw UnreadableText();
  left_.remove_prefix(1);
}

void TextReader::separate() {
  if (!is_first_) take(',');
  is_first_ = false;
}

void TextReader::open() {
  separate();
  take('[');
  is_first_ = true;
}

void TextReader::close() {
  take(']');
  is_first_ = false;
}

bool TextReader::has_more() const { return !left_.empty() && left_.front() != ']'; }

// The text up to the next comma or bracket.
std::string_view TextReader::word() {
  separate();
  const std::string_view word = left_.substr(0, left_.find_first_of(",]"));
  left_.remove_prefix(word.size());
  return word;
}

bool TextReader::flag() {
  const std::string_view text = word();
  if (text != "true" && text != "false") throw UnreadableText();
  return text == "true";
}

template <std::integral T>
T TextReader::whole() {
  return number_of<T>(word());
}
template int TextReader::whole<int>();
template unsigned TextReader::whole<unsigned>();
template long TextReader::whole<long>();
template unsigned long TextReader::whole<unsigned long>();
template long long TextReader::whole<long long>();

double TextReader::real() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::string_view text = word();
  if (text.empty() || text.front() != '"') {
    const double value = number_of<double>(text);
    if (!std::isfinite(value)) throw UnreadableText();
    return value;
  }
  if (text == kInfinite) return kInfinity;
  if (text == kMinusInfinite) return -kInfinity;
  if (text == kNoNumber) return kNan;
  if (text == kMinusNoNumber) return -kNan;
  throw UnreadableText();
}

std::string TextReader::quoted() {
  constexpr std::size_t kCode = 5;  // letters of "u001f"
  separate();
  take('"');
  std::string text;
  for (;;) {
    const std::size_t plain = left_.find_first_of("\"\\");
    if (plain == std::string_view::npos) throw UnreadableText();
    text += left_.substr(0, plain);
    const bool ends = left_[plain] == '"';
    left_.remove_prefix(plain + 1);
    if (ends) return text;
    if (left_.empty()) throw UnreadableText();
    if (left_.front() != 'u') {
      text += left_.front();
      left_.remove_prefix(1);
      continue;
    }
    if (left_.size() < kCode) throw UnreadableText();
    unsigned code = 0;
    const auto [end, error] = std::from_chars(left_.data() + 1, left_.data() + kCode, code, 16);
    if (error != std::errc() || end != left_.data() + kCode || code >= 0x20) throw UnreadableText();
    text += static_cast<char>(code);
    left_.remove_prefix(kCode);
  }
}

}  // namespace graze
