// One table of a file that a run leaves to be gone on from: typed access to its keys, every one of
// which must be there, with errors that say where and what.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/scene/detail/node.hpp"

namespace graze {

class StateTable {
 public:
  // Throws InputError when the node is no table or holds a key that is not among `keys`.
  StateTable(const Node& node, std::string path, const std::vector<std::string>& keys);

  // All throw InputError at the key, or at the table when the key is missing.
  const Node& at(const std::string& key) const;
  double number(const std::string& key) const;    // finite
  double size(const std::string& key) const;      // finite, >= 0
  long long count(const std::string& key) const;  // >= 0
  bool flag(const std::string& key) const;
  std::string word(const std::string& key) const;
  std::vector<double> numbers(const std::string& key, std::size_t length) const;  // finite
  // >= 0; however many where no length is given.
  std::vector<long long> counts(const std::string& key,
                                std::optional<std::size_t> length = {}) const;
  std::vector<std::string> words(const std::string& key,
                                 std::optional<std::size_t> length = {}) const;
  const NodeList& list(const std::string& key, std::optional<std::size_t> length = {}) const;

  // The key's value, or null.
  const Node* find(const std::string& key) const { return find_member(*table_, key); }
  [[noreturn]] void fail(const std::string& key, const std::string& sentence) const;

 private:
  [[noreturn]] void refuse(const std::string& key, const Node& node, const std::string& what) const;
  double number_at(const std::string& key, const Node& node) const;
  long long count_at(const std::string& key, const Node& node) const;

  const NodeTable* table_ = nullptr;
  std::string path_;
  Place place_;
};

}  // namespace graze
