// Declarations of the record types, for code that only passes them on.
#pragma once

namespace graze {

struct BranchRecord;
struct CheckRecord;
struct ComparisonMapRecord;
struct ComparisonRecord;
struct CostRecord;
struct DiagramRecord;
struct FitRecord;
struct LociRecord;
struct MapRecord;
struct ModesRecord;
struct OrbitRecord;
struct RunDiagramRecord;
struct SensitivityRecord;
struct ShareRecord;
struct SimulationRecord;

}  // namespace graze
