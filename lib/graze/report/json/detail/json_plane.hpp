// Private to this room. The axes of a plane.
#pragma once

#include <string>

#include "graze/report/json/detail/json_value.hpp"
#include "graze/study/plane/detail/plane.hpp"

namespace graze {

inline Json axis_json(const PlaneAxis& axis, const std::string& unit) {
  return {{"parameter", axis.name},
          {"unit", unit},
          {"from", axis.from},
          {"to", axis.to},
          {"points", axis.points}};
}

}  // namespace graze
