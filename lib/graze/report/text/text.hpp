// Results in words and tables, for a terminal.
#pragma once

#include <limits>
#include <string>

#include "graze/record/record_names.hpp"

namespace graze {

// The amount of detail, and the width of lines.
struct TextOptions {
  std::size_t width = 100;  // characters of a line, at most
  bool verbose = false;     // also notes on the numerics
};

// No limit on the width of lines.
inline constexpr std::size_t kAnyWidth = std::numeric_limits<std::size_t>::max();

std::string to_text(const CheckRecord& record, const TextOptions& options = {});
std::string to_text(const SimulationRecord& record, const TextOptions& options = {});
std::string to_text(const OrbitRecord& record, const TextOptions& options = {});
std::string to_text(const BranchRecord& record, const TextOptions& options = {});
std::string to_text(const LociRecord& record, const TextOptions& options = {});
// Requires regions.
std::string regions_text(const LociRecord& record, const TextOptions& options = {});
std::string to_text(const DiagramRecord& record, const TextOptions& options = {});
std::string to_text(const RunDiagramRecord& record, const TextOptions& options = {});
std::string to_text(const MapRecord& record, const TextOptions& options = {});
std::string to_text(const ModesRecord& record, const TextOptions& options = {});
std::string to_text(const ComparisonRecord& record, const TextOptions& options = {});
std::string to_text(const ComparisonMapRecord& record, const TextOptions& options = {});
std::string to_text(const ShareRecord& record, const TextOptions& options = {});
std::string to_text(const CostRecord& record, const TextOptions& options = {});
std::string to_text(const FitRecord& record, const TextOptions& options = {});
std::string to_text(const SensitivityRecord& record, const TextOptions& options = {});

// The same lines, broken at blanks to the width; continued sentences are indented below themselves.
std::string fitted_lines(const std::string& text, const TextOptions& options);

}  // namespace graze
