#include "graze/scene/detail/table_paths.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace graze {
namespace {

constexpr const char* kLists[] = {
    "stop",        "probe",         "beam.piece",       "beam.support",   "beam.mass",
    "string.mass", "bar.piece",     "bar.support",      "string.support", "bar.mass",
    "load",        "lumped.spring", "lumped.gyroscopic"};

// A table, or the first of several.
constexpr const char* kMayBeList = "forcing";

// The path without the number of its table, where `leave` returns true for that number.
std::string shortened(const std::string& path, auto&& leave) {
  std::vector<std::string> lists(std::begin(kLists), std::end(kLists));
  lists.emplace_back(kMayBeList);
  for (const std::string& list : lists) {
    if (path.compare(0, list.size() + 1, list + ".") != 0) continue;
    const std::size_t begin = list.size() + 1;
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string number = path.substr(begin, end - begin);
    if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) continue;
    if (leave(number)) return list + path.substr(end);
  }
  return path;
}

}  // namespace

std::string joined_path(const std::string& table, const std::string& key) {
  return table.empty() ? key : table + "." + key;
}

bool is_list_of_tables(const std::string& path) {
  return std::find(std::begin(kLists), std::end(kLists), path) != std::end(kLists);
}

bool may_be_list_of_tables(const std::string& path) { return path == kMayBeList; }

std::string without_number(const std::string& path) {
  return shortened(path, [](const std::string&) { return true; });
}

std::string first_unnumbered(const std::string& path) {
  return shortened(path, [](const std::string& number) { return number == "1"; });
}

std::string numbered_path(const std::string& name, std::size_t number) {
  return number == 1 ? name : name + "." + std::to_string(number);
}

}  // namespace graze
