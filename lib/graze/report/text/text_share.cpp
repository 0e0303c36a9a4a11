#include <fmt/format.h>

#include "graze/record/share_record.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/text.hpp"

namespace graze {

std::string to_text(const ShareRecord& record, const TextOptions&) {
  const std::string text =
      fmt::format("share {} of {}: {} of {} {}s are in {}\n", record.share.part, record.share.of,
                  record.kept, record.due, record.piece, record.journal);
  return text + ending(record.outcome) + "graze merge joins the shares once all of them are done\n";
}

}  // namespace graze
