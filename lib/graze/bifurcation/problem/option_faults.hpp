// What is wrong with options of branches, as one sentence for all callers: trace_orbits() throws
// it, the program prints it for its own options.
#pragma once

#include <optional>
#include <string>

#include "graze/bifurcation/problem/branch_options.hpp"

namespace graze {

struct OptionFault {
  std::string members;  // of BranchOptions, "from, to"
  std::string sentence;

  std::string text() const { return members + ": " + sentence; }
  // In terms of the program's options: "--from, --to: the range must not be empty".
  std::string text_of_program() const;
};

// The first fault; nullopt when there is none. Parameter values are in the parameter's unit.
std::optional<OptionFault> fault_in(const BranchOptions& options);

}  // namespace graze
