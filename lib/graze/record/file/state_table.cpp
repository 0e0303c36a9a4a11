#include "graze/record/file/detail/state_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {

StateTable::StateTable(const Node& node, std::string path, const std::vector<std::string>& keys)
    : table_(node.as<NodeTable>()), path_(std::move(path)), place_(node.place) {
  if (!table_)
    throw InputError(place_.location(), path_,
                     fmt::format("{} is not allowed, it must be a table", node_description(node)));
  for (const Member& member : *table_)
    if (std::find(keys.begin(), keys.end(), member.key) == keys.end())
      fail(member.key, "there is no such key in this file");
}

void StateTable::fail(const std::string& key, const std::string& sentence) const {
  const Node* node = find(key);
  throw InputError((node ? node->place : place_).location(),
                   path_.empty() ? key_text(key) : path_ + "." + key_text(key), sentence);
}

void StateTable::refuse(const std::string& key, const Node& node, const std::string& what) const {
  fail(key, fmt::format("{} is not allowed, it must be {}", node_description(node), what));
}

const Node& StateTable::at(const std::string& key) const {
  const Node* node = find(key);
  if (!node) fail(key, "the key is missing, the file is not whole");
  return *node;
}

double StateTable::number_at(const std::string& key, const Node& node) const {
  const auto* real = node.as<double>();
  if (!real || !std::isfinite(*real)) refuse(key, node, "a finite real number");
  return *real;
}

long long StateTable::count_at(const std::string& key, const Node& node) const {
  const auto* count = node.as<std::int64_t>();
  if (!count || *count < 0) refuse(key, node, "a whole number, 0 or more");
  return *count;
}

double StateTable::number(const std::string& key) const { return number_at(key, at(key)); }

double StateTable::size(const std::string& key) const {
  const double value = number(key);
  if (value < 0.0) refuse(key, at(key), "0 or more");
  return value;
}

long long StateTable::count(const std::string& key) const { return count_at(key, at(key)); }

bool StateTable::flag(const std::string& key) const {
  const auto* value = at(key).as<bool>();
  if (!value) refuse(key, at(key), "true or false");
  return *value;
}

std::string StateTable::word(const std::string& key) const {
  const auto* value = at(key).as<std::string>();
  if (!value) refuse(key, at(key), "a string");
  return *value;
}

const NodeList& StateTable::list(const std::string& key, std::optional<std::size_t> length) const {
  const auto* entries = at(key).as<NodeList>();
  if (!entries) refuse(key, at(key), "a list");
  if (length && entries->size() != *length)
    fail(key, fmt::format("the list has {} entries, those of this scene have {}", entries->size(),
                          *length));
  return *entries;
}

std::vector<double> StateTable::numbers(const std::string& key, std::size_t length) const {
  std::vector<double> values;
  for (const Node& entry : list(key, length)) values.push_back(number_at(key, entry));
  return values;
}

std::vector<long long> StateTable::counts(const std::string& key,
                                          std::optional<std::size_t> length) const {
  std::vector<long long> values;
  for (const Node& entry : list(key, length)) values.push_back(count_at(key, entry));
  return values;
}

std::vector<std::string> StateTable::words(const std::string& key,
                                           std::optional<std::size_t> length) const {
  std::vector<std::string> values;
  for (const Node& entry : list(key, length)) {
    const auto* word = entry.as<std::string>();
    if (!word) refuse(key, entry, "a string");
    values.push_back(*word);
  }
  return values;
}

}  // namespace graze
