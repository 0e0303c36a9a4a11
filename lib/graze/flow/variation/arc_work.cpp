#include "graze/flow/variation/arc_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/flow/exact/detail/term_kernels.hpp"
#include "graze/flow/held/detail/exact_phase.hpp"
#include "graze/flow/held/detail/series_phase.hpp"
#include "graze/flow/sprung/detail/spring_arc.hpp"
#include "graze/flow/variation/detail/arc_integrals.hpp"
#include "graze/flow/variation/detail/carried_work.hpp"
#include "graze/flow/variation/detail/signal.hpp"

namespace graze {
namespace {

// The harmonic velocity response of a mode, from the forcing phase theta on.
SignalTerm harmonic_velocity(const ModeFlow<double>& mode, double frequency, double theta) {
  const Complex rate(0.0, frequency);
  const Complex impedance((mode.omega - frequency) * (mode.omega + frequency),
                          2.0 * mode.delta * frequency);
  return {mode.force / impedance * rate * std::polar(1.0, theta), rate};
}

// Whether two exponentials and the harmonic response give the velocity over s without cancellation:
// the exponentials are distinct (as in exact_flow_impl.hpp), and above critical damping each is
// then at most the force over the damping; below, the response must not be large against that from
// rest, which is about the force over w^2 + 2 delta/s + 2/s^2.
bool is_exponential(const ModeFlow<double>& mode, double frequency, bool forced, double s) {
  const double apart = 2.0 * std::sqrt(std::abs(mode.discriminant));
  if (!(apart * s >= 1.0 && apart >= mode.omega)) return false;
  if (!forced || mode.discriminant < 0.0) return true;
  const double impedance =
      std::hypot((mode.omega - frequency) * (mode.omega + frequency), 2.0 * mode.delta * frequency);
  return kLargestAmplification * impedance >=
         mode.omega * mode.omega + 2.0 * (mode.delta + 1.0 / s) / s;
}

// The velocity of such a mode: v(s) = (c - delta S) v(0) + S push, see free_basis.hpp.
Signal mode_velocity(const Arc<double>& arc, int j) {
  const ModeFlow<double>& mode = arc.flow().mode(j);
  double push = mode.load + mode.omega * mode.omega * (mode.offset - arc.start_displacements()[j]);
  double start = arc.start_velocities()[j];
  Signal signal;
  if (arc.flow().forced() && mode.force != 0.0) {
    const SignalTerm forced = harmonic_velocity(mode, arc.flow().frequency(), arc.start_phase());
    signal.push_back(forced);
    start -= forced.size.real();
    push += mode.omega * mode.omega * (forced.size / forced.rate).real();
  }
  const double root = std::sqrt(std::abs(mode.discriminant));
  if (mode.discriminant > 0.0) {
    signal.push_back(
        {Complex(start, (mode.delta * start - push) / root), Complex(-mode.delta, root)});
  } else {
    const double fast = mode.delta + root, slow = mode.omega * mode.omega / fast;
    signal.push_back({Complex((push - slow * start) / (2.0 * root)), Complex(-slow)});
    signal.push_back({Complex((fast * start - push) / (2.0 * root)), Complex(-fast)});
  }
  return signal;
}

// Time, s, after which the free motion of a mode near critical damping (root < w/2, and so delta >
// .8 w) is below the rounding of its start. Not used for other modes.
double settling_time(const ModeFlow<double>& mode) {
  const double root = std::sqrt(std::abs(mode.discriminant));
  if (!(2.0 * root < mode.omega)) return std::numeric_limits<double>::infinity();
  // Below critical damping everything decays at delta, above it the slower of two rates leads.
  const double slowest =
      mode.discriminant >= 0.0 ? mode.delta : mode.omega * mode.omega / (mode.delta + root);
  constexpr double kDecays = 48.0;  // e^-36 is eps; a linear factor of time comes with it
  return kDecays / slowest;
}

// Dissipation and work of the forcing on one mode where exponentials would cancel. A flight lasts a
// forcing period at most, W s <= 2 pi, so the panels are few in each case that is left:
//   - the exponentials are not distinct, 2 root s < 1, 2 root >= w: (w + 2 delta) s < 4;
//   - near critical damping, up to the settling time: (w + 2 delta) s < 300;
//   - near resonance, or where the harmonic response is large against a short flight: w s < 8,
//     delta < w.
void add_by_panels(const Arc<double>& arc, int j, double s, Work& work) {
  const ModeFlow<double>& mode = arc.flow().mode(j);
  const double frequency = arc.flow().frequency(), theta = arc.start_phase();
  const double quickest = mode.omega + 2.0 * mode.delta + 2.0 * frequency;
  const auto velocity = [&](double at) { return arc.mode_velocity(j, at); };
  const double settled = std::fmin(s, settling_time(mode));
  if (mode.delta > 0.0)
    work.dissipation +=
        panel_integral([&](double at) { return 2.0 * mode.delta * velocity(at) * velocity(at); },
                       settled, quickest);
  if (!arc.flow().forced()) return;
  work.forcing += panel_integral(
      [&](double at) { return mode.force * std::cos(theta + frequency * at) * velocity(at); },
      settled, quickest);
  if (!(settled < s)) return;
  // From there on only the forced response moves.
  const double turned = theta + frequency * settled;
  const Signal left{harmonic_velocity(mode, frequency, turned)};
  const Signal force{{std::polar(1.0, turned), Complex(0.0, frequency)}};
  work.dissipation += 2.0 * mode.delta * square_integral(left, s - settled);
  work.forcing += mode.force * product_integral(force, left, s - settled);
}

// Dissipation of many unforced modes. Each velocity is Re(c e^{l s}), and
//
//   2 delta v^2 = delta (|c|^2 e^{-2 delta s} + Re(c^2 e^{2 l s})),
//
// whose integrals cancel at most within the rounding of the mode's own energy. Returns false, with
// nothing added, where a mode has another form.
bool add_free_modes(const Arc<double>& arc, double s, Work& work) {
  const ExactFlow<double>& flow = arc.flow();
  const auto free = [&](int j) { return flow.mode(j).kind == ModeKind::kOscillatory; };
  for (int j = 0; j < flow.modes(); ++j)
    if (!free(j)) return false;
  const ExactFlow<double>::Turns& turns = flow.turns();
  std::vector<double> re(turns.decay.size()), im(re.size());  // e^{l s} - 1
  turn_terms(turns.decay.data(), turns.half_frequency.data(), re.size(), turns.quickest, s,
             re.data(), im.data());
  double dissipation = 0.0;
  for (int j = 0; j < flow.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(j);
    if (mode.delta == 0.0) continue;
    const PlanarNumber<double>& a = arc.amplitude(j);
    const double x = re[static_cast<std::size_t>(j) + 1], y = im[static_cast<std::size_t>(j) + 1];
    // c = l a.
    const double cr = -mode.first * a.re - mode.second * a.im;
    const double ci = mode.second * a.re - mode.first * a.im;
    // e^{-2 delta s} - 1 and e^{2 l s} - 1 from the same numbers.
    const double lost = 2.0 * x + x * x + y * y;
    const double ur = 2.0 * x + x * x - y * y, ui = 2.0 * y * (1.0 + x);
    // Re(c^2 (e^{2 l s} - 1)/(2 l))
    const double sr = cr * cr - ci * ci, si = 2.0 * cr * ci;
    const double tr = sr * ur - si * ui, ti = sr * ui + si * ur;
    const double square = mode.first * mode.first + mode.second * mode.second;
    dissipation += -0.5 * (cr * cr + ci * ci) * lost +
                   0.5 * mode.delta * (-mode.first * tr + mode.second * ti) / square;
  }
  work.dissipation += dissipation;
  return true;
}

void add_real_modes(const Arc<double>& arc, double s, Work& work) {
  const ExactFlow<double>& flow = arc.flow();
  if (!flow.forced() && flow.modes() > kFewModes && add_free_modes(arc, s, work)) return;
  const Signal force{{std::polar(1.0, arc.start_phase()), Complex(0.0, flow.frequency())}};
  for (int j = 0; j < flow.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(j);
    if (!is_exponential(mode, flow.frequency(), flow.forced(), s)) {
      add_by_panels(arc, j, s, work);
      continue;
    }
    const Signal velocity = mode_velocity(arc, j);
    if (mode.delta > 0.0) work.dissipation += 2.0 * mode.delta * square_integral(velocity, s);
    if (flow.forced()) work.forcing += mode.force * product_integral(force, velocity, s);
  }
}

// Whether the force of a stop has no part along the motion b.q' = 0 that it allows: d = b/(b.b), to
// the roundings of forming it.
bool acts_along_row(const Stop& stop) {
  constexpr double kRoundings = 16.0;
  return (stop.direction() * stop.row.squaredNorm() - stop.row).norm() <=
         kRoundings * std::numeric_limits<double>::epsilon() * stop.row.norm();
}

// Adds the work of linear springs and their dashpots.
void add_linear_springs(const ExactPhase<double>& phase, double s, Work& work) {
  const SpringArc& springs = *phase.sprung();
  for (std::size_t k = 0; k < springs.springs().loaded.size(); ++k) {
    const ContactForce& law = springs.equations.springs[k].law;
    const Observable<double>& depth = springs.depth_observables[k];
    work.contact -=
        law.stored(phase.curve(depth, s).at(s, 0).value) - law.stored(springs.depths[k]);
    if (law.damping == ContactDamping::kNone) continue;
    const Observable<double> rate{
        0.0, Vector::Zero(depth.displacement.size()), depth.displacement, {}};
    const double lost = law.coefficient * square_along(phase, rate, s);
    work.contact -= lost;
    work.contact_lost += lost;
  }
}

// Adds the works while an oblique law or unequal damping couples the modes.
void add_coupled(const System& system, const ExactPhase<double>& phase, double s, Work& work) {
  const CoupledArc& arc = *phase.coupled_arc();
  if (phase.sprung()) add_linear_springs(phase, s, work);
  if (system.carried()) return add_carried_work(system, phase, s, work);
  // Without these no other work is done.
  if (system.delta().isZero(0.0) && !system.forcing() && phase.closed().empty()) return;
  const Moments moments = moments_along(arc, s);
  const ConstrainedStructure<double>& structure = phase.structure();
  const Matrix basis =
      structure.is_free() ? Matrix::Identity(system.modes(), system.modes()) : structure.basis;
  const Eigen::Index m = basis.cols();
  // Moments of the modal velocities with z, N x (2m + 3).
  const Matrix velocity = basis * moments.integral.middleRows(m, m);
  const Vector squares = velocity.middleCols(m, m).cwiseProduct(basis).rowwise().sum();
  work.dissipation += 2.0 * system.delta().dot(squares);
  if (system.coupling())
    work.dissipation +=
        system.coupling()->cwiseProduct(velocity.middleCols(m, m) * basis.transpose()).sum();
  if (system.forcing())
    work.forcing += system.forcing()->amplitude.dot(velocity.col(2 * m)) / moments.unit;
  for (std::size_t k = 0; k < structure.units.size(); ++k) {
    const Harmonic& one = (*system.harmonics())[k];
    const Eigen::Index at = structure.drive(k);
    // Displacements count from the arc's origin.
    work.forcing += (one.cosine.dot(velocity.col(at)) / arc.flow().scale()[at] +
                     one.cosine.dot(velocity.col(2 * m + 2)) * arc.origin()[at] / moments.unit -
                     one.sine.dot(velocity.col(m + at)) * structure.units[k] /
                         structure.rate_unit(k)) /
                    structure.units[k];
  }
  for (const int i : phase.closed()) {
    if (system.is_friction(i)) continue;
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    if (acts_along_row(stop)) continue;
    const Vector weight =
        weights_of(phase.observables()[static_cast<std::size_t>(i)], arc, moments);
    // A contact force of 1 N accelerates by -direction |row|^2.
    work.constraint -= stop.row.squaredNorm() * stop.direction().dot(velocity * weight);
  }
}

// What the constant load does along the way by which stops that move carry the structure.
double carried_load(const System& system, double theta, double s) {
  if (!system.carried()) return 0.0;
  const double later = theta + system.forcing()->frequency * s;
  Vector way = Vector::Zero(system.modes());
  for (const Harmonic& one : *system.carried()) way += one.at(later) - one.at(theta);
  return system.load()->dot(way);
}

Work work_on_springs(const System& system, const ContactPhase<double>& phase, double s,
                     double theta) {
  const SprungWorks works = phase.stepped()->works(s);
  Work work;
  if (system.load())
    work.load = system.load()->dot(phase.sprung()->structure.velocities(works.moved)) +
                carried_load(system, theta, s);
  if (system.turns()) work.load = works.weight;
  work.forcing = works.forcing;
  (system.carried() ? work.stops : work.constraint) = works.constraint;
  work.dissipation = works.dissipation;
  for (const SpringWork& spring : works.springs) {
    work.contact -= spring.lost + spring.stored;
    work.contact_lost += spring.lost;
  }
  return work;
}

// What friction at a spring takes: the integral of its force times the speed of sliding, by the
// squares of their sum and difference.
double work_at_spring(const System& system, const ContactPhase<double>& phase, std::size_t k,
                      double s) {
  const Friction& friction = system.frictions[k];
  const std::vector<int>& loaded = phase.springs().loaded;
  const auto place = static_cast<std::size_t>(
      std::find(loaded.begin(), loaded.end(), friction.stop) - loaded.begin());
  const SpringArc& springs = *phase.sprung();
  const ExactPhase<double>& exact = *phase.exact();
  const Observable<double> force =
      times(friction.sliding,
            linear_force(springs.equations.springs[place].law, springs.depth_observables[place]));
  // Of the structure, not along the belt.
  Observable<double> speed = exact.observables()[system.stops.size() + k];
  speed.constant +=
      phase.key().frictions[k] == Contact::kForward ? friction.speed : -friction.speed;
  return 0.25 * (square_along(exact, force + speed, s) -
                 square_along(exact, force + times(-1.0, speed), s));
}

// What slides does work with its whole force along the way; what sticks to a belt is moved by it.
double work_of_friction(const System& system, const ContactPhase<double>& phase, double s,
                        const Vector& way) {
  double work = 0.0;
  for (std::size_t k = 0; k < system.frictions.size(); ++k) {
    const Friction& friction = system.frictions[k];
    const int index = static_cast<int>(system.stops.size() + k);
    const Contact contact = phase.key().frictions[k];
    const bool slides = contact == Contact::kForward || contact == Contact::kBackward;
    if (slides && friction.stop >= 0)
      work -= work_at_spring(system, phase, k, s);
    else if (slides)
      work +=
          (contact == Contact::kForward ? -1.0 : 1.0) * friction.sliding * friction.row.dot(way);
    else if (contact == Contact::kClosed && friction.speed != 0.0 &&
             phase.exact()->structure().holds(index))
      work -= friction.speed *
              integrals_along(*phase.exact(),
                              phase.exact()->observables()[static_cast<std::size_t>(index)], s)
                  .value;
  }
  return work;
}

}  // namespace

Work work_along(const System& system, const ContactPhase<double>& phase, double s, double theta) {
  if (phase.sprung() && phase.stepped()) return work_on_springs(system, phase, s, theta);
  Work work;
  if (system.load() || !system.frictions.empty()) {
    const Eigen::Index n = system.modes();
    Vector q0(n), q1(n), qdot(n);
    phase.state(0.0, q0, qdot);
    phase.state(s, q1, qdot);
    if (system.load()) work.load = system.load()->dot(q1 - q0) + carried_load(system, theta, s);
    work.friction = work_of_friction(system, phase, s, q1 - q0);
  }
  if (const SeriesPhase* series = phase.series()) {
    const SeriesWork done = series->work(s);
    work.dissipation = done.dissipation;
    work.forcing = done.forcing;
    return work;
  }
  if (const Arc<double>* arc = phase.exact()->arc())
    add_real_modes(*arc, s, work);
  else
    add_coupled(system, *phase.exact(), s, work);
  return work;
}

}  // namespace graze
