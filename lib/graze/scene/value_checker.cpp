#include "graze/scene/detail/value_checker.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace graze {

ValueChecker::ValueChecker(const Scene& scene, std::string table)
    : scene_(scene), table_(std::move(table)) {}

void ValueChecker::fail(const std::string& key, const std::string& sentence) const {
  throw scene_error(scene_, table_ + "." + key, sentence);
}

void ValueChecker::require(bool kept, const std::string& key, double value,
                           const char* what) const {
  if (!kept) fail(key, fmt::format("{} is not allowed, it must be {}", value, what));
}

void ValueChecker::finite(const char* key, double value) const {
  if (!std::isfinite(value)) require(false, key, value, "a finite number");
  not_too_large(key, value);
}

void ValueChecker::positive(const char* key, double value) const {
  if (!std::isfinite(value) || value <= 0.0)
    require(false, key, value, "a finite number greater than 0");
  not_too_large(key, value);
}

void ValueChecker::not_negative(const char* key, double value) const {
  if (!std::isfinite(value) || value < 0.0)
    require(false, key, value, "a finite number of at least 0");
  not_too_large(key, value);
}

void ValueChecker::not_too_large(const std::string& key, double value) const {
  if (std::abs(value) <= kLargestNumber) return;
  fail(key, fmt::format("{} is not allowed, numbers must be at most {:.1e} in size, since squares "
                        "of larger ones overflow",
                        value, kLargestNumber));
}

void ValueChecker::usable(const char* key, double value, const char* what) const {
  if (value > 0.0 && value <= kLargestNumber) return;
  fail(key, fmt::format("with this value {} is {}, it must be greater than 0 and at most {:.1e}",
                        what, value, kLargestNumber));
}

void ValueChecker::entries(const char* key, const std::vector<double>& values, int modes,
                           bool negative_allowed) const {
  if (values.size() != static_cast<std::size_t>(modes)) {
    fail(key, fmt::format("the list has {}, it must have one per mode, which is {}",
                          values.size() == 1 ? std::string("1 entry")
                                             : fmt::format("{} entries", values.size()),
                          modes));
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k]) || (values[k] < 0.0 && !negative_allowed)) {
      require(false, fmt::format("{}.{}", key, k + 1), values[k],
              negative_allowed ? "a finite number" : "a finite number of at least 0");
    }
    if (std::abs(values[k]) > kLargestNumber)
      not_too_large(fmt::format("{}.{}", key, k + 1), values[k]);
  }
}

}  // namespace graze
