#include "graze/report/text/detail/line_breaks.hpp"

#include <algorithm>

namespace graze {
namespace {

// The pieces between blanks that are outside of brackets.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ' ' && depth <= 0) {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (words.size() > 1 && words.back().empty()) words.pop_back();
  return words;
}

// Lines of words, each filled up to a width.
std::vector<std::string> filled_lines(const std::vector<std::string>& words, std::size_t width) {
  std::vector<std::string> lines;
  for (const std::string& word : words) {
    if (!lines.empty() && width_of(lines.back()) + 1 + width_of(word) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

std::size_t widest(const std::vector<std::string>& words) {
  std::size_t width = 0;
  for (const std::string& word : words) width = std::max(width, width_of(word));
  return width;
}

// The beginning of a line that is continued: its length that is kept, and the indent of the next
// line.
struct Beginning {
  std::size_t kept = 0, indent = 0;
};

Beginning beginning_of(std::string_view line, std::size_t most) {
  const std::size_t begin = line.find_first_not_of(' ');
  std::size_t kept = begin;
  for (const std::string_view label : {"note: ", "warning: "})
    if (line.substr(begin).starts_with(label)) kept = begin + label.size();
  const std::size_t gap = line.find("  ", begin);
  if (kept == begin && gap != std::string_view::npos) kept = line.find_first_not_of(' ', gap);
  // A wide first column counts as text like the rest.
  return kept == begin || kept > most / 2 ? Beginning{begin, begin + 2} : Beginning{kept, kept};
}

std::string wrapped_line(std::string_view line, std::size_t most) {
  if (width_of(line) <= most || line.find_first_not_of(' ') == std::string_view::npos)
    return std::string(line);
  const Beginning beginning = beginning_of(line, most);
  std::string text(line.substr(0, beginning.kept));
  std::size_t column = width_of(text);
  bool begins = true;
  for (std::size_t at = beginning.kept, end = 0; at < line.size(); at = end + 1) {
    end = std::min(line.find(' ', at), line.size());
    const std::string_view word = line.substr(at, end - at);
    if (word.empty()) continue;
    if (!begins && column + 1 + width_of(word) > most) {
      text += "\n" + std::string(beginning.indent, ' ');
      column = beginning.indent;
      begins = true;
    }
    text.append(begins ? "" : " ").append(word);
    column += (begins ? 0 : 1) + width_of(word);
    begins = false;
  }
  return text;
}

}  // namespace

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::vector<std::string> balanced_lines(const std::string& text, std::size_t most_lines) {
  const std::vector<std::string> words = words_of(text);
  std::size_t width = most_lines == 1 ? width_of(text) : widest(words);
  std::vector<std::string> lines = filled_lines(words, width);
  while (lines.size() > most_lines) lines = filled_lines(words, ++width);
  return lines;
}

std::vector<std::string> list_lines(const std::string& text) {
  std::vector<std::string> lines(1);
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ' ' && depth <= 0 && i > 0 && text[i - 1] == ',')
      lines.emplace_back();
    else
      lines.back() += c;
  }
  return lines;
}

std::string wrapped_text(std::string_view text, std::size_t most) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += wrapped_line(text.substr(0, end), most);
    if (end < text.size()) result += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace graze
