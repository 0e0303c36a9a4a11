// One table of the scene file: typed access to its keys, with errors that say where and what.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/scene/detail/node.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// "beam.length" from "beam" and "length", as messages show it; the root table has no name.
std::string key_path(const std::string& table, const std::string& key);

// The tables of [[name]], "stop" or "beam.piece"; throws InputError where the node is no list.
const NodeList& tables_of(const Node& node, const std::string& name);

// Remembers in `origins` where each key it is asked for stands. Every function throws InputError at
// the key (or at the table, when the key is missing).
class TableReader {
 public:
  // Throws when the node is no table, or holds a key that keys_of(path) does not.
  TableReader(const Node& node, std::string path, Origins& origins);

  std::string path(const std::string& key) const { return key_path(path_, key); }
  bool has(const std::string& key) const { return find(key) != nullptr; }
  // The key's value, or null.
  const Node* find(const std::string& key) const { return find_member(*table_, key); }
  // The key's value. `what` is what it must be, as in "a number in m".
  const Node& required(const std::string& key, const std::string& what) const;

  // `unit`: in which the number is wanted where it is given with one of its own, "1.05 mm";
  // nullopt: it cannot be.
  double number(const std::string& key, const std::string& what,
                const std::optional<std::string>& unit = {}) const;
  std::int64_t integer(const std::string& key, const std::string& what) const;
  bool flag_or(const std::string& key, bool fallback) const;
  std::string text_or(const std::string& key, const std::string& fallback) const;
  // A degree of freedom, "12.3" or "7", or the integer 7, or a name; a list of these. `what`: what
  // it must be, null: a degree of freedom.
  std::string label(const std::string& key, const char* what = nullptr) const;
  std::vector<std::string> labels(const std::string& key, const char* what = nullptr) const;
  // The list of numbers, with `unit` as above; empty when the key is missing.
  std::vector<double> numbers(const std::string& key, const std::string& what,
                              const std::optional<std::string>& unit = {}) const;

  // The list of lists of numbers, likewise.
  std::vector<std::vector<double>> rows(const std::string& key, const std::string& what,
                                        const std::optional<std::string>& unit = {}) const;

  // Which of the names each of `count` words in a list is.
  std::vector<std::size_t> words(const std::string& key, const std::vector<std::string>& names,
                                 std::size_t count) const;

  // The value whose name the key gives, the first choice when the key is missing.
  template <typename Choice>
  Choice choice(const std::string& key,
                const std::vector<std::pair<std::string, Choice>>& choices) const {
    return choices[choice_index(key, choices)].second;
  }

  // Throws about the key: "the number -1 is not allowed, it must be <what>".
  [[noreturn]] void refuse(const std::string& key, const std::string& what) const;
  [[noreturn]] void fail(const std::string& key, const std::string& sentence) const;

 private:
  std::size_t choice_index(const std::string& key, const std::vector<std::string>& names) const;
  template <typename Choice>
  std::size_t choice_index(const std::string& key,
                           const std::vector<std::pair<std::string, Choice>>& choices) const {
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
      names.push_back(name);
    }
    return choice_index(key, names);
  }
  void check_keys() const;
  // "[beam]" or "a scene", for lists of what is allowed.
  std::string title() const;

  const NodeTable* table_ = nullptr;
  std::string path_;
  Place place_;
};

}  // namespace graze
