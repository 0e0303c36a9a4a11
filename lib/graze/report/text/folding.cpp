#include "graze/report/text/detail/folding.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze {

std::string share_text(std::size_t members, std::size_t all) {
  return fmt::format("{:.2f} %", 100.0 * static_cast<double>(members) / static_cast<double>(all));
}

std::string Folded::text(std::size_t all) const {
  return groups_ == 0 ? "" : fmt::format("  and {} more, {}\n", groups_, share_text(members_, all));
}

std::vector<bool> folded_groups(const std::vector<std::size_t>& members, std::size_t all) {
  constexpr std::ptrdiff_t kFewest = 4;
  std::vector<bool> folded;
  for (const std::size_t count : members) folded.push_back(100 * count < all);
  const std::ptrdiff_t small = std::count(folded.begin(), folded.end(), true);
  if (small < kFewest || small == static_cast<std::ptrdiff_t>(members.size()))
    folded.assign(members.size(), false);
  return folded;
}

}  // namespace graze
