#include "graze/record/share_record.hpp"

namespace graze {

ShareRecord share_record(const Journal& journal, StopReason stopped) {
  const JournalHead& head = journal.head();
  ShareRecord record;
  record.info = head.info;
  record.share = head.share;
  record.journal = journal.file().string();
  record.piece = head.piece;
  record.due = head.share.count(head.pieces, head.block);
  record.kept = head.pieces - missing_pieces(head, {&journal}).size();
  record.outcome = {"complete", ""};
  if (record.kept < record.due)
    if (auto outcome = stopped_outcome(stopped, record.kept, record.due, "pieces"))
      record.outcome = std::move(*outcome);
  return record;
}

}  // namespace graze
