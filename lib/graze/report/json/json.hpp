// The result documents: one JSON object for each command, numbers with all their digits, null for
// missing values. They hold the described fields (result_visitor.hpp) and their units.
#pragma once

#include <concepts>
#include <string>

#include "graze/motion/run_events.hpp"
#include "graze/record/file/spool.hpp"
#include "graze/record/record_names.hpp"

namespace graze {

template <class Record>
requires(!std::same_as<Record, SimulationRecord>) std::string to_json(const Record& record);
// The events of a run, written by `add_event_json`, are in the middle of its document.
Document to_json(const SimulationRecord& record, Spool& events);
void add_event_json(const Event& event, Spool& events);

}  // namespace graze
