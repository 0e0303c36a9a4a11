// Places in a result document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace graze::support {

// The value at a path of keys and of indices from 0 with '/' between; "key=text" keeps the members
// of a list whose key has that value: "events/kind=impact/19/time". With " + " between
// several of them the root of the sum of the squares of their numbers. Throws std::out_of_range,
// with the part that leads nowhere.
nlohmann::json result_at(const nlohmann::json& document, const std::string& path);

}  // namespace graze::support
