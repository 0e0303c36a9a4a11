#include "graze/bifurcation/orbit_component.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

OrbitBranchEnd as_orbit_end(BranchEnd end) {
  switch (end) {
    case BranchEnd::kParameterLimit: return OrbitBranchEnd::kParameterLimit;
    case BranchEnd::kClosed: return OrbitBranchEnd::kClosed;
    case BranchEnd::kStepLimit:
    case BranchEnd::kInterrupted: return OrbitBranchEnd::kStepLimit;
    case BranchEnd::kNotConverged: break;
  }
  return OrbitBranchEnd::kNotConverged;
}

// The multiplier nearest to +1: the critical one at a fold.
std::optional<Complex> nearest_to_one(const std::vector<Eigenvalue>& multipliers) {
  std::optional<Complex> nearest;
  for (const Eigenvalue& m : multipliers)
    if (!nearest || std::abs(m.value - 1.0) < std::abs(*nearest - 1.0)) nearest = m.value;
  return nearest;
}

// What lies between two neighbouring points.
struct Between {
  std::vector<SpecialPoint> folds;
  std::optional<SpecialPoint> grazing;
};

}  // namespace

OrbitComponents::OrbitComponents(const SystemFamily& family, const ShootingProblem& shooting,
                                 const ContinuationOptions& continuation)
    : family_(family),
      shooting_(shooting),
      continuation_(continuation),
      problem_(orbit_problem(family, shooting)) {}

OrbitBranchPoint OrbitComponents::judge(const BranchPoint& point) const {
  const std::optional<System> system = family_.at(point.parameter);
  OrbitBranchPoint result{point.parameter, make_orbit(*system, shooting_, point.u), 0, 0.0};
  result.unstable_multipliers = count_multipliers(result.orbit.multipliers).outside;
  result.smallest_speed = std::numeric_limits<double>::infinity();
  for (const OrbitImpact& impact : result.orbit.impacts)
    result.smallest_speed = std::min(result.smallest_speed, impact.speed);
  return result;
}

SpecialPoint OrbitComponents::fold(const Fold& at) const {
  SpecialPoint special{SpecialKind::kFold, "", judge(at.point), {}, false};
  special.multiplier = nearest_to_one(special.at.orbit.multipliers);
  return special;
}

std::optional<SpecialPoint> OrbitComponents::grazing(const BranchPoint& a, const BranchPoint& b,
                                                     const OrbitBranchPoint& at_a,
                                                     const OrbitBranchPoint& at_b) const {
  if (at_a.orbit.admissible == at_b.orbit.admissible) return {};
  const bool by_speed = (at_a.smallest_speed > 0.0) != (at_b.smallest_speed > 0.0);
  const auto admissibility_at = [&](const BranchPoint& p) {
    return admissibility(*family_.at(p.parameter), shooting_.pattern(),
                         shooting_.unpack(*family_.at(p.parameter), p.u));
  };
  std::optional<BranchPoint> point;
  if (by_speed) {
    point = locate(problem_, continuation_, a, b,
                   [&](const BranchPoint& p) { return admissibility_at(p).smallest_speed; });
  } else {
    // Without an interior minimum the motion is as clear as its gap is wide.
    const double clear = std::max(at_a.orbit.clearance.value_or(0.0),
                                  at_b.orbit.clearance.value_or(0.0)) + 1.0;
    point = locate(problem_, continuation_, a, b, [&](const BranchPoint& p) {
      return admissibility_at(p).clearance.value_or(clear);
    });
  }
  if (!point) return {};
  return SpecialPoint{SpecialKind::kGrazing, "", judge(*point), {}, by_speed};
}

std::vector<OrbitBranch> OrbitComponents::parts(const Branch& branch, bool keep_virtual) const {
  std::vector<OrbitBranchPoint> points;
  for (const BranchPoint& point : branch.points) points.push_back(judge(point));
  std::vector<Between> between(points.size());
  for (const Fold& f : branch.folds) between[f.after].folds.push_back(fold(f));
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    between[i].grazing = grazing(branch.points[i], branch.points[i + 1], points[i], points[i + 1]);

  // A closed branch that is an orbit in parts only is opened where it is not one.
  const auto admissible = [&](std::size_t i) { return points[i].orbit.admissible; };
  if (branch.closed() && !keep_virtual && admissible(0)) {
    std::size_t open = 0;
    while (open < points.size() && admissible(open)) ++open;
    if (open < points.size()) {
      points.pop_back();  // repeats the first
      between.pop_back();
      std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(open), points.end());
      std::rotate(between.begin(), between.begin() + static_cast<std::ptrdiff_t>(open),
                  between.end());
      points.push_back(points.front());
      between.emplace_back();
    }
  }

  std::vector<OrbitBranch> parts;
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep_virtual || admissible(i)) {
      if (!inside) {
        OrbitBranch part;
        part.ends[0] = i == 0 ? as_orbit_end(branch.ends[0]) : OrbitBranchEnd::kGrazing;
        if (i > 0 && between[i - 1].grazing) {
          for (const SpecialPoint& f : between[i - 1].folds)
            if (f.at.orbit.admissible) part.special.push_back(f);
          part.special.insert(part.special.begin(), *between[i - 1].grazing);
          part.points.push_back(between[i - 1].grazing->at);
        }
        parts.push_back(std::move(part));
        inside = true;
      }
      parts.back().points.push_back(points[i]);
      parts.back().ends[1] = as_orbit_end(branch.ends[1]);
      if (keep_virtual || (i + 1 < points.size() && admissible(i + 1)))
        for (const SpecialPoint& f : between[i].folds) parts.back().special.push_back(f);
      if (keep_virtual && between[i].grazing) parts.back().special.push_back(*between[i].grazing);
    } else {
      if (inside) {
        OrbitBranch& part = parts.back();
        part.ends[1] = OrbitBranchEnd::kGrazing;
        for (const SpecialPoint& f : between[i - 1].folds)
          if (f.at.orbit.admissible) part.special.push_back(f);
        if (between[i - 1].grazing) {
          part.special.push_back(*between[i - 1].grazing);
          part.points.push_back(between[i - 1].grazing->at);
        }
      }
      inside = false;
    }
  }
  return parts;
}

}  // namespace graze
