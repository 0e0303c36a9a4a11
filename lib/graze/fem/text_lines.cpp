#include "graze/fem/detail/text_lines.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "graze/base/detail/named_pipe.hpp"

namespace graze {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The number in C++ form: 1.5D+3 and 1.5+3 become 1.5e+3.
std::string plain_number(std::string_view part) {
  std::string text;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const char c = part[i];
    const bool sign = c == '+' || c == '-';
    if (sign && i == 0 && c == '+') continue;
    const bool bare = sign && i > 0 &&
                      (std::isdigit(static_cast<unsigned char>(part[i - 1])) || part[i - 1] == '.');
    if (bare) text += 'e';
    text += lower(c) == 'd' ? 'e' : c;
  }
  return text;
}

}  // namespace

std::string read_bytes(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code no_matter;  // ignored: a file that cannot be inspected cannot be opened either
  if (std::filesystem::is_directory(file, no_matter))
    throw FileError(fmt::format("{}: cannot be read as a matrix, it is a directory", name));
  if (is_named_pipe(file))
    throw InputError(fmt::format(
        "{}: cannot be read as a matrix, it is a named pipe and no regular file", name));
  errno = 0;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream)
    throw FileError(fmt::format("{}: cannot be read, {}", name,
                                errno != 0 ? std::strerror(errno) : "it cannot be opened"));
  std::string bytes(static_cast<std::size_t>(std::max<std::streamoff>(0, stream.tellg())), '\0');
  stream.seekg(0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw FileError(fmt::format("{}: cannot be read to its end", name));
  return bytes;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

bool starts_without_case(std::string_view text, std::string_view start) {
  if (text.size() < start.size()) return false;
  for (std::size_t i = 0; i < start.size(); ++i)
    if (lower(text[i]) != lower(start[i])) return false;
  return true;
}

TextLines::TextLines(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF"))
    fail_at(0, "the text is UTF-16, it must be UTF-8 or ASCII");
}

bool TextLines::next() {
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  line_ = std::string_view(text_).substr(at_, end - at_);
  if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
  at_ = end + 1;
  ++number_;
  return true;
}

bool TextLines::next_text() {
  while (next())
    if (!trimmed(line_).empty()) return true;
  return false;
}

const std::vector<std::string_view>& TextLines::parts() {
  parts_.clear();
  const auto parting = [](char c) { return is_space(c) || c == ','; };
  for (std::size_t i = 0; i < line_.size();) {
    while (i < line_.size() && parting(line_[i])) ++i;
    const std::size_t begin = i;
    while (i < line_.size() && !parting(line_[i])) ++i;
    if (i > begin) parts_.push_back(line_.substr(begin, i - begin));
  }
  return parts_;
}

double TextLines::real(std::string_view part) const {
  double value = 0.0;
  auto [at, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error != std::errc{} || at != part.data() + part.size()) {
    const std::string text = plain_number(part);
    const auto again = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || again.ec == std::errc::invalid_argument ||
        again.ptr != text.data() + text.size())
      fail(fmt::format("\"{}\" is not allowed, it must be a number", part));
    if (again.ec == std::errc::result_out_of_range)
      fail(fmt::format("the number {} is too large or too small for a double", part));
  }
  if (!std::isfinite(value))
    fail(fmt::format("the number {} is not allowed, it must be finite", part));
  return value;
}

long TextLines::integer(std::string_view part) const {
  long value = 0;
  if (!part.empty() && part.front() == '+') part.remove_prefix(1);
  const auto [at, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (part.empty() || error != std::errc{} || at != part.data() + part.size())
    fail(fmt::format("\"{}\" is not allowed, it must be an integer", part));
  return value;
}

void TextLines::fail(const std::string& sentence) const { fail_at(number_, sentence); }

void TextLines::fail_at(int line, const std::string& sentence) const {
  throw InputError(line == 0 ? fmt::format("{}: {}", name_, sentence)
                             : fmt::format("{}:{}: {}", name_, line, sentence));
}

}  // namespace graze
