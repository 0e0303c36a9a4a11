#include "graze/report/picture/detail/special_marks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/report/picture/picture_style.hpp"

namespace graze {

// No two of one shape, none of them a sweep's dot; those that end a branch are outlines.
SpecialMark special_mark(const std::string& label) {
  static const std::map<std::string, SpecialMark> kMarks = {
      {"LP", {"fold (LP)", 6, 0.9, kBlack, 7}},
      {"BP", {"branch point (BP)", 2, 1.0, kBlack, 0, 2.4}},
      {"PD", {"period doubling (PD)", 5, 0.75, kPurple}},
      {"NS", {"torus (NS)", 13, 1.0, kSky}},
      {"GR", {"grazing (GR)", 8, 1.0, kGreen, 9}},
      {"CH", {"chatter ends (CH)", 10, 1.0, kOrange, 11}},
      {"LO", {"lift-off (LO)", 14, 1.0, kOrange, 15}},
  };
  const auto known = kMarks.find(label);
  return known != kMarks.end() ? known->second : SpecialMark{label, 4, 0.9, kBlack, 5};
}

double crowded_mark_size(std::size_t count) {
  return 0.9 * std::clamp(std::sqrt(12.0 / std::max(static_cast<double>(count), 1.0)), 0.5, 1.0);
}

}  // namespace graze
