#include "graze/orbit/problem/detail/shooting_curvature.hpp"

#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/orbit/problem/detail/impact_coordinates.hpp"

namespace graze {
namespace {

// Along a deviation of an impact's unknowns by (xi, dq, dq') and of the next impact's phase by eta,
// the end of the flight between them deviates by
//
//   Phi y + f1 eta/W,   y = (dq, dq' - J'(v) (b.dq') d) - f0 xi/W,
//
// with f0 and f1 the vector field at both ends, J(v) the velocity jump, W the forcing frequency.
// Paired with omega from the left this is what is differentiated here: Phi by its duration and its
// coefficients, f1 with the end that it is taken at, y with the start.
template <class Scalar>
class Curvature {
 public:
  using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  Curvature(const ShootingProblem& problem, const System& system, const Vector& x,
            std::span<const System* const> tangents, const Column& w, const Column& v, Scalar mu)
      : problem_(problem),
        scale_(problem.scale()),
        system_(system),
        flow_(system),
        frequency_(system.forcing()->frequency),
        tangents_(tangents),
        x_(x),
        w_(w),
        v_(v),
        mu_(mu),
        gradient_(Column::Zero(x.size() + static_cast<Eigen::Index>(tangents.size()))) {}

  Column gradient() {
    for (int i = 0; i < problem_.pattern().impacts(); ++i) add_flight(i);
    return std::move(gradient_);
  }

 private:
  using Pair = Eigen::Matrix<Scalar, 2, 1>;

  struct Flight {
    Eigen::Index at = 0, to = 0;  // where the unknowns of both impacts begin
    std::size_t which = 0;        // the stop it leaves
    double theta = 0.0, theta_end = 0.0;
    double speed = 0.0, jump = 0.0;        // v and J(v) of the impact
    double slope = 0.0, slope_bend = 0.0;  // J', J''
    Scalar xi = 0.0, eta = 0.0;            // over W, s
    Scalar moved = 0.0;                    // b.dq'
  };

  // The terms of one mode along a flight.
  struct Mode {
    double omega2 = 0.0, delta = 0.0, force = 0.0;
    Eigen::Vector2d start, f0, end, f1;
    ModeTransition arc;
    Pair omega, along;    // omega; A^T omega, A the matrix of the mode's field
    Pair lambda, lagged;  // Phi^T omega; A^T of that
    Pair rho;             // Phi^T A^T omega
    Pair y;
  };

  const Stop& stop(const System& system, const Flight& flight) const {
    return system.stops[flight.which];
  }

  static Pair field_transposed(const Mode& mode, const Pair& of) {
    return Pair(-mode.omega2 * of[1], of[0] - 2.0 * mode.delta * of[1]);
  }
  static Pair flow_transposed(const Mode& mode, const Pair& of) {
    return Pair(mode.arc.qq * of[0] + mode.arc.vq * of[1],
                mode.arc.qv * of[0] + mode.arc.vv * of[1]);
  }

  Flight flight(int i) const {
    const ImpactPattern& pattern = problem_.pattern();
    const Eigen::Index n = system_.modes(), block = 2 * n + 1;
    const bool last = i + 1 == pattern.impacts();
    Flight flight;
    flight.at = i * block;
    flight.to = last ? 0 : flight.at + block;
    flight.which = static_cast<std::size_t>(pattern.stops[static_cast<std::size_t>(i)]);
    flight.theta = x_[flight.at];
    flight.theta_end = x_[flight.to] + (last ? kTurn * pattern.period : 0.0);
    flight.xi = v_[flight.at] / frequency_;
    flight.eta = (last ? mu_ : Scalar(1.0)) * v_[flight.to] / frequency_;
    const Stop& left = stop(system_, flight);
    for (Eigen::Index j = 0; j < n; ++j) {
      flight.speed += left.row[j] * x_[flight.at + 1 + n + j] * scale_.velocity[j];
      flight.moved += left.row[j] * v_[flight.at + 1 + n + j] * scale_.velocity[j];
    }
    flight.jump = left.restitution().jump(flight.speed);
    flight.slope = left.restitution().jump_slope(flight.speed);
    flight.slope_bend = left.restitution().jump_bend(flight.speed);
    return flight;
  }

  Mode mode(const Flight& flight, const ModalTransitions& arcs, Eigen::Index j) const {
    const Eigen::Index n = system_.modes(), q = flight.at + 1 + j, qdot = q + n;
    const double unit = scale_.displacement, unit_v = scale_.velocity[j];
    const double direction = stop(system_, flight).direction()[j];
    Mode mode;
    mode.omega2 = system_.omega[j] * system_.omega[j];
    mode.delta = system_.delta()[j];
    mode.force = system_.forcing()->amplitude[j];
    mode.start << x_[q] * unit, x_[qdot] * unit_v - flight.jump * direction;
    mode.arc = arcs.from(j, mode.start[0], mode.start[1]);
    const double load = system_.load() ? (*system_.load())[j] : 0.0;
    mode.f0 << mode.start[1], -mode.omega2 * mode.start[0] - 2.0 * mode.delta * mode.start[1] +
                                  mode.force * std::cos(flight.theta) + load;
    mode.end << mode.arc.q, mode.arc.qdot;
    mode.f1 << mode.arc.qdot, mode.arc.acceleration;
    mode.omega = Pair(w_[q] / unit, w_[qdot] / unit_v);
    mode.along = field_transposed(mode, mode.omega);
    mode.lambda = flow_transposed(mode, mode.omega);
    mode.lagged = field_transposed(mode, mode.lambda);
    mode.rho = flow_transposed(mode, mode.along);
    mode.y = Pair(v_[q] * unit, v_[qdot] * unit_v - flight.slope * flight.moved * direction) -
             mode.f0 * flight.xi;
    return mode;
  }

  void add_flight(int i) {
    const Flight flight = this->flight(i);
    const Eigen::Index n = system_.modes(), at = flight.at;
    const Stop& left = stop(system_, flight);
    const double s = (flight.theta_end - flight.theta) / frequency_;
    const ModalTransitions arcs(system_, flow_, flight.theta, s);
    Scalar along_jump = 0.0, along_bend = 0.0;
    for (Eigen::Index j = 0; j < n; ++j) {
      const Mode mode = this->mode(flight, arcs, j);
      // Time derivative of the pairing: A and Phi commute.
      const Scalar drift = dot(mode.rho, mode.y) / frequency_;
      const double turn = -mode.force * std::sin(flight.theta);
      const double turn_end = -mode.force * std::sin(flight.theta_end);
      gradient_[at] -= drift + flight.xi * mode.lambda[1] * turn +
                       flight.eta * dot(mode.rho, mode.f0) / frequency_;
      gradient_[flight.to] +=
          drift + flight.eta * (dot(mode.along, mode.f1) / frequency_ + mode.omega[1] * turn_end);
      const Pair by_start = flight.eta * mode.rho - flight.xi * mode.lagged;
      gradient_[at + 1 + j] += by_start[0] * scale_.displacement;
      gradient_[at + 1 + n + j] += by_start[1] * scale_.velocity[j];
      along_jump += left.direction()[j] * by_start[1];
      along_bend += left.direction()[j] * mode.lambda[1];
      for (std::size_t p = 0; p < tangents_.size(); ++p)
        gradient_[x_.size() + static_cast<Eigen::Index>(p)] +=
            by_parameter(flight, mode, arcs, j, *tangents_[p]);
    }
    const Scalar by_speed =
        flight.slope * along_jump + flight.slope_bend * flight.moved * along_bend;
    for (Eigen::Index j = 0; j < n; ++j)
      gradient_[at + 1 + n + j] -= by_speed * left.row[j] * scale_.velocity[j];
  }

  // A mode's part of the derivative by a parameter.
  Scalar by_parameter(const Flight& flight, const Mode& mode, const ModalTransitions& arcs,
                      Eigen::Index j, const System& tangent) const {
    const Eigen::Index n = system_.modes();
    const Stop &left = stop(system_, flight), &rate = stop(tangent, flight);
    double speed_rate = 0.0;
    Scalar moved_rate = 0.0;  // of b.dq'
    for (Eigen::Index m = 0; m < n; ++m) {
      speed_rate += rate.row[m] * x_[flight.at + 1 + n + m] * scale_.velocity[m];
      moved_rate += rate.row[m] * v_[flight.at + 1 + n + m] * scale_.velocity[m];
    }
    const Restitution& r = left.restitution();
    const double jump_rate =
        r.jump_rate(flight.speed, rate.restitution()) + flight.slope * speed_rate;
    const double slope_rate =
        r.jump_slope_rate(flight.speed, rate.restitution()) + flight.slope_bend * speed_rate;
    const double start_rate = -jump_rate * left.direction()[j] - flight.jump * rate.direction()[j];
    const Scalar y_rate =
        -(slope_rate * flight.moved + flight.slope * moved_rate) * left.direction()[j] -
        flight.slope * flight.moved * rate.direction()[j];
    const double stiffness_rate = 2.0 * system_.omega[j] * tangent.omega[j];
    const auto field_rate = [&](const Eigen::Vector2d& state, double theta) {
      return -stiffness_rate * state[0] - 2.0 * tangent.delta()[j] * state[1] +
             tangent.forcing()->amplitude[j] * std::cos(theta) +
             (tangent.load() ? (*tangent.load())[j] : 0.0);
    };
    // Phases are fixed angles, times are angles over a frequency that changes.
    const double stretch = tangent.forcing()->frequency / frequency_;
    const Eigen::Vector2d end_rate =
        arcs.tangent(j, mode.start[0], mode.start[1], mode.arc, tangent) +
        Eigen::Vector2d(mode.arc.qv, mode.arc.vv) * start_rate;
    const Pair flown = arcs.flow_tangent(j, mode.arc, tangent) * mode.y;
    return dot(mode.omega, flown) + mode.lambda[1] * y_rate -
           flight.xi * (mode.lagged[1] * start_rate +
                        mode.lambda[1] * field_rate(mode.start, flight.theta) -
                        stretch * dot(mode.lambda, mode.f0)) +
           flight.eta *
               (dot(mode.along, end_rate) + mode.omega[1] * field_rate(mode.end, flight.theta_end) -
                stretch * dot(mode.omega, mode.f1)) +
           // The contact, row.q = gap.
           w_[flight.at] * rate.row[j] * v_[flight.at + 1 + j] *
               (scale_.displacement / scale_.length);
  }

  // Without conjugation.
  template <class Other>
  static Scalar dot(const Pair& a, const Other& b) {
    return a[0] * b[0] + a[1] * b[1];
  }

  const ShootingProblem& problem_;
  const MotionScale& scale_;
  const System& system_;
  ExactFlow<double> flow_;
  double frequency_;
  std::span<const System* const> tangents_;
  const Vector& x_;
  const Column &w_, &v_;
  Scalar mu_;
  Column gradient_;
};

template <class Column>
Column curvature(const ShootingProblem& problem, const System& system, const Vector& x,
                 std::span<const System* const> tangents, const Column& w, const Column& v,
                 typename Column::Scalar mu) {
  using Modal = Curvature<typename Column::Scalar>;
  if (!system.coordinates()) return Modal(problem, system, x, tangents, w, v, mu).gradient();
  // w^T T A T^-1 v, A the matrix of the modal equations.
  const ImpactCoordinates coordinates(*system.coordinates(), problem.scale());
  const Vector y = coordinates.back(x);
  const Column left = coordinates.turned_covector(w), right = coordinates.back(v);
  Column gradient = Modal(problem, system, y, tangents, left, right, mu).gradient();
  const Column by_y = gradient.head(x.size());
  const ShootingLinearisation at = problem.modal_equations(system, y, {});
  const auto image = [&](const Column& of) -> Column {
    return at.jacobian * of + (mu - 1.0) * (at.closing * of);
  };
  gradient.head(x.size()) = coordinates.back_covector(by_y);
  const auto dot = [](const auto& a, const auto& b) { return a.cwiseProduct(b).sum(); };
  for (std::size_t p = 0; p < tangents.size(); ++p) {
    const System& tangent = *tangents[p];
    const Vector moved = coordinates.back(coordinates.rate(tangent, y));
    const Column turned = coordinates.back(coordinates.rate(tangent, right));
    gradient[x.size() + static_cast<Eigen::Index>(p)] +=
        dot(w, coordinates.rate(tangent, image(right))) - dot(left, image(turned)) -
        dot(by_y, moved);
  }
  return gradient;
}

}  // namespace

Vector shooting_curvature(const ShootingProblem& problem, const System& system, const Vector& x,
                          std::span<const System* const> tangents, const Vector& w, const Vector& v,
                          double mu) {
  return curvature(problem, system, x, tangents, w, v, mu);
}

ComplexVector shooting_curvature(const ShootingProblem& problem, const System& system,
                                 const Vector& x, std::span<const System* const> tangents,
                                 const ComplexVector& w, const ComplexVector& v, Complex mu) {
  return curvature(problem, system, x, tangents, w, v, mu);
}

}  // namespace graze
