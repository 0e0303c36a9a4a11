#include "graze/scene/detail/text_check.hpp"

#include <fmt/format.h>

#include <string_view>

#include "graze/base/errors.hpp"
#include "graze/scene/detail/node.hpp"

namespace graze {
namespace {

// The deepest key of a scene is damping.rayleigh.mass inside one pair of braces.
constexpr std::size_t kDeepest = 32;

// Walks through a text and counts line and column (in characters, from 1).
struct Cursor {
  const std::string& text;
  const std::string& name;
  std::size_t at = 0;
  int line = 1;
  int column = 1;

  bool ended() const { return at >= text.size(); }
  unsigned char byte(std::size_t ahead = 0) const {
    return at + ahead < text.size() ? static_cast<unsigned char>(text[at + ahead]) : 0;
  }
  bool starts(std::string_view word) const { return text.compare(at, word.size(), word) == 0; }

  void step(std::size_t bytes = 1) {
    for (; bytes > 0 && !ended(); --bytes, ++at) {
      if (text[at] == '\n') {
        ++line;
        column = 1;
      } else if ((byte() & 0xC0) != 0x80) {
        ++column;
      }
    }
  }
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(SourceLocation{name, line, column}, "toml", sentence);
  }
};

// Bytes of the UTF-8 sequence that starts here, 0 if there is none. The second byte's range rules
// out overlong forms, surrogates and numbers above U+10FFFF.
std::size_t sequence_length(const Cursor& cursor) {
  const unsigned char first = cursor.byte();
  if (first < 0x80) {
    return 1;
  }
  std::size_t length = 0;
  unsigned char low = 0x80;
  unsigned char high = 0xBF;
  if (first >= 0xC2 && first <= 0xDF) {
    length = 2;
  } else if (first >= 0xE0 && first <= 0xEF) {
    length = 3;
    low = first == 0xE0 ? 0xA0 : 0x80;
    high = first == 0xED ? 0x9F : 0xBF;
  } else if (first >= 0xF0 && first <= 0xF4) {
    length = 4;
    low = first == 0xF0 ? 0x90 : 0x80;
    high = first == 0xF4 ? 0x8F : 0xBF;
  }
  for (std::size_t k = 1; k < length; ++k) {
    const unsigned char next = cursor.byte(k);
    if (next < low || next > high) {
      return 0;
    }
    low = 0x80;
    high = 0xBF;
  }
  return length;
}

void check_encoding(Cursor cursor) {
  if (cursor.starts("\xEF\xBB\xBF")) {
    cursor.fail("the text starts with a byte order mark, it must be plain UTF-8 without one");
  }
  if (cursor.starts("\xFF\xFE") || cursor.starts("\xFE\xFF")) {
    cursor.fail("the text is UTF-16, it must be plain UTF-8");
  }
  while (!cursor.ended()) {
    const unsigned char byte = cursor.byte();
    const std::size_t length = sequence_length(cursor);
    const bool control =
        byte == 0x7F || (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r');
    if (length == 0 || control) {
      cursor.fail(fmt::format("the byte 0x{:02X} is not text, a scene must be plain UTF-8", byte));
    }
    cursor.step(length);
  }
}

// Moves past a string, as far as it goes where it is not closed.
void skip_string(Cursor& cursor) {
  const char quote = static_cast<char>(cursor.byte());
  const bool escapes = quote == '"';
  const std::string fence(3, quote);
  const bool many_lines = cursor.starts(fence);
  cursor.step(many_lines ? 3 : 1);
  while (!cursor.ended()) {
    if (escapes && cursor.byte() == '\\') {
      cursor.step(2);
    } else if (many_lines && cursor.starts(fence)) {
      cursor.step(3);
      // Up to two quotes before the closing three belong to the string.
      for (int k = 0; k < 2 && cursor.byte() == static_cast<unsigned char>(quote); ++k) {
        cursor.step();
      }
      return;
    } else if (!many_lines &&
               (cursor.byte() == static_cast<unsigned char>(quote) || cursor.byte() == '\n')) {
      cursor.step();
      return;
    } else {
      cursor.step();
    }
  }
}

void skip_line(Cursor& cursor) {
  while (!cursor.ended() && cursor.byte() != '\n') {
    cursor.step();
  }
}

// A table header must begin with its name, [[ ]] and [ ] alike.
void check_header(Cursor cursor) {
  cursor.step(cursor.starts("[[") ? 2 : 1);
  while (cursor.byte() == ' ' || cursor.byte() == '\t') {
    cursor.step();
  }
  const char first = static_cast<char>(cursor.byte());
  if (!is_bare_key(std::string_view(&first, 1)) && first != '"' && first != '\'') {
    cursor.fail("the table header has no name, it must read like [beam] or [[stop]]");
  }
}

// Outside strings and comments: only ASCII, headers with a name, brackets in pairs, bounded
// nesting.
void check_structure(Cursor cursor) {
  std::string open;  // the brackets that wait for their other half
  std::size_t dots = 0;
  bool line_begins = true;
  while (!cursor.ended()) {
    const unsigned char byte = cursor.byte();
    if (byte == '"' || byte == '\'') {
      skip_string(cursor);
      line_begins = false;
      continue;
    }
    if (byte == '#') {
      skip_line(cursor);
      continue;
    }
    if (byte >= 0x80) {
      cursor.fail("a character outside ASCII stands here, it must be inside quotes or a comment");
    }
    if (byte == '[' && line_begins && open.empty()) {
      check_header(cursor);
    }
    line_begins = byte == '\n' || (line_begins && (byte == ' ' || byte == '\t' || byte == '\r'));
    const bool opens = byte == '[' || byte == '{';
    const bool closes = byte == ']' || byte == '}';
    const bool separates = opens || closes || byte == ',' || byte == '=' || byte == '\n';
    if (opens) {
      open += byte == '[' ? ']' : '}';
    } else if (closes && !open.empty()) {
      if (static_cast<char>(byte) != open.back()) {
        cursor.fail(fmt::format("the bracket {} closes nothing here, it must be {}",
                                static_cast<char>(byte), open.back()));
      }
      open.pop_back();
    }
    dots = separates ? 0 : (byte == '.' ? dots + 1 : dots);
    if (open.size() > kDeepest || dots > kDeepest) {
      cursor.fail(fmt::format("tables and lists nest too deep here, at most {} levels are allowed",
                              kDeepest));
    }
    cursor.step();
  }
}

}  // namespace

void check_text(const std::string& text, const std::string& name) {
  const Cursor start{text, name};
  if (text.size() > kLargestText) {
    start.fail("the text is larger than 16 MiB, a scene must be smaller");
  }
  check_encoding(start);
  check_structure(start);
}

}  // namespace graze
