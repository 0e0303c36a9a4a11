// The result documents: one JSON object a command, numbers with all their digits, null for what
// does not exist.
#pragma once

#include <string>

#include "graze/motion/run_events.hpp"
#include "graze/record/file/spool.hpp"
#include "graze/record/record_names.hpp"

namespace graze {

std::string to_json(const CheckRecord& record);
// The events of a run, each as `add_event_json` wrote it, stand in the middle of its document.
Document to_json(const SimulationRecord& record, Spool& events);
void add_event_json(const Event& event, Spool& events);
std::string to_json(const OrbitRecord& record);
std::string to_json(const BranchRecord& record);
std::string to_json(const LociRecord& record);
std::string to_json(const MapRecord& record);
std::string to_json(const ModesRecord& record);
std::string to_json(const ComparisonRecord& record);
std::string to_json(const ComparisonMapRecord& record);
std::string to_json(const ShareRecord& record);
std::string to_json(const CostRecord& record);
std::string to_json(const FitRecord& record);
std::string to_json(const SensitivityRecord& record);
// One run at each value.
std::string to_json(const RunDiagramRecord& record);
// The document of the branches, with the sweep added.
std::string to_json(const DiagramRecord& record);

}  // namespace graze
