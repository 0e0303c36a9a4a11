// The result documents: one JSON object a command, numbers with all their digits, null for what
// does not exist. They hold what is described (result_visitor.hpp), and the units of it.
#pragma once

#include <concepts>
#include <string>

#include "graze/motion/run_events.hpp"
#include "graze/record/file/spool.hpp"
#include "graze/record/record_names.hpp"

namespace graze {

template <class Record>
requires(!std::same_as<Record, SimulationRecord>) std::string to_json(const Record& record);
// The events of a run, each as `add_event_json` wrote it, stand in the middle of its document.
Document to_json(const SimulationRecord& record, Spool& events);
void add_event_json(const Event& event, Spool& events);

}  // namespace graze
