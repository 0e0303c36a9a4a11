#include "graze/bifurcation/cut/detail/grazing_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {
namespace {

// The slope of the map changes as the root of the depth, so that the order of convergence is 3/2.
constexpr int kMostIterations = 16;
// A step this small leaves an error of its power 3/2, below 1e-12.
constexpr double kSettled = 1e-8;
// Newton's method has failed when steps shrink less than this,
constexpr double kContraction = 0.8;
// or when it is further than this from its start, in units of the unknowns and the range.
constexpr double kBesideContact = 1e-2;

class GrazingSearch {
 public:
  GrazingSearch(const SegmentEquations& equations, const ContinuationOptions& options)
      : equations_(equations), corrector_(equations.problem(), options), options_(options) {}

  std::optional<FoundGrazing> near(const SolutionPoint& from, const GrazingContact& grazing) {
    const Eigen::Index n = from.u.size();
    Vector y(n + 2);
    y << corrector_.pack(from), equations_.psi_of(from.u, grazing);
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostIterations; ++i) {
      const std::optional<ZeroEvaluation> at = equations_.grazing(y, {}, grazing.stop);
      if (!at || !at->jacobian.allFinite()) return {};
      if (at->residual.cwiseAbs().maxCoeff() <= options_.residual_tolerance && last <= kSettled)
        return found_at(y, *at, grazing.stop);
      const Vector step = LuFactors(at->jacobian).solve(at->residual);
      const double size = step.norm();
      if (!std::isfinite(size) || (size > kContraction * last && size > kSettled)) return {};
      y -= step;
      last = size;
    }
    return {};
  }

  // The part of the chord from a to b at which a point lies; nullopt when it lies beside it.
  std::optional<double> part_between(const SolutionPoint& a, const SolutionPoint& b,
                                     const SolutionPoint& point) const {
    const Vector chord = corrector_.chord(a, b), offset = corrector_.chord(a, point);
    const double length = chord.norm(), along = offset.dot(chord) / length;
    // Known to the accuracy of the equations.
    const double rounding = kGrazingDepth * (1.0 + corrector_.pack(point).norm());
    if (along < -rounding || along > length + rounding) return {};
    if ((offset - along * chord / length).norm() > 0.5 * options_.max_turn * length + rounding)
      return {};
    return along / length;
  }

 private:
  std::optional<FoundGrazing> found_at(const Vector& y, const ZeroEvaluation& at, int stop) {
    const Eigen::Index n = y.size() - 2;
    const std::optional<GrazingContact> grazing = equations_.grazing_at(y, {}, stop);
    if (!grazing) return {};
    FoundGrazing found;
    found.at.u = y.head(n);
    found.at.parameter = y[n] * corrector_.range();
    found.at.residual = at.residual.head(n).cwiseAbs().maxCoeff();
    found.at.tangent = null_vector(Matrix(at.jacobian.topLeftCorner(n, n + 1)));
    found.contact = *grazing;
    return found;
  }

  const SegmentEquations& equations_;
  Corrector corrector_;
  const ContinuationOptions& options_;
};

int sign_of_orientation(const SegmentEquations& equations, const ContinuationOptions& options,
                        const SolutionPoint& at) {
  Corrector corrector(equations.problem(), options);
  const auto linearised = corrector.linearise(corrector.pack(at), at.tangent);
  return linearised ? LuFactors(linearised->bordered).determinant_sign() : 0;
}

}  // namespace

std::optional<FoundGrazing> find_grazing_between(const SegmentEquations& equations,
                                                 const ContinuationOptions& options,
                                                 const SolutionPoint& a, const SolutionPoint& b,
                                                 int stop) {
  GrazingSearch search(equations, options);
  std::optional<FoundGrazing> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const SolutionPoint* from : {&a, &b})
    for (const GrazingContact& grazing : equations.grazing_contacts_near(*from)) {
      if (grazing.stop != stop) continue;
      const std::optional<FoundGrazing> found = search.near(*from, grazing);
      const std::optional<double> part =
          found ? search.part_between(a, b, found->at) : std::nullopt;
      if (!part || !(*part < nearest)) continue;
      nearest = *part;
      best = found;
    }
  if (!best) return {};
  // Orientation is compared instead of tangents: it is constant along a branch, whereas tangents
  // may differ by more than a right angle where the branch turns back.
  best->at.orientation = sign_of_orientation(equations, options, best->at);
  const bool runs_back = a.orientation != 0 ? best->at.orientation * a.orientation < 0
                                            : best->at.tangent.dot(a.tangent) < 0.0;
  if (runs_back) best->at.turn_round();
  return best;
}

std::optional<FoundGrazing> find_grazing_from(const SegmentEquations& equations,
                                              const ContinuationOptions& options,
                                              const SolutionPoint& from) {
  const System* system = equations.system_at(from.parameters());
  if (!system) return {};
  const std::vector<GrazingContact> grazings =
      grazing_contacts_near(*system, equations.shooting(), from.u);
  if (grazings.empty()) return {};
  std::optional<FoundGrazing> found =
      GrazingSearch(equations, options).near(from, grazings.front());
  const Corrector corrector(equations.problem(), options);
  if (found && !(corrector.chord(from, found->at).norm() <= kBesideContact)) return {};
  return found;
}

}  // namespace graze
