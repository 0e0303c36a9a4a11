#include "graze/bifurcation/problem/detail/segment_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/continuation/map.hpp"
#include "graze/flow/variation/detail/sprung_deviation.hpp"
#include "graze/orbit/problem/detail/laid_orbit.hpp"
#include "graze/orbit/problem/detail/solve.hpp"

namespace graze {

namespace {

// On rigid stops alone they are the closed forms of flights, to rounding.
constexpr double kRigidAccuracy = 4.0 * std::numeric_limits<double>::epsilon();
// The test for a multiplier is formed from slopes: it vanishes to what these are known to, times
// what solving with them costs.
constexpr double kCritical = 1e3 * kMapAccuracy;

}  // namespace

SegmentEquations::SegmentEquations(const Scene& scene, const std::vector<std::string>& parameters,
                                   std::vector<double> units, const System& reference,
                                   const SegmentLayout& layout, const SegmentOptions& options)
    : SegmentEquations(scene, parameters, std::move(units), motion_scale(reference),
                       SegmentShooting(reference, layout, options)) {}

SegmentEquations::SegmentEquations(const Scene& scene, const std::vector<std::string>& parameters,
                                   std::vector<double> units, const MotionScale& scale,
                                   SegmentShooting shooting)
    : OrbitProblem(scene, parameters),
      scene_(scene),
      parameters_(parameters),
      units_(std::move(units)),
      scale_(scale),
      shooting_(std::move(shooting)) {
  problem_.wrap = shooting_.wrap();
}

std::unique_ptr<OrbitProblem> SegmentEquations::laid(SegmentLayout layout) const {
  return std::unique_ptr<OrbitProblem>(
      new SegmentEquations(scene_, parameters_, units_, scale_, shooting_.over(std::move(layout))));
}

std::unique_ptr<OrbitProblem> SegmentEquations::doubled() const {
  SegmentLayout twice = layout();
  twice.period *= 2;
  if (!twice.released) twice.sections *= 2;
  return laid(std::move(twice));
}

double SegmentEquations::critical_tolerance() { return kCritical; }

std::optional<ShootingLinearisation> SegmentEquations::linearise(
    const System& system, const Vector& u, std::span<const System* const> tangents) const {
  return shooting_.linearise(system, u, tangents);
}

std::vector<Eigenvalue> SegmentEquations::multipliers(const System& system, const Vector& u,
                                                      ErrorBounds errors) const {
  return shooting_.multipliers(system, u, errors);
}

// By central differences, each over the sections that it moves.
std::optional<Eigen::MatrixXcd> SegmentEquations::curvature(
    const Vector& u, Parameters at, const std::vector<CriticalProduct>& products) const {
  std::vector<SegmentProduct> list;
  for (const CriticalProduct& one : products) list.push_back({one.left, one.right, one.multiplier});
  const Eigen::Index n = u.size(), m = static_cast<Eigen::Index>(at.size());
  const Eigen::Index head = shooting_.head(), size = map().size();
  // Differences of slopes err least over steps of the cube root of what these are known to, in
  // units of the unknowns and of the parameters.
  const double length = std::cbrt(layout().closed.empty() ? kMapAccuracy : kRigidAccuracy);
  Eigen::MatrixXcd rows = Eigen::MatrixXcd::Zero(std::ssize(list), n + m);
  for (Eigen::Index j = 0; j < n + m; ++j) {
    const bool is_local = j >= head && j < n;
    const int first = is_local ? static_cast<int>((j - head) / size) : 0;
    const int last = is_local ? first : layout().sections - 1;
    const auto parameter = static_cast<std::size_t>(std::max<Eigen::Index>(j - n, 0));
    const double step = j < n ? length : length * units_[parameter];
    for (const double side : {1.0, -1.0}) {
      Vector moved = u;
      std::vector<double> there(at.begin(), at.end());
      (j < n ? moved[j] : there[parameter]) += side * step;
      const System* system = system_at(there);
      for (int i = first; i <= last; ++i) {
        const auto sums =
            system ? shooting_.products(*system, moved, i, list) : std::optional<ComplexVector>();
        if (!sums) return {};
        rows.col(j) += side / (2.0 * step) * *sums;
      }
    }
  }
  return rows;
}

Vector SegmentEquations::halves_differ(const SolutionPoint& solution) const {
  if (period() % 2 != 0) return {};
  if (layout().sections % 2 == 0) {
    const Eigen::Index half = solution.u.size() / 2;
    return solution.u.tail(half) - solution.u.head(half);
  }
  return halves_.answer({solution.u, solution.parameter}, [&] {
    const System* system = system_at(solution.parameter);
    if (!system) return Vector();
    SegmentLayout half_layout = layout();
    half_layout.period /= 2;
    const SegmentShooting half = shooting_.over(std::move(half_layout));
    const auto at = half.linearise(*system, solution.u, {});
    return at ? at->residual : Vector();
  });
}

std::optional<OrbitBranchPoint> SegmentEquations::judge(const SolutionPoint& solution) const {
  return judged_.answer({solution.u, solution.parameter}, [&]() -> std::optional<OrbitBranchPoint> {
    const System* system = system_at(solution.parameters());
    if (!system) return {};
    std::vector<Eigenvalue> multipliers = solution.multipliers;
    if (multipliers.empty() && !layout().released)
      multipliers = shooting_.multipliers(*system, solution.u, ErrorBounds::kGiven);
    std::optional<Orbit> orbit = orbit_of(*system, shooting_, solution.u, std::move(multipliers));
    if (!orbit) return {};
    return point_of_branch(solution.parameter, std::move(*orbit));
  });
}

void SegmentEquations::name(OrbitBranch& branch) const {
  branch.pattern.period = period();
  if (branch.points.empty()) return;
  // At its ends an impact or a stuck phase may be lost.
  const Orbit& orbit = branch.points[branch.points.size() / 2].orbit;
  if (orbit.sticks())
    for (const StickingPhase& sticking : orbit.sticking) branch.sticking.push_back(sticking.stop);
  else
    branch.pattern = orbit.pattern();
}

std::string SegmentEquations::why_not_continued(const SolutionPoint& solution) const {
  if (!layout().released) return {};
  const std::optional<ReleaseReturn> back = follow(solution);
  if (!back || !back->returns) return "the orbit that sticks was not found again at its release";
  if (!has_shrunk(*back, period_at(solution))) return {};
  return "an orbit with stuck phases without end (a chatter on one stop throws the structure off "
         "another) is not continued";
}

std::optional<ReleaseReturn> SegmentEquations::follow(const SolutionPoint& solution,
                                                      bool minima) const {
  return followed_.answer({solution.u, solution.parameter, minima}, [&] {
    const System* system = system_at(solution.parameter);
    return system ? return_of(*system, shooting_, solution.u, minima)
                  : std::optional<ReleaseReturn>();
  });
}

std::optional<std::vector<SegmentMargin>> SegmentEquations::margins(const SolutionPoint& solution,
                                                                    double range) const {
  const System* system = system_at(solution.parameters());
  const System* tangent = system ? systems_.tangent_at(solution.parameters(), 0) : nullptr;
  if (!tangent) return {};
  const Eigen::Index n = solution.u.size();
  return shooting_.margins(*system, solution.u, *tangent, solution.tangent.head(n),
                           solution.rate() * range);
}

std::vector<int> SegmentEquations::stops_met(const SolutionPoint& solution) const {
  const System* system = system_at(solution.parameters());
  const std::optional<Orbit> orbit =
      system ? orbit_of(*system, shooting_, solution.u, {}) : std::nullopt;
  if (!orbit) return {};
  std::vector<int> stops = orbit->pattern().stops;
  std::sort(stops.begin(), stops.end());
  return stops;
}

bool SegmentEquations::sets_in_smoothly(const SolutionPoint& solution, int stop) const {
  const System* system = system_at(solution.parameters());
  const Stop* met = system ? &system->stops[static_cast<std::size_t>(stop)] : nullptr;
  return met && met->is_compliant() && met->force().sets_in_smoothly();
}

std::optional<double> SegmentEquations::clearer_section(const SolutionPoint& solution) const {
  // Far enough for a step, near enough for few moves.
  constexpr double kPart = 0.25;
  const System* system = system_at(solution.parameters());
  const auto is_smooth = [](const Stop& stop) {
    return stop.is_compliant() && stop.force().sets_in_smoothly();
  };
  if (!system || std::all_of(system->stops.begin(), system->stops.end(), is_smooth)) return {};
  const std::optional<OrbitBranchPoint> at = judge(solution);
  if (!at) return {};
  std::vector<double> phases;
  for (const OrbitImpact& impact : at->orbit.impacts) {
    const Stop& stop = system->stops[static_cast<std::size_t>(impact.stop)];
    if (is_smooth(stop)) continue;
    phases.push_back(impact.phase);
    if (stop.is_compliant())
      phases.push_back(
          wrapped(impact.phase + system->forcing()->frequency * impact.contact->duration));
  }
  if (phases.empty()) return {};
  std::sort(phases.begin(), phases.end());
  double best = 0.0, middle = 0.0, nearest = kTurn;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double next = i + 1 < phases.size() ? phases[i + 1] : phases.front() + kTurn;
    const double ahead = wrapped(phases[i] - layout().theta);
    nearest = std::min({nearest, ahead, kTurn - ahead});
    if (next - phases[i] <= best) continue;
    best = next - phases[i];
    middle = wrapped(0.5 * (phases[i] + next));
  }
  return nearest < kPart * 0.5 * best ? std::optional(middle) : std::nullopt;
}

std::optional<SolutionPoint> SegmentEquations::carried_to(const OrbitProblem& other,
                                                          const ContinuationOptions& options,
                                                          const SolutionPoint& solution) const {
  const System* system = system_at(solution.parameters());
  const System* tangent = system ? systems_.tangent_at(solution.parameters(), 0) : nullptr;
  if (!tangent) return {};
  const double there = std::get<SegmentLayout>(other.orbit_layout()).theta;
  const double angle = wrapped(there - layout().theta);
  const double range = std::abs(options.to - options.from);
  const Eigen::Index m = map().size(), n = solution.u.size();
  SolutionPoint carried = solution;
  for (Eigen::Index i = 0; i < n; i += m) {
    const auto at = map().within(*system, solution.u.segment(i, m), layout().theta, angle, false,
                                 std::span(&tangent, 1));
    if (!at) return {};
    carried.u.segment(i, m) = map().pack(at->state);
    const Vector along = solution.tangent.segment(i, m);
    const State& moved = at->by_parameters.front();
    const double rate = solution.rate() * range;
    carried.tangent.segment(i, m) = map().pack(
        {at->by_state.q * along + rate * moved.q, at->by_state.qdot * along + rate * moved.qdot});
  }
  return solve_near(other.problem(), options, carried.u, carried.parameter, carried.tangent);
}

bool has_same_events(const ReleaseReturn& back, const ReleaseReturn& other, bool impacts) {
  return back.returns && back.sticking == other.sticking &&
         (!impacts || back.itinerary.events == other.itinerary.events);
}

SolutionPoint SegmentEquations::twice_round(const SolutionPoint& solution) const {
  if (!layout().released) return graze::twice_round(solution);
  SolutionPoint same = solution;
  same.multipliers.clear();
  return same;
}

std::unique_ptr<OrbitProblem> SegmentEquations::clearer(const SolutionPoint& solution) const {
  // A release lies where it lies.
  const std::optional<double> section =
      layout().released ? std::nullopt : clearer_section(solution);
  if (!section) return {};
  SegmentLayout moved = layout();
  moved.theta = *section;
  return laid(std::move(moved));
}

std::vector<SolutionPoint> SegmentEquations::rewritings(const OrbitProblem& of,
                                                        const ContinuationOptions& options,
                                                        const SolutionPoint& solution) const {
  std::vector<SolutionPoint> list;
  const auto* other = dynamic_cast<const SegmentEquations*>(&of);
  if (!other || other->period() != period() ||
      other->layout().released.has_value() != layout().released.has_value())
    return list;
  if (layout().released) {
    const std::optional<OrbitBranchPoint> at = other->judge(solution);
    const System* system = system_at(solution.parameter);
    if (!at || !system) return list;
    for (const LaidOrbit& laid : layouts_of(*system, at->orbit, map().options())) {
      if (!(laid.layout == layout())) continue;
      list.push_back(solution);
      list.back().u = shooting_.pack(laid.theta, laid.states);
    }
    return list;
  }
  const std::optional<SolutionPoint> there =
      other == this ? solution : other->carried_to(*this, options, solution);
  const Eigen::Index n = map().size(), size = solution.u.size();
  for (Eigen::Index first = 0; there && first < size; first += n) {
    list.push_back(*there);
    list.back().u << there->u.tail(size - first), there->u.head(first);
    list.back().tangent.head(size) << there->tangent.segment(first, size - first),
        there->tangent.head(first);
  }
  return list;
}

}  // namespace graze
