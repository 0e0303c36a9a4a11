#include "graze/motion/detail/amplitude_meter.hpp"

#include <array>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <utility>

#include "graze/base/detail/bracketed_zero.hpp"
#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/flow/held/detail/series_phase.hpp"
#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/stepped/detail/step_flow.hpp"
#include "graze/flow/variation/detail/arc_integrals.hpp"
#include "graze/motion/detail/arc_extent.hpp"
#include "graze/motion/detail/contact_forces.hpp"

namespace graze {
namespace {

// Nodes of a step: its ends, and the nodes of Gauss' rule between them, in rising order.
constexpr std::size_t kNodes = 9;
using Nodes = std::array<double, kNodes>;

struct StepRule {
  Nodes at, weight;  // s; of the ends zero
};

StepRule rule_over(double from, double to) {
  using Rule = boost::math::quadrature::gauss<double, kNodes - 2>;
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  StepRule rule{};
  rule.at.front() = from;
  rule.at.back() = to;
  constexpr std::size_t kMiddle = kNodes / 2;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
    rule.at[kMiddle + k] = middle + half * Rule::abscissa()[k];
    rule.at[kMiddle - k] = middle - half * Rule::abscissa()[k];
    rule.weight[kMiddle + k] = rule.weight[kMiddle - k] = half * Rule::weights()[k];
  }
  return rule;
}

// The extremes of the polynomial through the nodes.
template <class Note>
void note_between(const Nodes& at, const Nodes& values, const Note& note) {
  const boost::math::barycentric_rational<double> polynomial(at.data(), values.data(), kNodes,
                                                             kNodes - 1);
  const auto slope = [&](double s) { return polynomial.prime(s); };
  double before = slope(at.front());
  note(values.front());
  for (std::size_t k = 1; k < kNodes; ++k) {
    const double after = slope(at[k]);
    if (before * after < 0.0)
      note(polynomial(bracketed_zero(slope, {at[k - 1], before}, {at[k], after}).first));
    note(values[k]);
    before = after;
  }
}

template <class Extent>
void extend(const ExactPhase<double>& phase, const Observable<double>& observable, double from,
            double to, Extent& extent) {
  extent.lowest = lowest_along(phase, observable, from, to, extent.lowest);
  extent.highest = highest_along(phase, observable, from, to, extent.highest);
}

template <class Sums>
void integrate(const ExactPhase<double>& phase, const Observable<double>& observable, double from,
               double to, Sums& sums) {
  const auto add = [&](double s, double sign) {
    const ArcIntegrals part = integrals_along(phase, observable, s);
    sums.value += sign * part.value;
    sums.square += sign * part.square;
    sums.turned += sign * part.turned;
  };
  add(to, 1.0);
  if (from > 0.0) add(from, -1.0);
}

}  // namespace

AmplitudeMeter::AmplitudeMeter(const System& system, const std::optional<MeasureOptions>& options)
    : system_(system),
      options_(options),
      measured_(options ? options->rows.size() : 0),
      loads_(system.stops.size()) {
  if (options && options->windows)
    windows_.emplace(system.stops.size(), options->from, *options->windows);
}

void AmplitudeMeter::Extent::note(double value) {
  highest = std::max(highest, value);
  lowest = std::min(lowest, value);
}

void AmplitudeMeter::add_impulse(int stop, double time, double impulse) {
  load(stop).impulse += impulse;
  if (windows_) windows_->add(stop, time, impulse);
}

template <class Each>
void AmplitudeMeter::each_part(double time, double from, double to, const Each& each) const {
  if (!windows_) {
    each(from, to);
    return;
  }
  // Windows are cut in the time of the run, flights in their own.
  windows_->each_part(time + from, time + to, [&](double begin, double end) {
    const double a = begin == time + from ? from : begin - time;
    const double b = end == time + to ? to : end - time;
    if (b > a) each(a, b);
  });
}

void AmplitudeMeter::add_impact(const std::vector<ImpactShare<double>>& shares, double time) {
  if (!measures(time)) return;
  for (const ImpactShare<double>& share : shares) {
    Load& at = load(share.stop);
    const Stop& stop = system_.stops[static_cast<std::size_t>(share.stop)];
    if (share.hit) ++at.impacts;
    add_impulse(share.stop, time, share.impulse / stop.row.squaredNorm());
    at.struck = at.struck || share.impulse != 0.0;
  }
}

void AmplitudeMeter::add_contact(int stop, double time) {
  if (measures(time)) ++load(stop).impacts;
}

// taken = sum_i direction_i p_i
void AmplitudeMeter::add_closure(const std::vector<int>& stops, const Vector& taken, double time) {
  if (!measures(time)) return;
  const auto n = static_cast<Eigen::Index>(stops.size());
  const auto stop = [&](Eigen::Index a) -> const Stop& {
    return system_.stops[static_cast<std::size_t>(stops[static_cast<std::size_t>(a)])];
  };
  Matrix acting(n, n);
  Vector speeds(n);
  for (Eigen::Index a = 0; a < n; ++a) {
    speeds[a] = stop(a).row.dot(taken);
    for (Eigen::Index b = 0; b < n; ++b) acting(a, b) = stop(a).row.dot(stop(b).direction());
  }
  const Vector impulses = PivotedLu<double>(acting).solve(speeds);
  for (Eigen::Index a = 0; a < n; ++a)
    add_impulse(stops[static_cast<std::size_t>(a)], time, impulses[a] / stop(a).row.squaredNorm());
}

void AmplitudeMeter::add_flight(const ContactPhase<double>& phase, double theta, double time,
                                double seconds) {
  const double from = options_ ? std::max(options_->from - time, 0.0) : seconds;
  if (!(seconds > from)) return;
  duration_ += seconds - from;
  if (phase.stepped() || phase.series())
    add_steps(phase, theta, time, from, seconds);
  else
    add_exact(phase, time, from, seconds);
}

void AmplitudeMeter::add_exact(const ContactPhase<double>& of, double time, double from,
                               double to) {
  const ExactPhase<double>& phase = *of.exact();
  const std::vector<MeasuredRow>& rows = options_->rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Observable<double> velocity = velocity_of(phase.structure(), rows[i]);
    const Observable<double> own =
        rows[i].of_velocity ? velocity : displacement_of(phase.structure(), rows[i]);
    extend(phase, own, from, to, measured_[i].sums.extent);
    integrate(phase, own, from, to, measured_[i].sums);
    if (!rows[i].of_velocity) extend(phase, velocity, from, to, measured_[i].speed);
  }
  for (const int i : phase.closed()) {
    if (system_.is_friction(i)) continue;
    load(i).held += to - from;
    add_force(phase, i, phase.observables()[static_cast<std::size_t>(i)], time, from, to);
  }
  const SpringArc* springs = phase.sprung();
  if (!springs) return;
  const std::vector<int>& loaded = springs->springs().loaded;
  for (std::size_t k = 0; k < loaded.size(); ++k)
    add_force(phase, loaded[k],
              linear_force(springs->equations.springs[k].law, springs->depth_observables[k]), time,
              from, to);
}

void AmplitudeMeter::add_force(const ExactPhase<double>& phase, int stop,
                               const Observable<double>& force, double time, double from,
                               double to) {
  Load& at = load(stop);
  extend(phase, force, from, to, at.force.extent);
  integrate(phase, force, from, to, at.force);
  if (!windows_) return;
  each_part(time, from, to, [&](double begin, double end) {
    Sums part;
    integrate(phase, force, begin, end, part);
    windows_->add(stop, time + 0.5 * (begin + end), part.value);
  });
}

void AmplitudeMeter::add_steps(const ContactPhase<double>& phase, double theta, double time,
                               double from, double to) {
  const auto visit = [&](double begin, double end) {
    if (end > from)
      each_part(time, std::max(begin, from), end,
                [&](double a, double b) { add_step(phase, theta, time, a, b); });
  };
  if (phase.stepped()) {
    phase.stepped()->each_step(to, visit);
    return;
  }
  double begin = 0.0;
  for (const double end : phase.series()->step_ends(to)) {
    visit(begin, end);
    begin = end;
  }
}

void AmplitudeMeter::add_step(const ContactPhase<double>& phase, double theta, double time,
                              double from, double to) {
  const StepRule rule = rule_over(from, to);
  for (const int i : phase.closed()) load(i).held += to - from;
  const std::vector<MeasuredRow>& rows = options_->rows;
  const double frequency = system_.forcing() ? system_.forcing()->frequency : 0.0;
  std::vector<Nodes> values(rows.size()), rates(rows.size()), forces(loads_.size());
  State state{Vector(system_.modes()), Vector(system_.modes())};
  std::vector<double> force;
  for (std::size_t k = 0; k < kNodes; ++k) {
    phase.state(rule.at[k], state.q, state.qdot);
    contact_forces(system_, phase, rule.at[k], state, force);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double at = theta + frequency * rule.at[k];
      rates[i][k] = rows[i].row.dot(state.qdot) + rows[i].carried_rate(at);
      values[i][k] = rows[i].of_velocity ? rates[i][k]
                                         : rows[i].row.dot(state.q) + rows[i].carried_at(at);
    }
    for (std::size_t i = 0; i < loads_.size(); ++i) forces[i][k] = force[i];
  }
  const auto add = [&](const Nodes& of, Sums& sums) {
    note_between(rule.at, of, [&](double value) { sums.extent.note(value); });
    for (std::size_t k = 0; k < kNodes; ++k) {
      sums.value += rule.weight[k] * of[k];
      sums.square += rule.weight[k] * of[k] * of[k];
      sums.turned += rule.weight[k] * of[k] * std::polar(1.0, -theta - frequency * rule.at[k]);
    }
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    add(values[i], measured_[i].sums);
    if (!rows[i].of_velocity)
      note_between(rule.at, rates[i], [&](double value) { measured_[i].speed.note(value); });
  }
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    if (forces[i] == Nodes{}) continue;
    const double before = loads_[i].force.value;
    add(forces[i], loads_[i].force);
    if (windows_)
      windows_->add(static_cast<int>(i), time + 0.5 * (from + to), loads_[i].force.value - before);
  }
}

std::optional<Amplitudes> AmplitudeMeter::result() const {
  if (!options_) return {};
  Amplitudes result;
  result.duration = duration_;
  const bool passed = duration_ > 0.0;
  for (const auto& [sums, speed] : measured_) {
    Amplitude& row = result.rows.emplace_back();
    if (!passed) continue;
    row.highest = sums.extent.highest;
    row.lowest = sums.extent.lowest;
    row.mean = sums.value / duration_;
    row.rms = std::sqrt(std::fmax(sums.square, 0.0) / duration_);
    if (speed.highest >= speed.lowest) row.speed = std::fmax(speed.highest, -speed.lowest);
    if (system_.forcing()) row.harmonic = 2.0 / duration_ * sums.turned;
  }
  for (const Load& load : loads_) {
    StopLoad& stop = result.stops.emplace_back();
    stop.impacts = load.impacts;
    stop.impulse = load.impulse + load.force.value;
    stop.held = load.held;
    if (load.struck) continue;
    stop.peak_force = std::fmax(load.force.extent.highest, 0.0);
    stop.rms_force = passed ? std::sqrt(std::fmax(load.force.square, 0.0) / duration_) : 0.0;
  }
  if (windows_) result.forces = windows_->forces(duration_);
  return result;
}

}  // namespace graze
