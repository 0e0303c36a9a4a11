#include "graze/scene/detail/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "graze/fem/dof_label.hpp"
#include "graze/scene/check.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/quantity_text.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

[[noreturn]] void fail_at(const Place& place, const std::string& key, const std::string& sentence) {
  throw InputError(place.location(), key, sentence);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "must be" of a node that is something else.
std::string refusal(const Node& node, const std::string& what) {
  return fmt::format("{} is not allowed, it must be {}", node_description(node), what);
}

// Integers serve as reals, and so do quantities in `unit`, if any; nullopt of anything else. Throws
// about `key()` where a quantity is not one of that unit.
std::optional<double> real_value(const Node& node, const std::optional<std::string>& unit,
                                 const auto& key) {
  const auto* text = node.as<std::string>();
  if (text != nullptr && unit && begins_with_number(*text)) {
    const auto value = quantity_in(*text, *unit);
    if (const auto* why = std::get_if<std::string>(&value)) {
      if (why->empty()) return std::nullopt;
      fail_at(node.place, key(),
              fmt::format("{} is not allowed: {}", node_description(node), *why));
    }
    return std::get<double>(value);
  }
  if (const auto* real = node.as<double>()) {
    return *real;
  }
  if (const auto* integer = node.as<std::int64_t>()) {
    return static_cast<double>(*integer);
  }
  return std::nullopt;
}

}  // namespace

std::string key_path(const std::string& table, const std::string& key) {
  return table.empty() ? key_text(key) : table + "." + key_text(key);
}

TableReader::TableReader(const Node& node, std::string path, Origins& origins)
    : table_(node.as<NodeTable>()), path_(std::move(path)), place_(node.place) {
  if (table_ == nullptr) {
    fail_at(place_, path_, refusal(node, "a table"));
  }
  check_keys();
  origins[path_] = place_.location();
  for (const Member& member : *table_) {
    const std::string key = this->path(member.key);
    origins[key] = member.node.place.location();
    if (const auto* list = member.node.as<NodeList>()) {
      for (std::size_t k = 0; k < std::min<std::size_t>(list->size(), kMostModes); ++k) {
        origins[key_path(key, std::to_string(k + 1))] = (*list)[k].place.location();
      }
    }
  }
}

std::string TableReader::title() const {
  if (path_.empty()) {
    return "a scene";
  }
  const std::size_t spring = path_.find(".spring");
  if (path_.starts_with("stop") && spring != std::string::npos) {
    return fmt::format("[stop{}]", path_.substr(spring));
  }
  const std::string table = without_number(path_);
  return is_list_of_tables(table) ? fmt::format("[[{}]]", table) : fmt::format("[{}]", table);
}

void TableReader::check_keys() const {
  const TableKeys& keys = keys_of(path_);
  for (const Member& member : *table_) {
    if (contains(keys.allowed, member.key)) {
      continue;
    }
    // The right key in the wrong table, as when a header is missing, or else a slip.
    std::vector<std::string> meant = keys_named(member.key);
    // A key within another table is not suggested: the mass of a stop is no damping.
    meant.erase(
        std::remove_if(
            meant.begin(), meant.end(),
            [&](const std::string& name) {
              const std::size_t dot = name.rfind('.');
              if (path_.empty() && name.rfind("damping.", 0) != 0 && name.find('.') != dot) {
                return true;
              }
              if (!path_.empty() && is_list_of_tables(name) && dot != std::string::npos)
                return true;
              // A key of strings or bars is suggested as the beam's, unless this table is of a
              // string or bar.
              for (const std::string other : {"string", "bar"})
                if (name.starts_with(other + ".") && !path_.starts_with(other)) return true;
              return !path_.empty() && dot != std::string::npos && name.find('.') != dot &&
                     !name.starts_with(without_number(path_) + ".");
            }),
        meant.end());
    if (const std::string close = closest_name(member.key, keys.allowed);
        meant.empty() && !close.empty()) {
      meant.push_back(path(close));
    }
    fail(member.key, meant.empty() ? fmt::format("there is no such key, {} may hold {}", title(),
                                                 joined(keys.allowed, "and"))
                                   : fmt::format("there is no such key, did you mean {}?",
                                                 joined(meant, "or")));
  }
}

const Node& TableReader::required(const std::string& key, const std::string& what) const {
  const Node* node = find(key);
  if (node == nullptr) {
    fail(key, fmt::format("the key is missing, it must be {}", what));
  }
  return *node;
}

double TableReader::number(const std::string& key, const std::string& what,
                           const std::optional<std::string>& unit) const {
  const std::optional<double> value =
      real_value(required(key, what), unit, [&] { return path(key); });
  if (!value) {
    refuse(key, what);
  }
  return *value;
}

std::int64_t TableReader::integer(const std::string& key, const std::string& what) const {
  const auto* value = required(key, what).as<std::int64_t>();
  if (value == nullptr) {
    refuse(key, what);
  }
  return *value;
}

std::string TableReader::text_or(const std::string& key, const std::string& fallback) const {
  const Node* node = find(key);
  if (node == nullptr) {
    return fallback;
  }
  const auto* text = node->as<std::string>();
  if (text == nullptr) {
    refuse(key, "a string");
  }
  return *text;
}

namespace {

// The numbers of a list, about which `key` tells.
std::vector<double> numbers_of(const NodeList& list, const std::string& key,
                               const std::optional<std::string>& unit) {
  std::vector<double> values;
  values.reserve(list.size());
  for (const Node& entry : list) {
    const auto entry_key = [&] { return key_path(key, std::to_string(values.size() + 1)); };
    const std::optional<double> value = real_value(entry, unit, entry_key);
    if (!value) {
      fail_at(entry.place, entry_key(), refusal(entry, "a number"));
    }
    values.push_back(*value);
  }
  return values;
}

}  // namespace

std::vector<double> TableReader::numbers(const std::string& key, const std::string& what,
                                         const std::optional<std::string>& unit) const {
  const Node* node = find(key);
  if (node == nullptr) {
    return {};
  }
  const auto* list = node->as<NodeList>();
  if (list == nullptr) {
    refuse(key, what);
  }
  return numbers_of(*list, path(key), unit);
}

std::vector<std::vector<double>> TableReader::rows(const std::string& key, const std::string& what,
                                                   const std::optional<std::string>& unit) const {
  const auto* list = required(key, what).as<NodeList>();
  if (list == nullptr) refuse(key, what);
  std::vector<std::vector<double>> rows;
  for (const Node& row : *list) {
    const std::string row_key = key_path(path(key), std::to_string(rows.size() + 1));
    const auto* entries = row.as<NodeList>();
    if (entries == nullptr) fail_at(row.place, row_key, refusal(row, "a row, a list of numbers"));
    rows.push_back(numbers_of(*entries, row_key, unit));
    if (entries->size() != list->size())
      fail_at(row.place, row_key,
              fmt::format("the row has {} entries, it must have {}, as many as there are rows",
                          entries->size(), list->size()));
  }
  return rows;
}

std::vector<std::size_t> TableReader::words(const std::string& key,
                                            const std::vector<std::string>& names,
                                            std::size_t count) const {
  std::vector<std::string> shown;
  for (const std::string& name : names) shown.push_back(quoted(name));
  const std::string what = fmt::format("a list of two words, each {}", joined(shown, "or"));
  const auto* list = required(key, what).as<NodeList>();
  if (list == nullptr || list->size() != count) refuse(key, what);
  std::vector<std::size_t> found;
  for (const Node& entry : *list) {
    const auto* text = entry.as<std::string>();
    const auto name = text == nullptr ? names.end() : std::find(names.begin(), names.end(), *text);
    if (name == names.end())
      fail_at(entry.place, key_path(path(key), std::to_string(found.size() + 1)),
              refusal(entry, joined(shown, "or")));
    found.push_back(static_cast<std::size_t>(name - names.begin()));
  }
  return found;
}

namespace {

constexpr const char* kLabelWords =
    "a degree of freedom, \"node.direction\" or a number like \"7\"";

std::string label_of(const Node& node, const std::string& key, const char* what) {
  if (const auto* number = node.as<std::int64_t>()) return std::to_string(*number);
  const auto* text = node.as<std::string>();
  // The set of nodes, or the mass, that a name stands for is looked up where all are known.
  const bool is_name =
      text && !text->empty() && std::isalpha(static_cast<unsigned char>((*text)[0]));
  if (text == nullptr || (!is_name && !label_from_text(*text)))
    fail_at(node.place, key, refusal(node, what));
  return *text;
}

}  // namespace

std::string TableReader::label(const std::string& key, const char* what) const {
  if (what == nullptr) what = kLabelWords;
  return label_of(required(key, what), path(key), what);
}

std::vector<std::string> TableReader::labels(const std::string& key, const char* what) const {
  std::vector<std::string> values;
  const auto* list = required(key, what ? what : "a list of degrees of freedom").as<NodeList>();
  if (list == nullptr)
    refuse(key, what ? what : "a list of degrees of freedom, like [\"12.3\", \"14.3\"]");
  for (const Node& entry : *list)
    values.push_back(label_of(entry, key_path(path(key), std::to_string(values.size() + 1)),
                              what ? "a number or a name" : kLabelWords));
  return values;
}

std::size_t TableReader::choice_index(const std::string& key,
                                      const std::vector<std::string>& names) const {
  const Node* node = find(key);
  if (node == nullptr) {
    return 0;
  }
  const auto* text = node->as<std::string>();
  const auto found = text == nullptr ? names.end() : std::find(names.begin(), names.end(), *text);
  if (found == names.end()) {
    std::vector<std::string> shown;
    for (const std::string& name : names) {
      shown.push_back(quoted(name));
    }
    refuse(key, joined(shown, "or"));
  }
  return static_cast<std::size_t>(found - names.begin());
}

const NodeList& tables_of(const Node& node, const std::string& name) {
  const auto* list = node.as<NodeList>();
  if (list == nullptr) {
    // A setting has no headers: there the keys of one table are named, or the list is given whole.
    const bool in_setting = node.place.line == 0;
    const std::string way =
        in_setting ? fmt::format(
                         "it must be a list of tables like [{{..}}]; --set {}.1.NAME=VALUE "
                         "sets one key of the first {}",
                         name, name)
                   : fmt::format("{}s must be written [[{}]] in two pairs of brackets", name, name);
    fail_at(node.place, name, fmt::format("{} is not allowed, {}", node_description(node), way));
  }
  return *list;
}

bool TableReader::flag_or(const std::string& key, bool fallback) const {
  const Node* node = find(key);
  if (node == nullptr) {
    return fallback;
  }
  const auto* flag = node->as<bool>();
  if (flag == nullptr) {
    refuse(key, "true or false");
  }
  return *flag;
}

void TableReader::refuse(const std::string& key, const std::string& what) const {
  fail(key, refusal(*find(key), what));
}

void TableReader::fail(const std::string& key, const std::string& sentence) const {
  const Node* node = find(key);
  fail_at(node != nullptr ? node->place : place_, path(key), sentence);
}

}  // namespace graze
