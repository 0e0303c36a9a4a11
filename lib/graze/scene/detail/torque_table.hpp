// A motor torque as measured points: its rules, and the file that may hold it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

struct TorqueFault {
  std::size_t entry = 0;  // from 0
  bool of_times = true;   // else of the values
  std::string sentence;   // what is wrong, what is allowed
};

// The first entry that breaks a rule: numbers must be finite, times at least 0 and ascending; two
// neighbours may be equal (the torque jumps), three not, nor all. Requires as many values as times,
// at least two.
std::optional<TorqueFault> torque_fault(const TorqueTable& table);

// Two columns separated by a comma, time (s) and torque (N m), under a row of names or without one.
// Throws FileError when the file cannot be read, InputError (file:line:column) where it is no such
// table.
TorqueTable read_torque_file(const std::filesystem::path& file);

}  // namespace graze
