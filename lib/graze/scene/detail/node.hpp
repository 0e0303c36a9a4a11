// A TOML document as plain values, each with the place at which it was written. The reader works on
// this tree, so that settings can change it and toml++ stays inside document.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "graze/base/errors.hpp"

namespace graze {

struct Node;
struct Member;
using NodeList = std::vector<Node>;
using NodeTable = std::vector<Member>;  // in the order of the text

// A TOML value that no scene uses (dates and times).
struct UnusedValue {
  std::string name;  // "a date"
};

// Where a value stands: for the value of a key, where the key stands.
struct Place {
  std::shared_ptr<const std::string> file;
  int line = 0;
  int column = 0;

  SourceLocation location() const { return {file ? *file : std::string(), line, column}; }
};

struct Node {
  std::variant<bool, std::int64_t, double, std::string, UnusedValue, NodeList, NodeTable> value;
  Place place;

  template <typename T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
  template <typename T>
  T* as() {
    return std::get_if<T>(&value);
  }
};

struct Member {
  std::string key;
  Node node;
};

// The member of that name, or null.
Node* find_member(NodeTable& table, const std::string& key);
const Node* find_member(const NodeTable& table, const std::string& key);

// "the string \"0.3\"", "the integer 3", "a list", ..: the node as a message names it.
std::string node_description(const Node& node);

// True when TOML needs no quotes around the key.
bool is_bare_key(std::string_view key);

// A key as a message shows it: quoted where it must be, cut where it is long.
std::string key_text(const std::string& key);

// The shortest text that reads back to the same double; a point or exponent marks it as a real.
std::string real_text(double value);

// `text` in double quotes as TOML writes it, control characters escaped.
std::string quoted(const std::string& text);

}  // namespace graze
