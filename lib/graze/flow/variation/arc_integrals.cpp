#include "graze/flow/variation/detail/arc_integrals.hpp"

#include <cmath>
#include <optional>

#include "graze/flow/variation/detail/signal.hpp"

namespace graze {
namespace {

Complex complex(const PlanarNumber<double>& number) { return {number.re, number.im}; }

// Returns nullopt when a mode has no exponential form.
std::optional<Signal> free_signal(const Arc<double>& arc, const Observable<double>& observable) {
  const ExactFlow<double>& flow = arc.flow();
  Complex harmonic = complex(observable.harmonic);
  const Complex turn(0.0, flow.frequency());
  double constant = observable.constant;
  Signal signal;
  for (int j = 0; j < flow.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(j);
    const double x = observable.displacement[j];
    const double v = observable.velocity.size() > 0 ? observable.velocity[j] : 0.0;
    const auto add = [&](const Complex& size, const Complex& rate) {
      signal.push_back({(x + v * rate) * size, rate});
    };
    const PlanarNumber<double>& amplitude = arc.amplitude(j);
    if (mode.kind == ModeKind::kOscillatory) {
      add(complex(amplitude), {-mode.first, mode.second});
    } else if (mode.kind == ModeKind::kOverdamped) {
      add(amplitude.re, -mode.first);
      add(amplitude.im, -mode.second);
    } else {
      return {};
    }
    harmonic += (x + v * turn) * complex(mode.forced);
    constant += x * mode.offset;
  }
  if (constant != 0.0) signal.push_back({constant, 0.0});
  if (harmonic != 0.0) signal.push_back({harmonic * complex(arc.start_turn()), turn});
  return signal;
}

// Returns nullopt when some of the motion is no sum of well separated exponentials.
std::optional<Signal> signal_of(const ExactPhase<double>& phase,
                                const Observable<double>& observable) {
  if (const Arc<double>* arc = phase.arc()) return free_signal(*arc, observable);
  Signal signal;
  const auto add = [&](Complex size, Complex rate) { signal.push_back({size, rate}); };
  if (!phase.coupled_arc()->each_term(observable, add) || nearly_cancels(signal)) return {};
  return signal;
}

// Integral of Re(size e^{rate s}) e^{-i theta}, summed over the terms.
Complex turned_integral(const Signal& signal, double theta, double frequency, double s) {
  const Complex back(0.0, -frequency);
  Complex sum = 0.0;
  for (const SignalTerm& term : signal)
    sum += 0.5 * (term.size * exponential_integral(term.rate + back, s) +
                  std::conj(term.size) * exponential_integral(std::conj(term.rate) + back, s));
  return std::polar(1.0, -theta) * sum;
}

ArcIntegrals by_panels(const ExactPhase<double>& phase, const Arc<double>& arc,
                       const Observable<double>& observable, double s) {
  const ExactFlow<double>& flow = arc.flow();
  double quickest = 0.0;
  for (int j = 0; j < flow.modes(); ++j)
    quickest = std::fmax(quickest, flow.mode(j).omega + 2.0 * flow.mode(j).delta);
  // The highest frequency of the square and of the product with the forcing.
  quickest = 2.0 * std::fmax(quickest, flow.frequency());
  const ArcCurve<double> curve = phase.curve(observable, s);
  ArcIntegrals integrals;
  visit_nodes(s, quickest, [&](double at, double weight) {
    const double value = curve.at(at, 0).value;
    integrals.value += weight * value;
    integrals.square += weight * value * value;
    integrals.turned +=
        weight * value * std::polar(1.0, -arc.start_phase() - flow.frequency() * at);
  });
  return integrals;
}

ArcIntegrals signal_integrals(const Signal& signal, double theta, double frequency, double s) {
  ArcIntegrals integrals;
  for (const SignalTerm& term : signal)
    integrals.value += (term.size * exponential_integral(term.rate, s)).real();
  integrals.square = square_integral(signal, s);
  integrals.turned = turned_integral(signal, theta, frequency, s);
  return integrals;
}

ArcIntegrals by_moments(const CoupledArc& arc, const Observable<double>& observable, double s) {
  const Moments moments = moments_along(arc, s);
  const Eigen::Index m = observable.displacement.size();
  const Vector weight = weights_of(observable, arc, moments);
  const Vector with = moments.integral * weight;
  return {with[2 * m + 2] / moments.unit,
          weight.dot(with),
          {with[2 * m] / moments.unit, -with[2 * m + 1] / moments.unit}};
}

ArcIntegrals without_signal(const ExactPhase<double>& phase, const Observable<double>& observable,
                            double s) {
  const Arc<double>* arc = phase.arc();
  return arc ? by_panels(phase, *arc, observable, s)
             : by_moments(*phase.coupled_arc(), observable, s);
}

}  // namespace

ArcIntegrals integrals_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                             double s) {
  const std::optional<Signal> signal = signal_of(phase, observable);
  if (!signal) return without_signal(phase, observable, s);
  if (const Arc<double>* arc = phase.arc())
    return signal_integrals(*signal, arc->start_phase(), arc->flow().frequency(), s);
  const CoupledArc& arc = *phase.coupled_arc();
  return signal_integrals(*signal, arc.start_phase(), arc.flow().first_order().frequency, s);
}

double square_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                    double s) {
  const std::optional<Signal> signal = signal_of(phase, observable);
  return signal ? square_integral(*signal, s) : without_signal(phase, observable, s).square;
}

}  // namespace graze
