#include "graze/record/detail/share_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"

namespace graze {

std::string to_json(const ShareRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["share"] = {{"part", record.share.part}, {"of", record.share.of},
                       {"journal", record.journal}, {"piece", record.piece},
                       {"kept", record.kept},       {"due", record.due}};
  return document_text(std::move(document), record.info);
}

}  // namespace graze
