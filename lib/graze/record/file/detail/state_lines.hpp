// Writes a file that is read back to all its digits (state_table.hpp): lines of TOML.
#pragma once

#include <string>
#include <utility>

#include "graze/scene/detail/node.hpp"

namespace graze {

// "[a, b]"
template <class Range, class Text>
std::string listed(const Range& range, Text text) {
  std::string entries;
  for (const auto& entry : range) entries += (entries.empty() ? "" : ", ") + text(entry);
  return "[" + entries + "]";
}

class StateLines {
 public:
  StateLines() = default;
  explicit StateLines(const std::string& comment) : text_("# " + comment + "\n") {}

  // "[motion]"
  void table(const std::string& header) { text_ += "\n" + header + "\n"; }
  void text(const std::string& key, const std::string& value) {
    text_ += key + " = " + value + "\n";
  }
  void word(const std::string& key, const std::string& value) { text(key, quoted(value)); }
  void number(const std::string& key, double value) { text(key, real_text(value)); }
  void count(const std::string& key, long long value) { text(key, std::to_string(value)); }
  void flag(const std::string& key, bool value) { text(key, value ? "true" : "false"); }
  template <class Range>
  void numbers(const std::string& key, const Range& values) {
    text(key, listed(values, real_text));
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace graze
