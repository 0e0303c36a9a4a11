#include "graze/report/json.hpp"
#include "graze/report/json_document.hpp"
#include "graze/report/json_value.hpp"

namespace graze {

std::string to_json(const ShareRecord& record) {
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["share"] = {{"part", record.share.part}, {"of", record.share.of},
                       {"journal", record.journal}, {"piece", record.piece},
                       {"kept", record.kept},       {"due", record.due}};
  return document_text(document);
}

}  // namespace graze
