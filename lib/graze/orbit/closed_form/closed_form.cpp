#include "graze/orbit/closed_form/closed_form.hpp"

#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/closed_form/detail/periodic_response.hpp"

namespace graze {
namespace {

// The equations for the state before the impact, with velocities in units of each mode's own
// frequency: the flow then only rotates and shrinks.
struct RepeatedArc {
  Matrix matrix;  // I - E J
  Vector kick;    // E (0; d) W
  Vector row;     // of the displacements
  Vector unit;    // of y-
};

// End of an arc from rest, (q; q'): R(phi) = cosine cos(phi) - sine sin(phi), and r_0.
struct FromRest {
  Vector cosine, sine, load;
};

State state_of(const Vector& y) {
  const Eigen::Index n = y.size() / 2;
  return {y.head(n), y.segment(n, n)};
}

// Speeds from the equations of motion; the contact equation is left to be solved.
ClosedForm from_motion(const RepeatedArc& arc, const LuFactors& lu, const FromRest& by) {
  const auto response = [&](const Vector& forced) {
    return Vector(lu.solve(forced.cwiseQuotient(arc.unit)).cwiseProduct(arc.unit));
  };
  const Eigen::Index n = arc.row.size();
  ClosedForm form;
  form.response = ComplexVector(2 * n);
  form.response.real() = response(by.cosine);
  form.response.imag() = response(by.sine);
  form.rest = state_of(response(by.load));
  form.per_gap = state_of(Vector::Zero(2 * n));
  form.kappa = arc.row.cast<Complex>().dot(form.response.head(n));
  form.moved = arc.row.dot(form.rest.q);
  return form;
}

// Contact and the equations of motion with a free impulse; the law of impact is left to be solved.
std::optional<ClosedForm> from_contact(const RepeatedArc& arc, const FromRest& by, double least) {
  const Eigen::Index n = arc.row.size();
  Matrix bordered = Matrix::Zero(2 * n + 1, 2 * n + 1);
  bordered.topLeftCorner(2 * n, 2 * n) = arc.matrix;
  const double size = arc.row.norm();
  bordered.col(2 * n).head(2 * n) = arc.kick * size;
  bordered.row(2 * n).head(n) = arc.row.transpose() / size;
  const LuFactors lu(bordered);
  if (!(lu.reciprocal_condition() > least)) return {};
  const auto response = [&](const Vector& forced, double gap) {
    Vector right(2 * n + 1);
    right << forced.cwiseQuotient(arc.unit), gap / size;
    Vector y = lu.solve(right);
    y.head(2 * n) = y.head(2 * n).cwiseProduct(arc.unit);
    return y;  // also the impulse, whose value is not used: it must vanish
  };
  const Vector cosine = response(by.cosine, 0.0), sine = response(by.sine, 0.0);
  const Vector load = response(by.load, 0.0), gap = response(Vector::Zero(2 * n), 1.0);
  ClosedForm form;
  form.response = ComplexVector(2 * n);
  form.response.real() = cosine.head(2 * n);
  form.response.imag() = sine.head(2 * n);
  form.rest = state_of(load);
  form.per_gap = state_of(gap);
  form.kappa = -Complex(cosine[2 * n], sine[2 * n]);
  form.moved = -load[2 * n];
  form.by_gap = gap[2 * n];
  return form;
}

}  // namespace

std::vector<ImpactPoint> ClosedForm::solutions(double full_gap) const {
  const double gap = by_gap * full_gap - moved;
  const double size = std::abs(kappa);
  if (!(size >= std::abs(gap)) || size == 0.0) return {};
  // acos loses half its digits where gap -> |kappa|; the sine is formed from the product instead.
  const double half = std::atan2(std::sqrt((size - gap) * (size + gap)), gap);
  std::vector<ImpactPoint> points;
  for (const double sign : {-1.0, 1.0}) {
    const double phase = wrapped(sign * half - std::arg(kappa));
    const State y = state_of((response * std::polar(1.0, phase)).real());
    points.push_back(
        {phase,
         {rest.q + y.q + full_gap * per_gap.q, rest.qdot + y.qdot + full_gap * per_gap.qdot}});
  }
  return points;
}

ClosedFormAnswer closed_form(const System& system, int stop_index, int period) {
  if (!system.forcing()) return {{}, "there is no forcing"};
  if (system.harmonics()) return {{}, kHarmonics};
  if (system.coupling()) return {{}, kCoupledModes};
  if (!system.stops[static_cast<std::size_t>(stop_index)].restitution().is_constant())
    return {{}, "the restitution depends on the speed"};
  const Eigen::Index n = system.modes();
  const ExactFlow<double> flow(system);
  const Stop& stop = system.stops[static_cast<std::size_t>(stop_index)];
  const State rest{Vector::Zero(n), Vector::Zero(n)};
  const Transition motion = transition(system, flow, rest, 0.0, period * system.period());
  Matrix jump = Matrix::Identity(2 * n, 2 * n);
  jump.bottomRightCorner(n, n) -=
      (1.0 + stop.restitution().at_rest()) * stop.direction() * stop.row.transpose();
  RepeatedArc arc{{}, {}, stop.row, Vector::Ones(2 * n)};
  arc.unit.tail(n) = system.omega.cwiseMax(flow.frequency());
  const auto in_units = [&arc](const Matrix& m) {
    return Matrix(arc.unit.cwiseInverse().asDiagonal() * m);
  };
  arc.matrix =
      Matrix::Identity(2 * n, 2 * n) - in_units(motion.flow.times(jump)) * arc.unit.asDiagonal();
  Vector kick = Vector::Zero(2 * n);
  kick.tail(n) = flow.frequency() * stop.direction();
  arc.kick = in_units(motion.flow.times(kick));

  const State loaded = load_response(system, flow, period * system.period());
  FromRest by{Vector(2 * n), Vector(2 * n), Vector(2 * n)};
  by.load << loaded.q, loaded.qdot;
  by.cosine << motion.end.q, motion.end.qdot;
  by.cosine -= by.load;
  by.sine << -motion.phase_rate.q, -motion.phase_rate.qdot;

  // The solution has an error of eps over the reciprocal condition number: below this it keeps less
  // than half of its digits, and the other way may be better; below eps it keeps none.
  constexpr double kNone = std::numeric_limits<double>::epsilon();
  const double half = std::sqrt(kNone);
  const LuFactors lu(arc.matrix);
  const double regular = lu.reciprocal_condition();
  if (!(regular > half))
    if (const auto form = from_contact(arc, by, half)) return {*form, ""};
  if (!(regular > kNone))
    return {{}, "the motion between impacts repeats by itself (I - E J is singular)"};
  return {from_motion(arc, lu, by), ""};
}

}  // namespace graze
