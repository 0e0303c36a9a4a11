// Records as text that reads back to the last bit, for files to draw from again: everything except
// what follows from the scene (record_fields.hpp).
#pragma once

#include <string>
#include <string_view>

#include "graze/record/record_names.hpp"

namespace graze {

// `Record`: any of record_names.hpp except shares; they are instantiated in record_text_*.cpp.
template <class Record>
std::string record_text(const Record& record);

// Reads the output of `record_text`; without systems, and without the text of the scene. False for
// any other text.
template <class Record>
bool read_record_text(std::string_view text, Record& record);

}  // namespace graze
