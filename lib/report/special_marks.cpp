#include "graze/report/special_marks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/report/picture_style.hpp"

namespace graze {

SpecialMark special_mark(const std::string& label) {
  static const std::map<std::string, SpecialMark> kMarks = {
      {"LP", {"fold (LP)", 7, 0.8, kBlack, 0}},
      {"GR", {"grazing (GR)", 8, 1.0, kGreen, 9}},
      {"PD", {"period doubling (PD)", 5, 0.75, kPurple, 0}},
      {"NS", {"torus (NS)", 12, 1.1, kBlack, 13}},
      {"BP", {"branch point (BP)", 3, 1.0, kBlack, 0}},
      {"CH", {"chatter ends (CH)", 10, 1.0, kOrange, 11}},
      {"LO", {"lift-off (LO)", 14, 1.0, kSky, 15}},
  };
  const auto known = kMarks.find(label);
  return known != kMarks.end() ? known->second : SpecialMark{label, 4, 0.9, kBlack, 5};
}

double crowded_mark_size(std::size_t count) {
  return 0.9 * std::clamp(std::sqrt(12.0 / std::max(static_cast<double>(count), 1.0)), 0.5, 1.0);
}

}  // namespace graze
