// What was counted, for docs/accuracy.md: one line each in the file that GRAZE_COSTS names, as
// kind, effect, without, with; tabs between.
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

namespace graze::cost {

inline void note(const std::string& kind, const std::string& effect, double without, double with) {
  const char* const name = std::getenv("GRAZE_COSTS");
  if (name == nullptr) return;
  std::ofstream(name, std::ios::app)
      << kind << "\t" << effect << "\t" << without << "\t" << with << "\n";
}

}  // namespace graze::cost
