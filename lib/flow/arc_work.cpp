#include "graze/flow/arc_work.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <limits>

namespace graze {
namespace {

using Signal = std::vector<SignalTerm>;

// integral of e^{l s}, without cancellation for small l s.
Complex exponential_integral(Complex l, double s) {
  const double growth = std::expm1(l.real() * s), turn = l.imag() * s;
  const double half = std::sin(0.5 * turn);
  const Complex change(growth * std::cos(turn) - 2.0 * half * half,
                       (1.0 + growth) * std::sin(turn));
  return l == 0.0 ? Complex(s) : change / l;
}

// integral of a b over [0, s]: Re x Re y = Re(x y + x y*)/2.
double product_integral(const Signal& a, const Signal& b, double s) {
  double sum = 0.0;
  for (const SignalTerm& x : a)
    for (const SignalTerm& y : b)
      sum +=
          0.5 * (x.size * y.size * exponential_integral(x.rate + y.rate, s) +
                 x.size * std::conj(y.size) * exponential_integral(x.rate + std::conj(y.rate), s))
                    .real();
  return sum;
}

// Panels over which nothing turns or decays by more than one radian; there 15 nodes integrate to
// rounding (the error is of order (1/2)^30/30!).
double panel_integral(const std::function<double(double)>& f, double s, double quickest) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const double panels = std::ceil(std::fmax(quickest * s, 1.0));
  double sum = 0.0;
  for (double k = 0.0; k < panels; ++k)
    sum += Rule::integrate(f, s * (k / panels), s * ((k + 1.0) / panels));
  return sum;
}

// Velocity of a mode of exponential form.
Signal mode_velocity(const Arc<double>& arc, int j) {
  const ModeFlow<double>& mode = arc.flow().mode(j);
  const PlanarNumber<double>& a = arc.amplitude(j);
  Signal signal;
  if (mode.kind == ModeKind::kOscillatory) {
    const Complex rate(-mode.first, mode.second);
    signal.push_back({Complex(a.re, a.im) * rate, rate});
  } else {
    signal.push_back({Complex(-mode.first * a.re), Complex(-mode.first)});
    signal.push_back({Complex(-mode.second * a.im), Complex(-mode.second)});
  }
  if (arc.flow().forced()) {
    const Complex rate(0.0, arc.flow().frequency());
    signal.push_back(
        {Complex(mode.forced.re, mode.forced.im) * rate * std::polar(1.0, arc.start_phase()),
         rate});
  }
  return signal;
}

// After this, s, the free motion of a near-critical mode is below the rounding of its start.
double settling_time(const ModeFlow<double>& mode) {
  if (mode.kind != ModeKind::kNearCritical || mode.load != 0.0 || !(mode.delta > 0.0))
    return std::numeric_limits<double>::infinity();
  const double root = mode.discriminant < 0.0 ? std::sqrt(-mode.discriminant) : 0.0;
  // Below critical damping everything decays at delta, above it the slower of two rates leads. The
  // velocity of a free mass decays at 2 delta, whatever becomes of its displacement.
  const double slowest = mode.discriminant >= 0.0 ? mode.delta
                         : mode.omega > 0.0       ? mode.omega * mode.omega / (mode.delta + root)
                                                  : 2.0 * mode.delta;
  constexpr double kDecays = 48.0;  // e^-36 is eps; a linear factor of time comes with it
  return kDecays / slowest;
}

void add_real_modes(const ContactPhase<double>& phase, double s, Work& work) {
  const Arc<double>& arc = phase.arc();
  const ExactFlow<double>& flow = arc.flow();
  const double frequency = flow.frequency(), theta = arc.start_phase();
  const Signal force{{std::polar(1.0, theta), Complex(0.0, frequency)}};
  for (int j = 0; j < flow.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(j);
    if (mode.kind == ModeKind::kOscillatory || mode.kind == ModeKind::kOverdamped) {
      const Signal velocity = mode_velocity(arc, j);
      if (mode.delta > 0.0)
        work.dissipation += 2.0 * mode.delta * product_integral(velocity, velocity, s);
      if (flow.forced()) work.forcing += mode.force * product_integral(force, velocity, s);
      continue;
    }
    const double quickest = mode.omega + 2.0 * mode.delta + 2.0 * frequency;
    const auto velocity = [&](double at) { return arc.mode_velocity(j, at); };
    const double settled = std::fmin(s, settling_time(mode));
    if (mode.delta > 0.0)
      work.dissipation +=
          panel_integral([&](double at) { return 2.0 * mode.delta * velocity(at) * velocity(at); },
                         settled, quickest);
    if (flow.forced())
      work.forcing += panel_integral(
          [&](double at) { return mode.force * std::cos(theta + frequency * at) * velocity(at); },
          settled, quickest);
    if (!(settled < s) || !flow.forced()) continue;
    // From there on only the forced response moves.
    const Complex rate(0.0, frequency), turn = std::polar(1.0, theta + frequency * settled);
    const Signal left{{Complex(mode.forced.re, mode.forced.im) * rate * turn, rate}};
    work.dissipation += 2.0 * mode.delta * product_integral(left, left, s - settled);
    work.forcing += mode.force * product_integral({{turn, rate}}, left, s - settled);
  }
}

// While an oblique law or unequal damping couples the modes.
void add_coupled(const System& system, const ContactPhase<double>& phase, double s, Work& work) {
  const CoupledArc& arc = phase.coupled_arc();
  const Matrix& basis = phase.basis();
  const Vector damping = 2.0 * system.delta;
  Matrix pull = Matrix::Zero(system.modes(), static_cast<Eigen::Index>(phase.closed().size()));
  for (std::size_t i = 0; i < phase.closed().size(); ++i) {
    const RigidStop& stop = system.stops[static_cast<std::size_t>(phase.closed()[i])];
    // Acceleration by a contact force of 1 N.
    pull.col(static_cast<Eigen::Index>(i)) = -stop.direction * stop.row.squaredNorm();
  }
  const Matrix power_of_force = basis.transpose() * pull;
  if (!arc.has_terms()) {
    const double quickest = 2.0 * arc.quickest();
    Vector y(basis.cols()), ydot(basis.cols());
    const double theta = arc.start_phase();
    const auto at = [&](double t) {
      arc.state(t, y, ydot);
      return Vector(basis * ydot);
    };
    work.dissipation +=
        panel_integral([&](double t) { return damping.dot(at(t).cwiseAbs2()); }, s, quickest);
    if (system.forcing)
      work.forcing += panel_integral(
          [&](double t) {
            return std::cos(theta + system.forcing->frequency * t) *
                   system.forcing->amplitude.dot(at(t));
          },
          s, quickest);
    for (std::size_t i = 0; i < phase.closed().size(); ++i)
      work.constraint += panel_integral(
          [&](double t) {
            arc.state(t, y, ydot);
            const double angle = system.forcing ? theta + system.forcing->frequency * t : 0.0;
            return observed<double>(phase.observable(phase.closed()[i]), angle, y, ydot).value *
                   power_of_force.col(static_cast<Eigen::Index>(i)).dot(ydot);
          },
          s, quickest);
    return;
  }
  const auto velocity = [&](const Vector& weight) {
    return arc.terms({0.0, Vector::Zero(basis.cols()), weight, {}});
  };
  for (Eigen::Index j = 0; j < damping.size(); ++j) {
    const Signal signal = velocity(basis.row(j).transpose());
    work.dissipation += damping[j] * product_integral(signal, signal, s);
  }
  if (system.forcing) {
    const Signal force{
        {std::polar(1.0, arc.start_phase()), Complex(0.0, system.forcing->frequency)}};
    work.forcing +=
        product_integral(force, velocity(basis.transpose() * system.forcing->amplitude), s);
  }
  for (std::size_t i = 0; i < phase.closed().size(); ++i)
    work.constraint +=
        product_integral(arc.terms(phase.observable(phase.closed()[i])),
                         velocity(power_of_force.col(static_cast<Eigen::Index>(i))), s);
}

}  // namespace

Work work_along(const System& system, const ContactPhase<double>& phase, double s) {
  Work work;
  if (system.load) {
    const Eigen::Index n = system.modes();
    Vector q0(n), q1(n), qdot(n);
    phase.state(0.0, q0, qdot);
    phase.state(s, q1, qdot);
    work.load = system.load->dot(q1 - q0);
  }
  if (phase.has_real_modes())
    add_real_modes(phase, s, work);
  else
    add_coupled(system, phase, s, work);
  return work;
}

}  // namespace graze
