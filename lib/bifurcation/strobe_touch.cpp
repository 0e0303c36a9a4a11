#include "graze/bifurcation/strobe_touch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/base/linear_equations.hpp"
#include "graze/continuation/corrector.hpp"

namespace graze {
namespace {

// The slope of the map changes as the root of the depth, so that the order of convergence is 3/2.
constexpr int kMostIterations = 16;
// A step this small leaves an error of its power 3/2, below 1e-12.
constexpr double kSettled = 1e-8;
// Steps that shrink less lead nowhere near.
constexpr double kContraction = 0.8;
// How deep a solution may lie beyond the touch, in lengths of the forced motion: ten times what the
// equations are solved to.
constexpr double kDepth = 1e-10;

// (x, parameter/range, psi), psi counted over all turns.
struct Guess {
  Vector y;
  int stop = 0;
};

class TouchSearch {
 public:
  TouchSearch(const StrobeEquations& equations, const ContinuationOptions& options)
      : equations_(equations), corrector_(equations.problem(), options), options_(options) {}

  std::optional<StrobeBorder> near(const BranchPoint& from, const StrobeTouch& touch) {
    const Eigen::Index n = from.u.size();
    Vector y(n + 2);
    y << corrector_.pack(from), static_cast<double>(touch.turn) * kTurn + touch.angle;
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostIterations; ++i) {
      const std::optional<Linearised> at = linearise(y, touch.stop);
      if (!at) return {};
      if (at->residual.cwiseAbs().maxCoeff() <= options_.residual_tolerance && last <= kSettled)
        return border(y, *at, touch.stop);
      const Vector step = LuFactors(at->slope).solve(at->residual);
      const double size = step.norm();
      if (!std::isfinite(size) || (size > kContraction * last && size > kSettled)) return {};
      y -= step;
      last = size;
    }
    return {};
  }

  // How far along the chord from a to b, as a part of it; nothing beside it.
  std::optional<double> part_between(const BranchPoint& a, const BranchPoint& b,
                                     const BranchPoint& point) const {
    const Vector chord = corrector_.chord(a, b), offset = corrector_.chord(a, point);
    const double length = chord.norm(), along = offset.dot(chord) / length;
    // Known to the accuracy of the equations.
    const double rounding = kDepth * (1.0 + corrector_.pack(point).norm());
    if (along < -rounding || along > length + rounding) return {};
    if ((offset - along * chord / length).norm() > 0.5 * options_.max_turn * length + rounding)
      return {};
    return along / length;
  }

 private:
  struct Linearised {
    Vector residual;
    Matrix slope;       // by (x, parameter/range, psi)
    double push = 0.0;  // b.q'' on the way, speeds of the forced motion per rad
    Matrix orbits;      // the first n rows by (x, parameter/range)
  };
  struct Place {
    Eigen::Index turn = 0;
    double angle = 0.0;  // within it
  };

  Place place_of(double psi) const {
    const double whole = std::floor(psi / kTurn);
    const Eigen::Index turn = static_cast<Eigen::Index>(whole) % equations_.period();
    return {turn < 0 ? turn + equations_.period() : turn,
            std::clamp(psi - whole * kTurn, 0.0, kTurn)};
  }

  std::optional<Linearised> linearise(const Vector& y, int stop) {
    const Eigen::Index n = y.size() - 2, m = equations_.map().size();
    const std::optional<Corrector::Linearised> orbit =
        corrector_.linearise(y.head(n + 1), Vector::Zero(n + 1));
    if (!orbit) return {};
    const Place place = place_of(y[n + 1]);
    const double range = corrector_.range();
    const std::optional<StrobeEquations::Touching> at =
        equations_.touching(y.segment(place.turn * m, m), y[n] * range, place.angle, stop);
    if (!at) return {};
    Linearised result{Vector(n + 2), Matrix::Zero(n + 2, n + 2), at->push,
                      orbit->bordered.topRows(n)};
    result.residual << orbit->residual, at->value;
    result.slope.topLeftCorner(n, n + 1) = result.orbits;
    result.slope.block(n, place.turn * m, 2, m) = at->by_state;
    result.slope.block(n, n, 2, 1) = range * at->by_parameter;
    result.slope.block(n, n + 1, 2, 1) = at->by_angle;
    if (!result.slope.allFinite()) return {};
    return result;
  }

  StrobeBorder border(const Vector& y, const Linearised& at, int stop) {
    const Eigen::Index n = y.size() - 2;
    const Place place = place_of(y[n + 1]);
    StrobeBorder border;
    border.at.u = y.head(n);
    border.at.parameter = y[n] * corrector_.range();
    border.at.residual = at.residual.head(n).cwiseAbs().maxCoeff();
    border.at.tangent = null_vector(at.orbits);
    border.touch = {stop, static_cast<std::size_t>(place.turn), place.angle,
                    equations_.speed_unit(border.at) * std::sqrt(2.0 * kDepth * std::abs(at.push))};
    return border;
  }

  const StrobeEquations& equations_;
  Corrector corrector_;
  const ContinuationOptions& options_;
};

int sign_of_orientation(const StrobeEquations& equations, const ContinuationOptions& options,
                        const BranchPoint& at) {
  Corrector corrector(equations.problem(), options);
  const auto linearised = corrector.linearise(corrector.pack(at), at.tangent);
  return linearised ? LuFactors(linearised->bordered).determinant_sign() : 0;
}

}  // namespace

std::optional<StrobeBorder> touch_between(const StrobeEquations& equations,
                                          const ContinuationOptions& options, const BranchPoint& a,
                                          const BranchPoint& b, int stop) {
  TouchSearch search(equations, options);
  std::optional<StrobeBorder> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const BranchPoint* from : {&a, &b})
    for (const StrobeTouch& touch : equations.touches_near(*from)) {
      if (touch.stop != stop) continue;
      const std::optional<StrobeBorder> border = search.near(*from, touch);
      const std::optional<double> part =
          border ? search.part_between(a, b, border->at) : std::nullopt;
      if (!part || !(*part < nearest)) continue;
      nearest = *part;
      best = border;
    }
  if (!best) return {};
  // The orientation is constant along a branch, whereas where it turns back the tangents may be
  // more than a right angle apart.
  best->at.orientation = sign_of_orientation(equations, options, best->at);
  const bool runs_back = a.orientation != 0 ? best->at.orientation * a.orientation < 0
                                            : best->at.tangent.dot(a.tangent) < 0.0;
  if (runs_back) best->at.turn_round();
  return best;
}

}  // namespace graze
