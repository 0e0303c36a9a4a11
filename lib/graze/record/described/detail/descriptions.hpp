// The descriptions of all results (result_visitor.hpp): how each was made, how it ended, what was
// found. Tables are rows of them.
#pragma once

#include <vector>

#include "graze/record/record_names.hpp"

namespace graze {

class ResultVisitor;
struct Event;

void describe(ResultVisitor& v, const CheckRecord& record);
void describe(ResultVisitor& v, const ModesRecord& record);
// Without its events, of which there may be more than memory holds.
void describe(ResultVisitor& v, const SimulationRecord& record);
void describe(ResultVisitor& v, const Event& event);
void describe(ResultVisitor& v, const std::vector<Event>& events);
void describe(ResultVisitor& v, const OrbitRecord& record);
void describe(ResultVisitor& v, const BranchRecord& record);
void describe(ResultVisitor& v, const LociRecord& record);
void describe(ResultVisitor& v, const DiagramRecord& record);
void describe(ResultVisitor& v, const RunDiagramRecord& record);
void describe(ResultVisitor& v, const MapRecord& record);
void describe(ResultVisitor& v, const ComparisonRecord& record);
void describe(ResultVisitor& v, const ComparisonMapRecord& record);
void describe(ResultVisitor& v, const SensitivityRecord& record);
void describe(ResultVisitor& v, const CostRecord& record);
void describe(ResultVisitor& v, const FitRecord& record);
void describe(ResultVisitor& v, const ShareRecord& record);

}  // namespace graze
