// A text file line by line, with errors that say which line.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "graze/base/errors.hpp"

namespace graze {

// All bytes of a file; throws FileError where it cannot be read.
std::string read_bytes(const std::filesystem::path& file);

// The text without white space at its ends.
std::string_view trimmed(std::string_view text);
bool starts_without_case(std::string_view text, std::string_view start);

class TextLines {
 public:
  // `name` is the file's name in messages. A byte order mark is skipped; throws InputError where it
  // is that of UTF-16.
  TextLines(std::string name, std::string text);

  // Goes to the next line; false at the end.
  bool next();
  // Goes to the next line that is not blank.
  bool next_text();
  std::string_view line() const { return line_; }
  int number() const { return number_; }
  const std::string& name() const { return name_; }

  // Parts of the present line between white space or commas.
  const std::vector<std::string_view>& parts();
  // A number of the present line: finite, with E or D before the exponent, or neither (Nastran).
  double real(std::string_view part) const;
  long integer(std::string_view part) const;

  // "file:line: sentence", of the present line.
  [[noreturn]] void fail(const std::string& sentence) const;
  [[noreturn]] void fail_at(int line, const std::string& sentence) const;

 private:
  std::string name_, text_;
  std::string_view line_;
  std::vector<std::string_view> parts_;
  std::size_t at_ = 0;
  int number_ = 0;
};

}  // namespace graze
