// Options of motions that are followed until they settle, and of long work in pieces.
#pragma once

#include <string>
#include <vector>

#include "graze/study/sweep/settled_row.hpp"
#include "graze/study/sweep/shared_work.hpp"
#include "options/shared.hpp"

namespace graze {

// How long motions are followed until they settle.
struct SettlingOptions {
  long long periods = RowOptions{}.periods;  // the most at a value
  long long samples = 100;
  long long exponents = 0;  // forcing periods averaged over; 0: none
};

// Work in pieces that a folder keeps.
struct JournalOptions {
  bool goes_on = false;   // --resume: with the pieces that are in the folder
  bool restarts = false;  // --restart-work: they may be thrown away
  Share share;
  BlockWorkers* workers = &own_threads();  // who does them; not null
  std::string program = "graze";           // that goes on with it, as a shell has it
  std::vector<std::string> arguments{};    // and its own, where the command's are not
};

// Reads "3/8", or throws InputError.
void read_share(const std::string& text, Share& share);

void describe_following(auto& v, SettlingOptions& o, const Recorded& recorded = kOfPieces) {
  v.heading("Motions at each value");
  v.option("periods", o.periods, "K",
           "Forcing periods run at a value, at most (default 1000); fewer once it settled",
           whole_number("a whole number from 1", 1.0, kMostCounted), recorded);
  v.option("samples", o.samples, "M", "Forcing periods shown of a motion that does not repeat",
           whole_number_within(1, 1'000'000), recorded);
}

// The same, and whether results record them.
void describe_settling(auto& v, SettlingOptions& o, const Recorded& recorded = kOfPieces) {
  describe_following(v, o, recorded);
  v.option("exponents", o.exponents, "K",
           "Lyapunov exponents at every value: of the multipliers where the motion repeats, else "
           "averaged over so many forcing periods",
           whole_number("a whole number from 1", 1.0, kMostCounted), kNoDefault,
           recorded.where(o.exponents > 0));
}

void describe_journal(auto& v, JournalOptions& o) {
  v.heading(kLongWorkGroup);
  v.flag("resume", o.goes_on,
         "Go on with what an earlier run left in the folder of --out, whatever ended it; what it "
         "finished is not done again");
  v.flag("restart_work", o.restarts,
         "Throw away what unfinished work left in that folder, and begin anew",
         Excludes{{"resume"}});
  v.text(
      "shard", [&o](const std::string& text) { read_share(text, o.share); }, "k/n",
      "Do one of n shares of the work, for job arrays; graze merge joins them");
}

}  // namespace graze
