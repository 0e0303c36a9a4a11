// Errors outside the numerics, as exceptions. A computation that fails returns an outcome with a
// sentence instead of throwing.
#pragma once

#include <stdexcept>
#include <string>

namespace graze {

// Where in a text something stands; line and column count from 1, 0 means "the text as a whole".
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;

  // "file:line:column"
  std::string text() const;
};

// A scene or an option that cannot be used. The program ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  // Reads "file:line:column: key: sentence".
  InputError(const SourceLocation& where, const std::string& key, const std::string& sentence);
};

// A file or folder that cannot be read or written. The program ends with exit code 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace graze
