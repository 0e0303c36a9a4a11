// The result of a share of the work: the present contents of its journal.
#pragma once

#include <string>
#include <vector>

#include "graze/record/file/journal.hpp"
#include "graze/record/records.hpp"

namespace graze {

struct ShareRecord {
  RunInfo info;
  Share share;
  std::string journal;            // the file
  std::string piece;              // what the pieces are: "row", "cell"
  std::size_t kept = 0, due = 0;  // pieces of the share: in the journal, and in all
  std::vector<std::string> warnings;
  Outcome outcome;
};

// Outcome "complete", or how it was stopped.
ShareRecord share_record(const Journal& journal, StopReason stopped);

}  // namespace graze
