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

// On rigid stops alone slopes are closed forms of flights, accurate to rounding.
constexpr double kRigidAccuracy = 4.0 * std::numeric_limits<double>::epsilon();
// The test for a multiplier is formed from slopes: it vanishes to their error times the loss by
// solving with them.
constexpr double kCritical = 1e3 * kMapAccuracy;

// Slopes of the map are smooth except where a contact is born, or passes a section: beside that
// they vary with the root of the distance, as the duration of the contact does. Over steps of x
// times the distance a central difference has an error of x^2/8: 5 % for x = .6, where durations
// differ twofold, which is enough for Newton's method; 5e-5 for x = .02, as needed for tangents,
// along which a locus is predicted.
constexpr double kLikeDuration = 2.0;
constexpr double kReach = 0.02;
// A step that reaches too far is taken shorter by this factor, until rounding alone makes its ends
// differ by this part of their difference: Newton's method needs no more accuracy.
constexpr double kShorter = 1.0 / 8.0;
constexpr double kLostDigits = 1e-2;

// Whether motions have the same contacts, none of which has almost vanished in one of them.
bool are_alike(const std::vector<PassedContact>& some, const std::vector<PassedContact>& others) {
  return std::ranges::equal(some, others, [](const PassedContact& a, const PassedContact& b) {
    const auto [shorter, longer] = std::minmax(a.duration, b.duration);
    return a.stop == b.stop && a.from_start == b.from_start && a.to_end == b.to_end &&
           longer <= kLikeDuration * shorter;
  });
}

// The difference of two such motions relative to their distance from there, by their durations.
double reach_of(const std::vector<PassedContact>& some, const std::vector<PassedContact>& others) {
  double reach = 0.0;
  for (std::size_t i = 0; i < some.size(); ++i) {
    const double a = some[i].duration * some[i].duration;
    const double b = others[i].duration * others[i].duration;
    if (a + b > 0.0) reach = std::max(reach, std::abs(a - b) / (a + b));
  }
  return reach;
}

bool is_smooth(const Stop& stop) { return stop.is_compliant() && stop.force().sets_in_smoothly(); }

// The forcing phase, rad, farthest from the beginnings and ends of contacts and from what friction
// does; with `jumps` only of those at which the derivative jumps. Returns nullopt when there are
// none, or when theta is at least a part of that far from them.
std::optional<double> section_clear_of(const System& system, const Orbit& orbit, double theta,
                                       bool jumps) {
  // Far enough for a step, near enough for few moves.
  constexpr double kPart = 0.25;
  std::vector<double> phases;
  for (const OrbitRubbing& event : orbit.rubbing) phases.push_back(event.at.phase);
  for (const OrbitImpact& impact : orbit.impacts) {
    const Stop& stop = system.stops[static_cast<std::size_t>(impact.stop)];
    if (jumps && is_smooth(stop)) continue;
    phases.push_back(impact.phase);
    if (stop.is_compliant())
      phases.push_back(
          wrapped(impact.phase + system.forcing()->frequency * impact.contact->duration));
  }
  if (phases.empty()) return {};
  std::sort(phases.begin(), phases.end());
  double best = 0.0, middle = 0.0, nearest = kTurn;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double next = i + 1 < phases.size() ? phases[i + 1] : phases.front() + kTurn;
    const double ahead = wrapped(phases[i] - theta);
    nearest = std::min({nearest, ahead, kTurn - ahead});
    if (next - phases[i] <= best) continue;
    best = next - phases[i];
    middle = wrapped(0.5 * (phases[i] + next));
  }
  return nearest < kPart * 0.5 * best ? std::optional(middle) : std::nullopt;
}

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

// By central differences, each over the sections that depend on it.
std::optional<Eigen::MatrixXcd> SegmentEquations::curvature(
    const Vector& u, Parameters at, const std::vector<CriticalProduct>& products) const {
  std::vector<SegmentProduct> list;
  for (const CriticalProduct& one : products) list.push_back({one.left, one.right, one.multiplier});
  const Eigen::Index n = u.size(), m = static_cast<Eigen::Index>(at.size());
  const Eigen::Index head = shooting_.head(), size = map().size();
  Eigen::MatrixXcd rows = Eigen::MatrixXcd::Zero(std::ssize(list), n + m);
  for (Eigen::Index j = 0; j < n + m; ++j) {
    const bool is_local = j >= head && j < n;
    const int first = is_local ? static_cast<int>((j - head) / size) : 0;
    const int last = is_local ? first : layout().sections - 1;
    for (int i = first; i <= last; ++i) {
      const std::optional<ComplexVector> rate = products_rate(u, at, j, i, list);
      if (!rate) return {};
      rows.col(j) += *rate;
    }
  }
  return rows;
}

std::optional<ComplexVector> SegmentEquations::products_rate(
    const Vector& u, Parameters at, Eigen::Index j, int section,
    const std::vector<SegmentProduct>& list) const {
  const Eigen::Index n = u.size();
  const auto moved_by = [&](double step) -> std::optional<SegmentShooting::Products> {
    Vector moved = u;
    std::vector<double> there(at.begin(), at.end());
    if (j < n)
      moved[j] += step;
    else
      there[static_cast<std::size_t>(j - n)] += step * units_[static_cast<std::size_t>(j - n)];
    const System* system = system_at(there);
    if (!system) return {};
    return shooting_.products(*system, moved, section, list);
  };
  // Differences of slopes have the smallest error over steps of the cube root of the slopes' error,
  // in units of the unknowns and of the parameters.
  const double accuracy = layout().closed.empty() ? kMapAccuracy : kRigidAccuracy;
  const double unit = j < n ? 1.0 : units_[static_cast<std::size_t>(j - n)];
  std::optional<ComplexVector> rate;
  for (double step = std::cbrt(accuracy); step * kLostDigits >= accuracy;) {
    const auto ahead = moved_by(step), behind = moved_by(-step);
    if (!ahead || !behind) return rate;
    if (!are_alike(ahead->contacts, behind->contacts)) {
      step *= kShorter;
      continue;
    }
    const bool again = rate.has_value();
    rate = (ahead->sums - behind->sums) / (2.0 * step * unit);
    const double reach = reach_of(ahead->contacts, behind->contacts);
    if (again || reach <= kReach) return rate;
    step *= kReach / reach;
  }
  return rate;
}

Vector SegmentEquations::halves_differ(const SolutionPoint& solution) const {
  if (period() % 2 != 0 || shooting_.is_free()) return {};
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
    // Where the motion has not come to rest on that stop by then, its state there has nothing to do
    // with that of a release, and no change of the sign of their difference means anything.
    if (const std::optional<int> stop = layout().released) {
      const std::optional<ReleaseReturn> back = return_of(*system, half, solution.u);
      if (!back || std::count(back->sticking.begin(), back->sticking.end(), *stop) == 0)
        return Vector();
    }
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
  const System* system = system_at(solution.parameters());
  if (!system || (std::ranges::all_of(system->stops, is_smooth) && system->frictions.empty()))
    return {};
  const std::optional<OrbitBranchPoint> at = judge(solution);
  if (!at) return {};
  return section_clear_of(*system, at->orbit, layout().theta, true);
}

std::unique_ptr<OrbitProblem> SegmentEquations::clear_of_contacts(const Vector& u,
                                                                  Parameters at) const {
  const System* system = layout().released || shooting_.is_free() ? nullptr : system_at(at);
  const std::optional<Orbit> orbit = system ? orbit_of(*system, shooting_, u, {}) : std::nullopt;
  const std::optional<double> section =
      orbit ? section_clear_of(*system, *orbit, layout().theta, false) : std::nullopt;
  return section ? at_section(*section) : nullptr;
}

std::unique_ptr<OrbitProblem> SegmentEquations::at_section(double theta) const {
  SegmentLayout moved = layout();
  moved.theta = theta;
  return laid(std::move(moved));
}

std::optional<Vector> SegmentEquations::carried(const Vector& u, Parameters at,
                                                double theta) const {
  const System* system = system_at(at);
  if (!system) return {};
  const double angle = wrapped(theta - layout().theta);
  Vector there = u;
  for (Eigen::Index i = 0; i < u.size(); i += map().size()) {
    const auto within =
        map().within(*system, u.segment(i, map().size()), layout().theta, angle, false, {});
    if (!within) return {};
    there.segment(i, map().size()) = map().pack(*system, within->state);
  }
  return there;
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
    carried.u.segment(i, m) = map().pack(*system, at->state);
    const Vector along = solution.tangent.segment(i, m);
    const State& moved = at->by_parameters.front();
    const double rate = solution.rate() * range;
    carried.tangent.segment(i, m) = map().pack_rate(
        *system, *tangent, {rate * at->state.q, rate * at->state.qdot},
        {at->by_state.q * along + rate * moved.q, at->by_state.qdot * along + rate * moved.qdot});
  }
  return solve_near(other.problem(), options, carried.u, carried.parameter, carried.tangent);
}

bool has_same_events(const ReleaseReturn& back, const ReleaseReturn& other, bool impacts) {
  return back.returns && back.sticking == other.sticking &&
         (!impacts || back.itinerary.events == other.itinerary.events);
}

SolutionPoint SegmentEquations::twice_round(const SolutionPoint& solution) const {
  if (!layout().released && !shooting_.is_free()) return graze::twice_round(solution);
  SolutionPoint same = solution;
  same.multipliers.clear();
  return same;
}

std::unique_ptr<OrbitProblem> SegmentEquations::clearer(const SolutionPoint& solution) const {
  // A section at a release cannot be moved, nor one where a place is at rest.
  const std::optional<double> section =
      layout().released || shooting_.is_free() ? std::nullopt : clearer_section(solution);
  return section ? at_section(*section) : nullptr;
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
      list.back().u = shooting_.pack(*system, laid.theta, laid.states);
    }
    return list;
  }
  if (shooting_.is_free()) return other == this ? std::vector{solution} : list;
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
