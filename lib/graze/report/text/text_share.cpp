#include <fmt/format.h>

#include "graze/record/detail/share_record.hpp"
#include "graze/report/text/text.hpp"

namespace graze {

std::string to_text(const ShareRecord& record) {
  std::string text =
      fmt::format("share {} of {}: {} of {} {}s are in {}\n", record.share.part, record.share.of,
                  record.kept, record.due, record.piece, record.journal);
  if (!record.outcome.message.empty())
    text += record.outcome.name + ": " + record.outcome.message + "\n";
  return text + "graze merge joins the shares once all of them are done\n";
}

}  // namespace graze
