// Values as text that reads back to the last bit: numbers, words and lists of them, as in JSON.
// Writing and reading use the same description: `archive(member)` for one member after the other,
// by `fields` (fields.hpp) where a type has its own, else for all its members (members.hpp).
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

#include "graze/record/file/detail/members.hpp"

namespace graze {

template <class Archive, class Value>
void visit_value(Archive& archive, Value& value) {
  if constexpr (requires { fields(archive, value); })
    fields(archive, value);
  else
    with_members(value, [&](auto&... members) { (archive(members), ...); });
}

// Not finite numbers are "inf", "-inf" and "nan", for which JSON has no words.
class TextWriter {
 public:
  static constexpr bool kReads = false;

  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      word(value ? "true" : "false");
    } else if constexpr (std::is_enum_v<T>) {
      whole(static_cast<long long>(value));
    } else if constexpr (std::is_integral_v<T>) {
      whole(static_cast<long long>(value));
    } else if constexpr (std::is_same_v<T, double>) {
      real(value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      quoted(value);
    } else {
      open();
      // A written value is not changed.
      visit_value(*this, const_cast<T&>(value));
      close();
    }
  }
  std::string take() { return std::move(text_); }

 private:
  void word(std::string_view text);
  void whole(long long value);
  void real(double value);
  void quoted(const std::string& text);
  void open();
  void close();
  void separate();

  std::string text_;
  bool is_first_ = true;  // of its list
};

// Thrown for text that is no such value.
struct UnreadableText {};

// All functions throw UnreadableText where the text holds something else.
class TextReader {
 public:
  static constexpr bool kReads = true;

  // Refers to the text.
  explicit TextReader(std::string_view text) : left_(text) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = flag();
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(whole<std::underlying_type_t<T>>());
    } else if constexpr (std::is_integral_v<T>) {
      value = whole<T>();
    } else if constexpr (std::is_same_v<T, double>) {
      value = real();
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = quoted();
    } else {
      open();
      visit_value(*this, value);
      close();
    }
  }
  // Whether the list that is being read goes on.
  bool has_more() const;
  bool is_at_end() const { return left_.empty(); }

 private:
  template <std::integral T>
  T whole();
  std::string_view word();
  bool flag();
  double real();
  std::string quoted();
  void open();
  void close();
  void separate();
  void take(char expected);

  std::string_view left_;
  bool is_first_ = true;
};

template <class Value>
std::string value_text(const Value& value) {
  TextWriter writer;
  writer(value);
  return writer.take();
}

// Reads the output of `value_text`. False for any other text.
template <class Value>
bool read_value(std::string_view text, Value& value) {
  try {
    TextReader reader(text);
    reader(value);
    return reader.is_at_end();
  } catch (const UnreadableText&) {
    return false;
  }
}

}  // namespace graze
