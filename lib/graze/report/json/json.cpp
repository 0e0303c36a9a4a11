#include "graze/report/json/json.hpp"

#include <algorithm>
#include <utility>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/share_record.hpp"
#include "graze/record/stored/record_file.hpp"
#include "graze/report/json/detail/document_writer.hpp"
#include "graze/report/json/detail/json_document.hpp"

namespace graze {
namespace {

template <class Record>
std::string described_document(const Record& record) {
  DocumentWriter document;
  describe(document, record);
  Json whole = document.take();
  UnitList units;
  describe(units, record);
  whole["units"] = units.take();
  return document_text(std::move(whole), info_of(record));
}

}  // namespace

void add_event_json(const Event& event, Spool& events) {
  DocumentWriter writer;
  describe(writer, event);
  const std::string entry = writer.take().dump(1);
  std::string text = events.empty() ? "\n" : ",\n";
  // Two levels deep in the document, so every line begins with two more blanks.
  for (std::size_t start = 0; start < entry.size();) {
    const std::size_t end = std::min(entry.find('\n', start), entry.size() - 1) + 1;
    text += "  ";
    text.append(entry, start, end - start);
    start = end;
  }
  events.append(text);
}

Document to_json(const SimulationRecord& record, Spool& events) {
  const std::string whole = described_document(record);
  // Quotes inside strings are escaped, so this text occurs only once.
  const std::string opening = "\n \"events\": [";
  const std::size_t at = whole.find(opening + "]") + opening.size();
  return {whole.substr(0, at), events, (events.empty() ? "" : "\n ") + whole.substr(at)};
}

template <class Record>
requires(!std::same_as<Record, SimulationRecord>) std::string to_json(const Record& record) {
  return described_document(record);
}
template std::string to_json(const CheckRecord&);
template std::string to_json(const ModesRecord&);
template std::string to_json(const OrbitRecord&);
template std::string to_json(const BranchRecord&);
template std::string to_json(const LociRecord&);
template std::string to_json(const DiagramRecord&);
template std::string to_json(const RunDiagramRecord&);
template std::string to_json(const MapRecord&);
template std::string to_json(const ComparisonRecord&);
template std::string to_json(const ComparisonMapRecord&);
template std::string to_json(const SensitivityRecord&);
template std::string to_json(const CostRecord&);
template std::string to_json(const FitRecord&);
template std::string to_json(const ShareRecord&);

}  // namespace graze
