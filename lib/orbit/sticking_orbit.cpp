#include "graze/orbit/sticking_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/orbit/orbit_clock.hpp"
#include "graze/orbit/passage.hpp"
#include "graze/orbit/polish.hpp"

namespace graze {
namespace {

std::vector<int> closed_stops(const MotionState<double>& at) {
  std::vector<int> closed;
  for (std::size_t i = 0; i < at.contacts.size(); ++i)
    if (at.contacts[i] == Contact::kClosed) closed.push_back(static_cast<int>(i));
  return closed;
}

// The stroboscopic map on the section where the stops of a motion's state are closed.
class HeldSection {
 public:
  HeldSection(const System& system, const MotionState<double>& at, const PassageOptions& options)
      : system_(&system), at_(at), scale_(motion_scale(system)), passage_(options) {
    const ContactPhase<double> phase(system, closed_stops(at));
    basis_ = phase.basis();
    unit_.resize(2 * freedoms());
    unit_ << Vector::Constant(freedoms(), scale_.displacement),
        scale_.displacement * phase.reduced().omega.cwiseMax(system.forcing()->frequency);
    at_.instant.period = 0;
  }

  Eigen::Index freedoms() const { return basis_.cols(); }
  const MotionState<double>& at() const { return at_; }

  struct Return {
    Passage passage;        // with its failure where the motion does not come back to the section
    double residual = 0.0;  // scaled, largest entry
    Vector defect;          // P - identity, scaled, 2(N - m)
    Matrix map;             // DP, scaled
  };

  Return after(int period, bool with_minima = false) const {
    const Eigen::Index m = freedoms();
    Return result;
    Deviations deviations{Matrix::Zero(system_->modes(), 2 * m),
                          Matrix::Zero(system_->modes(), 2 * m), Eigen::RowVectorXd::Zero(2 * m)};
    deviations.q.leftCols(m) = basis_;
    deviations.qdot.rightCols(m) = basis_;
    PassageOptions options = passage_;
    options.minima = with_minima;
    result.passage = pass(*system_, at_, {period, at_.instant.local}, options, &deviations);
    if (!result.passage.failure.empty()) return result;
    const MotionState<double>& end = result.passage.end;
    if (closed_stops(end) != closed_stops(at_)) {
      result.passage.failure = "the motion does not come back to its stuck phase";
      return result;
    }
    const Vector dq = end.q - at_.q, dqdot = end.qdot - at_.qdot;
    result.residual = std::max(dq.cwiseAbs().maxCoeff() / scale_.displacement,
                               dqdot.cwiseQuotient(scale_.velocity).cwiseAbs().maxCoeff());
    result.defect.resize(2 * m);
    result.defect << basis_.transpose() * dq, basis_.transpose() * dqdot;
    result.map.resize(2 * m, 2 * m);
    result.map << basis_.transpose() * deviations.q, basis_.transpose() * deviations.qdot;
    result.defect = result.defect.cwiseQuotient(unit_);
    result.map = unit_.cwiseInverse().asDiagonal() * result.map * unit_.asDiagonal();
    return result;
  }

  void move(const Vector& step) {
    const Vector change = step.cwiseProduct(unit_);
    at_.q += basis_ * change.head(freedoms());
    at_.qdot += basis_ * change.tail(freedoms());
  }

 private:
  const System* system_;
  MotionState<double> at_;
  MotionScale scale_;
  PassageOptions passage_;
  Matrix basis_;  // U
  Vector unit_;   // of (y, y')
};

// Newton's method on the section; a sentence where it does not converge, else empty.
std::string solve(HeldSection& section, int period) {
  struct Equations {
    Vector residual;
    Matrix jacobian;
    double whole;  // largest entry of the residual of the whole state
  };
  std::string failure = "Newton's method does not converge on the stuck section";
  const auto equations_at = [&](const Vector& u) -> std::optional<Equations> {
    HeldSection moved = section;
    moved.move(u);
    const HeldSection::Return back = moved.after(period);
    if (!back.passage.failure.empty()) {
      failure = back.passage.failure;
      return {};
    }
    return Equations{back.defect, back.map - Matrix::Identity(u.size(), u.size()), back.residual};
  };
  const auto solution = polish(Vector(Vector::Zero(2 * section.freedoms())), equations_at);
  if (!solution || !(solution->at.whole <= kShootingTolerance)) return failure;
  section.move(solution->u);
  return "";
}

// The middle of the longest stretch of a passage during which most stops are closed, s.
std::optional<double> stuck_instant(const Passage& passage, double period) {
  const auto time = [period](const Instant<double>& at) {
    return static_cast<double>(at.period) * period + at.local;
  };
  std::vector<double> ends;
  for (const PassedHold& hold : passage.holds) {
    ends.push_back(time(hold.from));
    ends.push_back(time(hold.to));
  }
  std::sort(ends.begin(), ends.end());
  std::optional<double> middle;
  std::ptrdiff_t most = 0;
  double longest = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double from = ends[i - 1], to = ends[i], now = 0.5 * (from + to);
    const auto closed = std::count_if(
        passage.holds.begin(), passage.holds.end(),
        [&](const PassedHold& hold) { return time(hold.from) < now && now < time(hold.to); });
    if (closed < most || closed == 0 || (closed == most && !(to - from > longest))) continue;
    middle = now;
    most = closed;
    longest = to - from;
  }
  return middle;
}

// Stuck phases of the orbit; one that the section cuts is put together again.
std::vector<OrbitHold> holds_of(const System& system, int period, const Passage& passage,
                                const OrbitClock& clock) {
  const auto seconds = [&](const PassedHold& hold) {
    return static_cast<double>(hold.to.period - hold.from.period) * system.period() +
           hold.to.local - hold.from.local;
  };
  std::vector<OrbitHold> holds;
  for (const PassedHold& hold : passage.holds) {
    if (hold.from_start && !hold.to_end) continue;  // the end of another
    OrbitHold whole{hold.stop,     clock(hold.from), clock(hold.to),
                    seconds(hold), hold.force,       hold.smallest_force};
    if (hold.to_end && !hold.from_start)
      for (const PassedHold& rest : passage.holds) {
        if (rest.stop != hold.stop || !rest.from_start) continue;
        whole.to = clock(rest.to);
        whole.duration += seconds(rest);
        if (rest.smallest_force)
          whole.smallest_force =
              std::min(whole.smallest_force.value_or(*rest.smallest_force), *rest.smallest_force);
      }
    if (hold.to_end && hold.from_start) whole.duration = period * system.period();
    holds.push_back(whole);
  }
  std::sort(holds.begin(), holds.end(), [](const OrbitHold& a, const OrbitHold& b) {
    return earlier(a.from, b.from) || (!earlier(b.from, a.from) && a.stop < b.stop);
  });
  return holds;
}

std::vector<Instant<double>> instants_of(const std::vector<PassedImpact>& impacts) {
  std::vector<Instant<double>> instants;
  for (const PassedImpact& impact : impacts) instants.push_back(impact.at);
  return instants;
}

Orbit orbit_of(const System& system, const HeldSection& section, const HeldSection::Return& back,
               int period, double closure_speed) {
  const OrbitClock clock(system, period, instants_of(back.passage.impacts));
  Orbit orbit;
  orbit.period = period;
  for (const PassedImpact& impact : back.passage.impacts) {
    const OrbitInstant at = clock(impact.at);
    orbit.impacts.push_back({impact.stop, at.period_index, at.phase, impact.speed, impact.before});
  }
  std::stable_sort(orbit.impacts.begin(), orbit.impacts.end(),
                   [](const OrbitImpact& a, const OrbitImpact& b) {
                     return earlier({a.period_index, a.phase}, {b.period_index, b.phase});
                   });
  if (back.map.rows() > 0) orbit.multipliers = eigenvalues(back.map);
  if (static_cast<Eigen::Index>(orbit.multipliers.size()) == back.map.rows())
    orbit.multipliers.resize(static_cast<std::size_t>(2 * system.modes()), {Complex(0.0), 0.0});
  orbit.stable = stability(orbit.multipliers);
  orbit.admissible = true;
  orbit.clearance = back.passage.clearance();
  orbit.residual = back.residual;
  orbit.holds = holds_of(system, period, back.passage, clock);
  orbit.section = OrbitSection{clock(section.at().instant), {section.at()}, closure_speed};
  return orbit;
}

// The number of periods after which the motion on the section repeats already, `period` if not
// earlier; the section then holds that orbit.
int shortest_period(HeldSection& section, int period) {
  for (int p = 1; p < period; ++p) {
    if (period % p != 0) continue;
    const HeldSection::Return back = section.after(p);
    if (!back.passage.failure.empty() || !(back.residual <= kShootingAccuracy)) continue;
    HeldSection shorter = section;
    if (!solve(shorter, p).empty()) continue;
    section = shorter;
    return p;
  }
  return period;
}

}  // namespace

StickingOrbitAnswer sticking_orbit(const System& system, const State& at_period_start, int period,
                                   const PassageOptions& options) {
  const MotionState<double> start =
      Motion<double>(system, {}, at_period_start.q, at_period_start.qdot).state();
  const Passage first = pass(system, start, {period, 0.0}, options);
  if (!first.failure.empty()) return {{}, first.failure};
  if (first.holds.empty())
    return {{}, fmt::format("no stop is closed within {} forcing periods", period)};
  if (first.impacts.empty())
    return {{},
            fmt::format("stop {} holds the structure without any impact: no impacting orbit",
                        first.holds.front().stop + 1)};
  const std::optional<double> instant = stuck_instant(first, system.period());
  if (!instant) return {{}, "no stop is closed for longer than an instant"};
  const double periods = std::floor(*instant / system.period());
  const Passage to_section =
      pass(system, start,
           {static_cast<long long>(periods),
            std::clamp(*instant - periods * system.period(), 0.0, system.period())},
           options);
  if (!to_section.failure.empty()) return {{}, to_section.failure};
  HeldSection section(system, to_section.end, options);
  const std::string failure = solve(section, period);
  if (!failure.empty()) return {{}, failure};
  const int shortest = shortest_period(section, period);
  return {orbit_of(system, section, section.after(shortest, true), shortest, options.closure_speed),
          ""};
}

StickingOrbitAnswer sticking_orbit_through(const System& system,
                                           const MotionState<double>& at_section, int period,
                                           const PassageOptions& options) {
  if (std::find(at_section.contacts.begin(), at_section.contacts.end(), Contact::kClosed) ==
      at_section.contacts.end())
    return {{}, "no stop is closed where the orbit is said to stick"};
  const HeldSection section(system, at_section, options);
  const HeldSection::Return back = section.after(period, true);
  if (!back.passage.failure.empty()) return {{}, back.passage.failure};
  return {orbit_of(system, section, back, period, options.closure_speed), ""};
}

}  // namespace graze
