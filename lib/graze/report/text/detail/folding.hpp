// Groups that are too small for a row of their own.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace graze {

// "12.50 %"
std::string share_text(std::size_t members, std::size_t all);

// Groups that are combined in one last line.
class Folded {
 public:
  void add(std::size_t members) {
    ++groups_;
    members_ += members;
  }
  // "and 80 more, 0.90 %", a line of its own; "" if there are none.
  std::string text(std::size_t all) const;

 private:
  std::size_t groups_ = 0, members_ = 0;
};

// Which of the groups, given by their numbers of members, are to be folded: those with less than a
// hundredth of `all`, if enough of them save lines and others are shown.
std::vector<bool> folded_groups(const std::vector<std::size_t>& members, std::size_t all);

}  // namespace graze
