// The head of a journal, which describes the work that its pieces belong to.
#pragma once

#include <string>

#include "graze/record/file/run_info.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

// The work that pieces belong to.
struct JournalHead {
  RunInfo info;                       // its options: those that the pieces depend on
  std::string piece = "row";          // their names: "row 0", "row 1", ..
  std::size_t pieces = 0, block = 1;  // how many, and how many in a row go to one share
  Share share;
  std::string processor;  // on which it was begun: last digits may depend on its kind
};

// "Intel(R) Xeon(R) ..", or at least the kind of machine.
std::string processor_name();

// One line of text that `read_head` reads back; that returns false for any other text.
std::string head_text(const JournalHead& head);
bool read_head(const std::string& text, JournalHead& head);

// Throws InputError when the head of this file contradicts itself: another number of pieces than
// its options imply, an invalid share, more pieces than any command makes. Without this check
// nothing may be sized by a head.
void require_sound(const JournalHead& head, const std::string& file);

// Throws InputError, naming the option that differs, when `there`, the head of this file, belongs
// to other work than `head`. Shares and processors may differ.
void require_same_work(const JournalHead& there, const JournalHead& head, const std::string& file);

}  // namespace graze
