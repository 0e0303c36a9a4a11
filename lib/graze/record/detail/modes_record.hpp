// The natural modes of a structure as a result.
#pragma once

#include "graze/assembly/mode_table.hpp"
#include "graze/record/records.hpp"

namespace graze {

struct ModesRecord {
  RunInfo info;
  ModeTable table;
  std::string mac_file{};  // that the modes are compared with; empty: none
  std::optional<ModalAssurance> mac{};
  std::vector<std::string> warnings;
  Outcome outcome;
};

}  // namespace graze
