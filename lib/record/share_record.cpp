#include "graze/record/share_record.hpp"

#include <fmt/format.h>

namespace graze {

ShareRecord share_record(const Journal& journal, StopReason stopped) {
  const JournalHead& head = journal.head();
  ShareRecord record;
  record.info = head.info;
  record.share = head.share;
  record.journal = journal.file().string();
  record.piece = head.piece;
  for (std::size_t i = 0; i < head.pieces; ++i) {
    if (!head.share.has(i / head.block)) continue;
    ++record.due;
    record.kept += journal.has(fmt::format("{} {}", head.piece, i));
  }
  record.outcome = {"complete", ""};
  if (record.kept < record.due)
    if (auto outcome = stopped_outcome(stopped, record.kept, record.due, "pieces"))
      record.outcome = std::move(*outcome);
  return record;
}

}  // namespace graze
