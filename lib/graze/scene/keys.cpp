#include "graze/scene/detail/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "graze/scene/detail/node.hpp"
#include "graze/scene/detail/schema.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

// Collects every key of every table, whatever the scene holds.
class KeyLister : public SchemaVisitor {
 public:
  KeyLister(std::vector<TableKeys>& tables, const std::string& path)
      : tables_(tables), place_(tables.size()) {
    tables_.push_back({path, {}, {}});
  }

  template <class Number>
  void number(const Key& key, const Number& value) {
    if constexpr (std::is_same_v<Number, double>)
      add(key, fmt::format("{:g}", value));
    else
      add(key, "");
  }
  void number_or(const Key& key, const auto&, bool, const char*) { add(key, ""); }
  void list(const Key& key, const auto&) { add(key, ""); }
  void values(const Key& key, const auto&) { add(key, ""); }
  void entries(const Key& key, const auto&, const auto&) { add(key, ""); }
  void series(const Key& key, const auto&) { add(key, ""); }
  void taper(const Key& key, const auto&) { add(key, ""); }
  void ends(const Key& key, const auto&, const auto&, const auto&) { add(key, ""); }
  void bodies(const Key& key, const auto&, BodyNumbers) { add(key, ""); }
  void count(const Key& key, const auto&) { add(key, ""); }
  void text(const Key& key, const auto&) { add(key, ""); }
  void path(const Key& key, const auto&) { add(key, ""); }
  void label(const Key& key, const auto&) { add(key, ""); }
  void labels(const Key& key, const auto&) { add(key, ""); }
  void file(const Key& key, const auto&) { add(key, ""); }
  void flag(const Key& key, bool value) {
    add(key, value ? "`true`" : "`false`", value ? "or `false`" : "or `true`");
  }
  void choice(const Key& key, const auto&, const auto& choices) {
    std::vector<std::string> words;
    for (const auto& choice : choices) words.push_back("`" + quoted(choice.name) + "`");
    const std::string first = words.front();
    if (!key.is_required) words.erase(words.begin());
    add(key, first, (words.size() == 1 ? "or " : "") + joined(words, "or"));
  }
  void table(const TableKey& key, const auto& value) {
    descend<std::remove_cvref_t<decltype(*value)>>(key);
  }
  void leading(const TableKey& key, const auto& first, const auto&) { table(key, first); }
  void tables(const TableKey& key, const auto& values) {
    descend<std::remove_cvref_t<decltype(values[0])>>(key);
  }

 private:
  // `fallback` and `range`: what they are where the key does not say it.
  void add(const Key& key, const std::string& fallback, std::string range = "") {
    if (range.empty() || !key.range.is_checked) range = key.range.in_table;
    own().allowed.push_back(key.name);
    own().rows.push_back(
        {key.name, key.unit, key.fallback ? key.fallback : fallback, range, key.meaning});
  }
  template <class Table>
  void descend(const TableKey& key) {
    own().allowed.push_back(key.name);
    KeyLister inner(tables_, joined_path(own().table, key.name));
    const Table spare{};
    describe(inner, spare, Scene{});
  }
  TableKeys& own() { return tables_[place_]; }

  std::vector<TableKeys>& tables_;
  std::size_t place_;
};

const TableKeys* find_table(const std::string& path) {
  const std::string table = without_number(path);
  const auto found = std::find_if(all_keys().begin(), all_keys().end(),
                                  [&](const TableKeys& keys) { return keys.table == table; });
  return found == all_keys().end() ? nullptr : &*found;
}

}  // namespace

const std::vector<TableKeys>& all_keys() {
  static const std::vector<TableKeys> keys = [] {
    std::vector<TableKeys> tables;
    KeyLister root(tables, "");
    const Scene spare;
    describe(root, spare);
    return tables;
  }();
  return keys;
}

const TableKeys& keys_of(const std::string& path) {
  const TableKeys* keys = find_table(path);
  assert(keys != nullptr);
  return *keys;
}

const KeyRow* key_row(const std::string& path) {
  std::string name = path;
  std::size_t dot = name.rfind('.');
  // An entry of a list, or of a matrix.
  while (dot != std::string::npos &&
         name.find_first_not_of("0123456789", dot + 1) == std::string::npos) {
    name.resize(dot);
    dot = name.rfind('.');
  }
  const TableKeys* keys = find_table(dot == std::string::npos ? "" : name.substr(0, dot));
  if (keys == nullptr) return nullptr;
  const auto row = std::find_if(keys->rows.begin(), keys->rows.end(), [&](const KeyRow& known) {
    return known.name == name.substr(dot + 1);
  });
  return row == keys->rows.end() ? nullptr : &*row;
}

std::vector<std::string> keys_named(const std::string& name) {
  std::vector<std::string> paths;
  for (const TableKeys& keys : all_keys())
    if (std::find(keys.allowed.begin(), keys.allowed.end(), name) != keys.allowed.end())
      paths.push_back(joined_path(keys.table, name));
  return paths;
}

}  // namespace graze
