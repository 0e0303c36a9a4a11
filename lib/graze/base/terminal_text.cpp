#include "graze/base/terminal_text.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace graze {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  // 0: the first byte begins no UTF-8 character
};

// The first character of a text that is not empty; overlong forms and surrogates are none.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {};
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  const std::uint32_t least = bytes == 4 ? 0x10000 : bytes == 3 ? 0x800 : 0x80;
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < least || code > 0x10FFFF || surrogate) return {};
  return {code, bytes};
}

bool is_in(std::uint32_t code, std::uint32_t first, std::uint32_t last) {
  return code >= first && code <= last;
}

// Whether a terminal would act on the character instead of showing it.
bool is_obeyed(std::uint32_t code) {
  return code < 0x20 || is_in(code, 0x7F, 0x9F) || is_in(code, 0x200B, 0x200F) ||
         is_in(code, 0x2028, 0x202E) || is_in(code, 0x2060, 0x206F) || code == 0xFEFF;
}

template <class Stays, class Escape>
std::string escaped(std::string_view text, Stays stays, Escape escape) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t bytes = character.bytes == 0 ? 1 : character.bytes;
    if (character.bytes == 0)
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else if (!is_obeyed(character.code) || stays(character.code))
      result += text.substr(0, bytes);
    else
      result += escape(character.code);
    text.remove_prefix(bytes);
  }
  return result;
}

std::string shown(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\t') return "\\t";
  return code < 0x80 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
}

bool is_layout(std::uint32_t code) { return code == '\n' || code == '\t'; }

}  // namespace

std::string terminal_text(std::string_view text) { return escaped(text, is_layout, shown); }

std::string terminal_line(std::string_view text) {
  return escaped(
      text, [](std::uint32_t) { return false; }, shown);
}

std::string terminal_json(std::string_view json) {
  return escaped(json, is_layout,
                 [](std::uint32_t code) { return fmt::format("\\u{:04x}", code); });
}

}  // namespace graze
