// How the options of a plane of cells reach what is done over it.
#pragma once

#include <string>
#include <utility>

#include "command.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/study/plane/detail/plane.hpp"

namespace graze {

// With so many cells across and up. Requires both ends of the second range.
inline Plane plane_of(const RangeOptions& first, const SecondRangeOptions& second, int across,
                      int up) {
  return {{first.parameter, first.from, first.to, across},
          {second.second, *second.second_from, *second.second_to, up}};
}

inline void note_plane(const Plane& plane, RunInfo& info) {
  for (const auto& [prefix, axis] : {std::pair("", plane.x), std::pair("second_", plane.y)}) {
    const std::string before = prefix;
    info.options.emplace_back(before.empty() ? "parameter" : "second", axis.name);
    info.options.emplace_back(before + "from", axis.from);
    info.options.emplace_back(before + "to", axis.to);
    info.options.emplace_back(before + "points", static_cast<long long>(axis.points));
  }
}

}  // namespace graze
