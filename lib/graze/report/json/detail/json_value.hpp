// Private to this room. Values in documents: null for missing ones, since JSON has neither NaN nor
// infinity.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

namespace graze {

using Json = nlohmann::ordered_json;

inline Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class T>
Json json_maybe(const std::optional<T>& value) {
  if (!value) return nullptr;
  if constexpr (std::is_same_v<T, double>)
    return json_number(*value);
  else
    return *value;
}

// The list of a vector's numbers.
template <class Numbers>
Json json_list(const Numbers& numbers) {
  Json json = Json::array();
  for (const double value : numbers) json.push_back(json_number(value));
  return json;
}

}  // namespace graze
