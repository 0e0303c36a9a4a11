// What a journal tells of the work that its pieces belong to.
#pragma once

#include <string>

#include "graze/record/file/run_info.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

// The work that pieces belong to.
struct JournalHead {
  RunInfo info;                       // its options: those that make a difference to the pieces
  std::string piece = "row";          // their names: "row 0", "row 1", ..
  std::size_t pieces = 0, block = 1;  // how many, and how many in a row go to one share
  Share share;
  std::string processor;  // on which it was begun: last digits may depend on its kind
};

// "Intel(R) Xeon(R) ..", or at least the kind of machine.
std::string processor_name();

// One line of text that `read_head` reads back; it gives false where there is something else.
std::string head_text(const JournalHead& head);
bool read_head(const std::string& text, JournalHead& head);

// Throws InputError where the head of this file contradicts itself: another number of pieces than
// its options tell of, a share that is none, more than any command makes. Nothing may be sized by
// such a head.
void require_sound(const JournalHead& head, const std::string& file);

// Throws InputError where `there`, the head of this file, is of other work than `head`; says which
// option differs. Shares and processors may.
void require_same_work(const JournalHead& there, const JournalHead& head, const std::string& file);

}  // namespace graze
