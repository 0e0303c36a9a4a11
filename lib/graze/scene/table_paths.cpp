#include "graze/scene/detail/table_paths.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace graze {
namespace {

constexpr const char* kLists[] = {
    "stop",        "probe",         "beam.piece",        "beam.support",   "beam.mass",
    "string.mass", "bar.piece",     "bar.support",       "string.support", "bar.mass",
    "load",        "lumped.spring", "lumped.gyroscopic", "friction"};

// A table, or the first of several.
constexpr const char* kMayBeLists[] = {"forcing", "stop.motion"};

bool is_among(const auto& lists, const std::string& path) {
  return std::find(std::begin(lists), std::end(lists), path) != std::end(lists);
}

// The path without the numbers of its tables for which `leave` returns true.
std::string shortened(const std::string& path, auto&& leave) {
  std::string kept, plain;  // plain: without any number
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string part = path.substr(begin, end - begin);
    begin = end + 1;
    const bool is_number = !part.empty() && part.find_first_not_of("0123456789") == part.npos;
    const bool of_table = is_number && (is_among(kLists, plain) || is_among(kMayBeLists, plain));
    if (!of_table) plain = joined_path(plain, part);
    if (!of_table || !leave(part)) kept = joined_path(kept, part);
  }
  return kept;
}

}  // namespace

std::string joined_path(const std::string& table, const std::string& key) {
  return table.empty() ? key : table + "." + key;
}

bool is_list_of_tables(const std::string& path) {
  return is_among(kLists, without_number(path));
}

bool may_be_list_of_tables(const std::string& path) {
  return is_among(kMayBeLists, without_number(path));
}

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
