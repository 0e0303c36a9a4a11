#include "graze/record/records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/flow/sprung/detail/sprung_phase.hpp"
#include "graze/motion/detail/energy_changes.hpp"
#include "graze/system/detail/hub_state.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Number of first and last events; a table of up to twice as many and one shows them all.
constexpr std::size_t kShown = 10;

// Largest defect of the energy balance of a correct run, J. Rounding is multiplied by up to 2^8
// where motion is written about its forced response or rest position (exact_flow_impl.hpp), and
// energies are squares: 2^16. The flights, one per impact and one per forcing period at least, have
// errors of either sign, so that these add up like the root of their number. On a rotating hub the
// motion is integrated in steps of a quarter of its fastest oscillation, each to kStepTolerance of
// the velocities, whose squares may all have errors of one sign. Where modes are coupled or there
// are several harmonics, works come from moments of the motion over a flight (signal.hpp), whose
// rounding is that of the power of the response over the whole flight, once for each radian that
// its quickest mode turns.
double balance_rounding(const System& system, const Simulation& run) {
  constexpr double kAmplification = 0x1p16;
  const double periods = system.forcing() ? run.end_time / system.period() : 0.0;
  const double flights = 1.0 + periods + static_cast<double>(run.totals.impacts);
  double moments = 0.0;
  if (system.forcing() && !system.has_closed_forms()) {
    const Vector quickest = system.omega.cwiseMax(system.forcing()->frequency);
    const double response = system.forcing()->size().cwiseQuotient(quickest).squaredNorm();
    moments = 0.5 * response * std::pow(quickest.maxCoeff() * std::fmin(system.period(), longest_flight(system)), 2);
  }
  const double steps = system.turns() ? 4.0 * system.omega.maxCoeff() / kTurn * run.end_time : 0.0;
  return (kAmplification * std::numeric_limits<double>::epsilon() * std::sqrt(flights) +
          2.0 * kStepTolerance * steps) *
             run.energy->size() +
         std::numeric_limits<double>::epsilon() * std::sqrt(flights) * moments;
}

// How far a gap may fall below zero in a correct run, m: the forced response about which motion is
// written is at most 2^12 times as large as the gap (exact_flow_impl.hpp), and rounded. Infinite
// without a gap or forcing as a scale.
double gap_rounding(const System& system) {
  constexpr double kAmplification = 0x1p12;
  double reach = 0.0;
  for (const Stop& stop : system.stops) reach = std::fmax(reach, reach_at(system, stop));
  return reach > 0.0 ? kAmplification * std::numeric_limits<double>::epsilon() * reach
                     : std::numeric_limits<double>::infinity();
}

}  // namespace

void EventExcerpt::add(const Event& event) {
  ++count_;
  if (first_.size() < kShown) {
    first_.push_back(event);
    return;
  }
  last_.push_back(event);
  const std::size_t most = count_ > static_cast<long long>(2 * kShown + 1) ? kShown : kShown + 1;
  while (last_.size() > most) last_.pop_front();
}

long long EventExcerpt::left_out() const {
  return count_ - static_cast<long long>(first_.size() + last_.size());
}

EnergyEntries energy_entries(const System& system, const EnergyBalance& balance) {
  EnergyEntries entries;
  // On a hub the works of the torque and the weight.
  const Rotation* hub = system.rotation();
  if (system.forcing() || (hub && hub->torque)) entries.forcing = balance.work.forcing;
  if (system.load() || (hub && hub->weight)) entries.load = balance.work.load;
  const auto compliant = [](const Stop& stop) { return stop.is_compliant(); };
  if (!std::all_of(system.stops.begin(), system.stops.end(), compliant)) {
    entries.constraint = balance.work.constraint;
    entries.impacts = balance.impacts;
  }
  if (system.carried()) entries.stops = balance.work.stops;
  if (system.has_compliant_stop()) entries.contact = balance.work.contact;
  if (!system.frictions.empty()) entries.friction = balance.work.friction;
  const bool damped = (decay_rates(system).array() != 0.0).any();
  if (damped || (hub && hub->friction)) entries.dissipation = balance.work.dissipation;
  return entries;
}

double relative_defect(const EnergyBalance& balance) {
  const double defect = std::abs(balance.defect());
  return defect == 0.0 ? 0.0 : defect / balance.size();
}

std::vector<std::string> simulation_warnings(const System& system, const Simulation& run) {
  const RunTotals& totals = run.totals;
  std::vector<std::string> warnings;
  // Elastic impacts on several stops at once have errors of a few roundings of the energy each.
  constexpr double kRoundings = 16.0;
  const double energy = std::fmax(mechanical_energy(system, run.final.q, run.final.qdot),
                                  std::fmax(totals.energy_lost, totals.energy_added));
  const double rounding = kRoundings * std::numeric_limits<double>::epsilon() *
                          static_cast<double>(totals.impacts) * energy;
  const bool rigid = std::any_of(system.stops.begin(), system.stops.end(),
                                 [](const Stop& stop) { return !stop.is_compliant(); });
  if (rigid && totals.energy_added > rounding)
    warnings.push_back(
        fmt::format("impacts added {:.3g}{} of kinetic energy; the collocation impulse law can do "
                    "that, and so can unequal restitutions of stops that are hit at once",
                    totals.energy_added, unit_behind(system.units, "J")));
  if (totals.clamped_restitutions > 0)
    warnings.push_back(
        fmt::format("the restitution r(v) left 0 to 1 at {} impact{} and was clamped",
                    totals.clamped_restitutions, totals.clamped_restitutions == 1 ? "" : "s"));
  if (run.energy && !(std::abs(run.energy->defect()) <= balance_rounding(system, run)))
    warnings.push_back(fmt::format(
        "the energy balance does not close: {:.3g}{} are missing, {:.1e} of its largest "
        "entry, more than rounding explains; do not trust this run",
        run.energy->defect(), unit_behind(system.units, "J"), relative_defect(*run.energy)));
  if (totals.penetration > gap_rounding(system))
    warnings.push_back(
        fmt::format("a stop was penetrated by {:.3g}{}, more than rounding explains; do not trust "
                    "this run",
                    totals.penetration, unit_behind(system.units, "m")));
  return warnings;
}

std::optional<Outcome> stopped_outcome(StopReason stopped, std::size_t kept, std::size_t asked,
                                       const char* things) {
  if (stopped == StopReason::kNone) return {};
  const std::string left = fmt::format("{} of {} {} are kept", kept, asked, things);
  if (stopped == StopReason::kInterrupted) return Outcome{"interrupted", "stopped; " + left};
  return Outcome{"budget", "the budget of computing time was spent; " + left};
}

Outcome simulation_outcome(const Simulation& run) {
  switch (run.outcome) {
    case RunOutcome::kReachedEnd:
      return {"reached_end", run.message};
    case RunOutcome::kEventBudget:
      return {"event_budget", run.message + run.crowd};
    case RunOutcome::kTimeBudget:
      return {"time_budget", run.message + run.crowd};
    case RunOutcome::kNotFinite:
      return {"not_finite", run.message};
    case RunOutcome::kRefused:
      return {"refused", run.message};
    case RunOutcome::kInterrupted:
      return {"interrupted", run.message};
  }
  return {};
}

Outcome orbit_outcome(const FoundOrbits& found, const FinderOptions& options, StopReason stopped) {
  if (stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped before all starts were tried"};
  if (stopped == StopReason::kOutOfTime)
    return {"budget", "the budget of computing time was spent before all starts were tried"};
  if (!found.orbits.empty()) return {"found", ""};
  if (found.tried.empty())
    return {"none",
            "none of the chosen starts applies: the closed form is for one or two impacts, the "
            "simulation needs an initial state that does not lie beyond the stop" +
                (found.notes.empty() ? "" : " (" + found.notes.front() + ")")};
  std::string message = fmt::format(
      "no orbit{} in {} forcing period{} was found{}, from {}",
      options.impacts
          ? fmt::format(" with {} impact{}", *options.impacts, *options.impacts == 1 ? "" : "s")
          : "",
      options.period, options.period == 1 ? "" : "s",
      !options.impacts && found.simulated ? ", nor does the simulation settle on one" : "",
      found.tried);
  if (found.inadmissible > 0)
    message += fmt::format(
        "; {} solution{} of the equations {} inadmissible (penetrating a stop, or impacting at "
        "negative speed; --virtual lists these)",
        found.inadmissible, found.inadmissible == 1 ? "" : "s",
        found.inadmissible == 1 ? "is" : "are");
  if (!options.impacts) message += "; motions without impacts are found with --impacts 0";
  return {"none", message};
}

namespace {

// Accuracy of located special points, relative to the parameter's range.
constexpr double kLocated = 1e-10;

// Number of points of the branches that are orbits with a multiplier on the unit circle, and number
// of orbits. Not counted are special points, of this or another branch, and points beside an orbit
// with known stability, where a multiplier crosses the circle; likewise the ends of a branch.
std::pair<long long, long long> orbits_of_open_stability(const OrbitBranches& traced,
                                                         double range) {
  const auto is_special = [&](const OrbitBranch& branch, std::size_t i) {
    if (i == 0 || i + 1 == branch.points.size()) return true;
    for (const OrbitBranch& other : traced.branches)
      for (const SpecialPoint& special : other.special)
        if (std::abs(special.at.value - branch.points[i].value) <= kLocated * range) return true;
    return false;
  };
  long long open = 0, orbits = 0;
  for (const OrbitBranch& branch : traced.branches)
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const Orbit& orbit = branch.points[i].orbit;
      if (!orbit.admissible) continue;
      ++orbits;
      if (orbit.stable || is_special(branch, i)) continue;
      if (!is_special(branch, i - 1) && !is_special(branch, i + 1)) ++open;
    }
  return {open, orbits};
}

// The end of a sentence, for starts that led to no branch.
std::string why_nothing_was_traced(const OrbitBranches& traced, bool any) {
  if (traced.virtual_starts > 0)
    return "; every solution that was found is inadmissible: it penetrates a stop, or impacts at "
           "negative speed (--virtual traces these)";
  if (traced.starts == 1) return "; the one start led to no branch";
  if (traced.starts > 1) return fmt::format("; none of {} starts led to a branch", traced.starts);
  return any ? "" : "; --impacts any takes what motions settle on";
}

}  // namespace

Outcome branch_outcome(const OrbitBranches& traced, const BranchOptions& options) {
  if (traced.stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped; the branches traced so far are kept"};
  if (traced.stopped == StopReason::kOutOfTime)
    return {"budget",
            "the budget of computing time was spent; the branches traced so far are kept"};
  if (traced.branches.empty() && options.start)
    return {"no_orbit", fmt::format("no branch goes on from {}", options.start->at.id)};
  if (traced.branches.empty() && traced.cut_short == 0)
    return {"no_orbit",
            fmt::format("no ({}, {}) orbit was found for {} between {:g} and {:g}{}{}",
                        options.period, options.impacts, traced.parameter, options.from, options.to,
                        options.settled.empty() ? "" : ", and none that motions settle on",
                        why_nothing_was_traced(traced, !options.settled.empty()))};
  if (traced.cut_short > 0)
    return {"budget",
            fmt::format("{} of {} traces could not be followed to an end, so branches may be "
                        "missing or cut short",
                        traced.cut_short, traced.traced)};
  if (traced.meetings > 0)
    return {"budget", fmt::format("{} branch end{} where two impacts coincide; beyond it their "
                                  "order changes, which is not followed",
                                  traced.meetings, traced.meetings == 1 ? " lies" : "s lie")};
  if (const auto [open, orbits] =
          orbits_of_open_stability(traced, std::abs(options.to - options.from));
      open > 0)
    return {
        "on_the_circle",
        fmt::format("{} of {} orbits {} a multiplier on the unit circle within its error, away "
                    "from every special point: whether {} stable is open",
                    open, orbits, open == 1 ? "has" : "have", open == 1 ? "it is" : "they are")};
  return {"complete", ""};
}

}  // namespace graze
