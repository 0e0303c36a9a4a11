// Orbits on compliant stops over two parameters of the scene: the stroboscopic map (strobe_map.hpp)
// as a plane problem.
//
// The equations need first derivatives of the map, which are integrated. The slope of the last
// equation of a locus of folds, doublings or tori, for a critical multiplier, would need second
// ones; it is told by differences of the first. Newton's method ends where the equations hold, so
// that a solution does not depend on that slope, only how quickly it is reached.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/continuation/locus_values.hpp"
#include "graze/continuation/plane_map.hpp"
#include "graze/orbit/strobe_map.hpp"

namespace graze {

// Remembers the system of the values asked for last: one thread at a time.
class StrobePlane {
 public:
  // Requires that the scene allows its own values. The ranges of `options` are the units of the
  // parameters.
  StrobePlane(const Scene& scene, const std::string& first, const std::string& second,
              const LocusOptions& options, const StrobeOptions& strobe);
  StrobePlane(const StrobePlane&) = delete;
  StrobePlane& operator=(const StrobePlane&) = delete;

  const StrobeMap& map() const { return map_; }
  double length() const { return length_; }          // of the forced motion, m
  double speed_unit() const { return speed_unit_; }  // m/s, likewise
  double first_range() const { return first_range_; }
  // To what the test for a critical multiplier vanishes.
  static double residual_tolerance();
  // Orbits of a period p; the unknown is (x_1, .., x_p).
  const PlaneProblem& problem(int period);
  // Null where the scene does not allow the values; both hold until others are asked for.
  const System* system_at(double p, double q) const;
  const System* tangent_at(double p, double q, std::size_t parameter) const;

 private:
  std::optional<PlaneMapEvaluation> evaluate(const Vector& x, double p, double q) const;
  std::optional<double> product(const Vector& x, double p, double q, const Vector& left,
                                const Vector& right) const;
  std::optional<Vector> curvature(const Vector& x, double p, double q, const Vector& left,
                                  const Vector& right) const;

  mutable SystemCursor systems_;
  double first_range_, second_range_;
  double length_, speed_unit_;
  StrobeMap map_;
  std::map<int, PlaneProblem> problems_;  // by period
};

}  // namespace graze
