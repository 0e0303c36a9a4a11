#include "graze/scene/detail/node.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze {
namespace {

// Longer strings are cut in messages.
constexpr std::size_t kShownBytes = 60;

std::string shortened(const std::string& text) {
  if (text.size() <= kShownBytes) {
    return text;
  }
  std::size_t end = kShownBytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
    --end;  // never inside a UTF-8 sequence
  }
  return text.substr(0, end) + "..";
}

struct Describe {
  std::string operator()(bool flag) const { return flag ? "the value true" : "the value false"; }
  std::string operator()(std::int64_t number) const {
    return fmt::format("the integer {}", number);
  }
  std::string operator()(double number) const { return "the number " + real_text(number); }
  std::string operator()(const std::string& text) const {
    return fmt::format("the string {}", quoted(shortened(text)));
  }
  std::string operator()(const UnusedValue& value) const { return value.name; }
  std::string operator()(const NodeList&) const { return "a list"; }
  std::string operator()(const NodeTable&) const { return "a table"; }
};

}  // namespace

const Node* find_member(const NodeTable& table, const std::string& key) {
  for (const Member& member : table) {
    if (member.key == key) {
      return &member.node;
    }
  }
  return nullptr;
}

Node* find_member(NodeTable& table, const std::string& key) {
  return const_cast<Node*>(find_member(static_cast<const NodeTable&>(table), key));
}

std::string node_description(const Node& node) { return std::visit(Describe(), node.value); }

bool is_bare_key(std::string_view key) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), allowed);
}

std::string key_text(const std::string& key) {
  return is_bare_key(key) && key.size() <= kShownBytes ? key : quoted(shortened(key));
}

std::string real_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) {
    text += ".0";
  }
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (c == '\t') {
      result += "\\t";
    } else if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace graze
