// What a picture of a finished result shows, chosen anew.
#pragma once

#include <string>

#include "graze/record/stored/record_file.hpp"

namespace graze {

struct ShownChoice {
  std::string show, at;  // in the words of --show and --at of the command that made the result
  std::string whose;     // "the run in runs/map"
};

// Lets the record's picture show that. Throws InputError where the record does not hold it.
void choose_shown(const ShownChoice& choice, AnyRecord& record);

}  // namespace graze
