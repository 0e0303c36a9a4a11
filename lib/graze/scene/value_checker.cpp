#include "graze/scene/value_checker.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace graze {
namespace {

bool is_kept(double value, const Range& range) {
  return !range.is_checked || (range.holds(value) && std::abs(value) <= kLargestNumber);
}

}  // namespace

ValueChecker::ValueChecker(const Scene& scene, std::string table)
    : scene_(scene), table_(std::move(table)) {}

void ValueChecker::fail(const std::string& key, const std::string& sentence) const {
  throw scene_error(scene_, table_ + "." + key, sentence);
}

void ValueChecker::refuse(const std::string& key, double value, const std::string& what) const {
  fail(key, fmt::format("{} is not allowed, it must be {}", value, what));
}

void ValueChecker::refuse_number(const std::string& key, double value, const Range& range) const {
  if (range.holds(value))
    fail(key, fmt::format("{} is not allowed, numbers must be at most {:.1e} in size, since "
                          "squares of larger ones overflow",
                          value, kLargestNumber));
  refuse(key, value,
         fmt::format("a {}number{}{}", range.is_bounded() ? "" : "finite ", *range.words ? " " : "",
                     range.words));
}

void ValueChecker::number(const char* key, double value, const Range& range) const {
  if (!is_kept(value, range)) refuse_number(key, value, range);
}

void ValueChecker::entry(const char* key, std::size_t k, double value, const Range& range) const {
  if (!is_kept(value, range)) refuse_number(fmt::format("{}.{}", key, k), value, range);
}

void ValueChecker::usable(const char* key, double value, const char* what) const {
  if (value > 0.0 && value <= kLargestNumber) return;
  fail(key, fmt::format("with this value {} is {}, it must be greater than 0 and at most {:.1e}",
                        what, value, kLargestNumber));
}

void ValueChecker::entries(const char* key, const std::vector<double>& values, int modes,
                           const Range& range) const {
  if (values.size() != static_cast<std::size_t>(modes)) {
    fail(key, fmt::format("the list has {}, it must have one per mode, which is {}",
                          values.size() == 1 ? std::string("1 entry")
                                             : fmt::format("{} entries", values.size()),
                          modes));
  }
  for (std::size_t k = 0; k < values.size(); ++k) entry(key, k + 1, values[k], range);
}

}  // namespace graze
