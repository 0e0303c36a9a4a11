#include "found_result.hpp"

#include <variant>

#include "graze/record/file/spool.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/json/json.hpp"

namespace graze {
namespace {

std::vector<NamedTable> tables(const FoundResult& result) {
  return std::visit([](const auto& record) { return tables_of(record); }, *result.record());
}

// A run that was read has left its events in a table of its folder.
bool has_events(const FoundResult& result) {
  return std::holds_alternative<SimulationRecord>(*result.record()) &&
         result.stored_document().empty();
}

}  // namespace

void FoundResult::hear(const Sample& sample) {
  write_sample_row(*system_, sample, *probes_, samples_->add());
}

void FoundResult::begin_run(const System& system, const std::vector<ProbeRow>& probes, bool energy,
                            double samples) {
  system_ = &system;
  probes_ = &probes;
  samples_ = std::make_unique<Rows>(sample_columns(system, energy, probes), samples);
}

void FoundResult::take(AnyRecord record, const Scene& scene, std::string document) {
  record_ = std::move(record);
  scene_ = scene;
  document_ = std::move(document);
}

const Outcome& outcome_of(const FoundResult& result) {
  return std::visit([](const auto& record) -> const Outcome& { return outcome_of(record); },
                    *result.record());
}

std::string document_of(const FoundResult& result) {
  if (!result.stored_document().empty()) return result.stored_document();
  Spool events;
  std::string text;
  const auto collect = [&](const Document& whole) {
    whole.read([&](std::string_view piece) { text += piece; });
  };
  std::visit(
      [&](const auto& record) {
        if constexpr (requires { to_json(record, events); }) {
          for (const Event& event : result.events()) add_event_json(event, events);
          collect(to_json(record, events));
        } else {
          collect(Document(to_json(record)));
        }
      },
      *result.record());
  return text;
}

std::vector<std::string> table_names(const FoundResult& result) {
  std::vector<std::string> names;
  if (has_events(result)) names.emplace_back("events");
  if (result.samples() && result.samples()->count() > 0) names.emplace_back("samples");
  for (const NamedTable& table : tables(result)) names.push_back(table.name);
  return names;
}

std::optional<ResultTable> table_of(const FoundResult& result, const std::string& name) {
  if (name == "events" && has_events(result)) return events_table(result.events());
  return made_table(tables(result), name);
}

}  // namespace graze
