// Sections of motions: impacts, or states once a forcing period; and the Poincare section of one
// run.
#pragma once

#include <utility>
#include <vector>

#include "graze/motion/simulation.hpp"

namespace graze {

enum class DiagramSection {
  kImpact,       // phase and speed of every impact
  kStroboscopic  // displacement and velocity at the stops at the start of every forcing period
};

struct SectionPoint {
  double time = 0.0;  // s
  int stop = 0;       // from 0
  // For an impact forcing phase (rad) and speed (m/s); on a stroboscopic section displacement
  // towards the stop (m) and velocity (m/s).
  double across = 0.0, up = 0.0;
};

// Collected during a run. On a stroboscopic section each sample is a point.
class RunSection {
 public:
  RunSection() = default;
  // `from`: start of the section, s.
  RunSection(DiagramSection kind, double from) : kind_(kind), from_(from) {}
  // As read back from a record.
  RunSection(DiagramSection kind, double from, std::vector<SectionPoint> points, long long left_out)
      : kind_(kind), from_(from), points_(std::move(points)), left_out_(left_out) {}

  void add(const Event& event);
  void add(const System& system, const Sample& sample);

  DiagramSection kind() const { return kind_; }
  double from() const { return from_; }
  const std::vector<SectionPoint>& points() const { return points_; }
  // Number of points beyond the limit of a million.
  long long left_out() const { return left_out_; }

 private:
  void add(const SectionPoint& point);

  DiagramSection kind_ = DiagramSection::kImpact;
  double from_ = 0.0;
  std::vector<SectionPoint> points_;
  long long left_out_ = 0;
};

}  // namespace graze
