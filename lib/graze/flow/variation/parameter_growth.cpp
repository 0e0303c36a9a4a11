#include "graze/flow/variation/detail/parameter_growth.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/flow/variation/detail/transition.hpp"

namespace graze {
namespace {

struct ModeEnd {
  double q = 0.0, qdot = 0.0;  // derivatives of the end by the parameter
  double moved = 0.0;          // displacement from start to end
};

// Power series in the time t on the clock of the undisturbed motion, whose instants have the same
// phases: with the rate sigma = -W_p/W at which times stretch,
//
//   y' = z + sigma v,   z' = -w^2 y - 2 delta z + sigma a - (w^2)_p q - 2 delta_p v + (force)_p.
//
// Converges like 2^n/n! up to (2 delta + w + W) s = 2, without the cancellation of long arcs'
// closed forms.
ModeEnd end_by_series(double omega, double delta, double force, double load, double frequency,
                      double omega_rate, double delta_rate, double force_rate, double load_rate,
                      double frequency_rate, double q0, double v0, double theta, double s) {
  const double stretch = -frequency_rate / frequency;
  const double stiffness = omega * omega, stiffness_rate = 2.0 * omega * omega_rate;
  const double quarter[] = {std::cos(theta), -std::sin(theta), -std::cos(theta), std::sin(theta)};
  double q = q0, v = v0;    // n-th coefficients, times s^n
  double y = 0.0, z = 0.0;  // of the tangent
  double turn = 1.0;        // (W s)^n/n!
  // Terms fall at least like this; beyond eps^2 they change nothing of what the first ones leave.
  const double ratio = (2.0 * delta + omega + frequency) * s;
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  double size = 1.0;
  ModeEnd end;
  for (int n = 0; size > kEps * kEps; ++n) {
    const double wave = turn * quarter[n % 4], first = n == 0 ? 1.0 : 0.0;
    const double a = -stiffness * q - 2.0 * delta * v + force * wave + load * first;
    const double z_next = -stiffness * y - 2.0 * delta * z + stretch * a - stiffness_rate * q -
                          2.0 * delta_rate * v + force_rate * wave + load_rate * first;
    const double step = s / (n + 1);
    y = step * (z + stretch * v);
    z = step * z_next;
    q = step * v;
    v = step * a;
    end.q += y;
    end.qdot += z;
    end.moved += q;
    turn *= frequency * step;
    size *= ratio / (n + 1);
  }
  return end;
}

ParameterGrowth free_growth(const System& system, const System& tangent,
                            const ExactPhase<double>& phase, const State& start, double theta,
                            double s, const Deviations& column) {
  const Eigen::Index n = system.modes();
  ParameterGrowth growth{graze::growth(phase, s, column), Vector(n)};
  const double frequency = system.forcing()->frequency;
  // All modes at once by the closed forms of long arcs, where any of them needs these.
  std::optional<State> by_closed_form;
  std::optional<Vector> end;
  for (Eigen::Index j = 0; j < n; ++j) {
    if ((2.0 * system.delta()[j] + system.omega[j] + frequency) * s < 2.0) {
      const ModeEnd mode =
          end_by_series(system.omega[j], system.delta()[j], system.forcing()->amplitude[j],
                        system.load() ? (*system.load())[j] : 0.0, frequency, tangent.omega[j],
                        tangent.delta()[j], tangent.forcing()->amplitude[j],
                        tangent.load() ? (*tangent.load())[j] : 0.0, tangent.forcing()->frequency,
                        start.q[j], start.qdot[j], theta, s);
      growth.change.q(j, 0) += mode.q;
      growth.change.qdot(j, 0) += mode.qdot;
      growth.moved[j] = mode.moved;
      continue;
    }
    if (!by_closed_form) {
      by_closed_form = end_tangent(system, tangent, phase.arc()->flow(), start, theta, s);
      Vector q(n), qdot(n);
      phase.state(s, q, qdot);
      end = q;
    }
    growth.change.q(j, 0) += by_closed_form->q[j];
    growth.change.qdot(j, 0) += by_closed_form->qdot[j];
    growth.moved[j] = (*end)[j] - start.q[j];
  }
  return growth;
}

// The motion, held, with coupled modes or under several harmonics, in all N coordinates, q'' = P
// (load + f(theta) - D q' - w^2 q) with P = 1 - D (B^T D)^-1 B^T, as x' = A x on x = (rates * q,
// q', cos theta, sin theta, 1, and the cosine and sine of each further harmonic); and the
// derivative of A by the parameter. Constraints are integrals of it, so they are kept.
class ConstrainedGenerator {
 public:
  ConstrainedGenerator(const System& system, const System& tangent, const std::vector<int>& closed)
      : n_(system.modes()),
        rates_(system.omega.cwiseMax(system.forcing()->frequency)),
        orders_(orders_of(system)) {
    const Matrix projection = held_projection(system, closed);
    const Matrix projection_rate = held_projection_rate(system, tangent, closed);
    const Matrix forces = forces_of(system), forces_rate = forces_rate_of(system, tangent);
    generator_ = Matrix::Zero(size(), size());
    generator_.topRows(n_).middleCols(n_, n_) = rates_.asDiagonal();
    generator_.middleRows(n_, n_) = projection * forces;
    turn(system.forcing()->frequency, generator_);
    rate_ = Matrix::Zero(size(), size());
    rate_.middleRows(n_, n_) = projection_rate * forces + projection * forces_rate;
    turn(tangent.forcing()->frequency, rate_);
    stretch_ = -tangent.forcing()->frequency / system.forcing()->frequency;
    frequency_ = system.forcing()->frequency;
  }

  // Growth of a deviation, and of the state, over s seconds.
  ParameterGrowth growth(const State& start, double theta, double s,
                         const Deviations& column) const {
    const Eigen::Index m = size();
    Vector both = Vector::Zero(2 * m);
    both.segment(0, n_) = rates_.cwiseProduct(column.q.col(0));
    both.segment(n_, n_) = column.qdot.col(0);
    both.segment(m, n_) = rates_.cwiseProduct(start.q);
    both.segment(m + n_, n_) = start.qdot;
    both[m + 2 * n_ + 2] = 1.0;
    for (std::size_t k = 0; k < orders_.size(); ++k) {
      const double c = std::cos(orders_[k] * theta), n = std::sin(orders_[k] * theta);
      both.segment(m + place(k), 2) << c, n;
      both.segment(place(k), 2) << -n, c;
      both.segment(place(k), 2) *= orders_[k] * frequency_ * column.delay[0];
    }
    const Vector added = exponential_less_one(s, both);
    return {{added.segment(0, n_).cwiseQuotient(rates_), added.segment(n_, n_), column.delay},
            added.segment(m, n_).cwiseQuotient(rates_)};
  }

 private:
  static std::vector<double> orders_of(const System& system) {
    std::vector<double> orders{1.0};
    if (system.harmonics())
      for (const Harmonic& one : *system.harmonics()) orders.push_back(one.order);
    return orders;
  }
  Eigen::Index place(std::size_t k) const {
    return k == 0 ? 2 * n_ : 2 * n_ + 1 + 2 * static_cast<Eigen::Index>(k);
  }
  Eigen::Index size() const { return 2 * n_ + 1 + 2 * static_cast<Eigen::Index>(orders_.size()); }
  void turn(double frequency, Matrix& generator) const {
    for (std::size_t k = 0; k < orders_.size(); ++k) {
      generator(place(k), place(k) + 1) = -orders_[k] * frequency;
      generator(place(k) + 1, place(k)) = orders_[k] * frequency;
    }
  }
  void add_forcing(const HarmonicForcing& forcing, Matrix& forces) const {
    forces.col(place(0)) = forcing.amplitude;
    for (std::size_t k = 0; k < forcing.harmonics.size(); ++k) {
      forces.col(place(k + 1)) = forcing.harmonics[k].cosine;
      forces.col(place(k + 1) + 1) = forcing.harmonics[k].sine;
    }
  }

  // N x size()
  Matrix forces_of(const System& system) const {
    Matrix forces = Matrix::Zero(n_, size());
    forces.leftCols(n_) = (-system.omega.cwiseAbs2().cwiseQuotient(rates_)).asDiagonal();
    forces.middleCols(n_, n_) = -system.damping();
    add_forcing(*system.forcing(), forces);
    if (system.load()) forces.col(2 * n_ + 2) = *system.load();
    return forces;
  }

  Matrix forces_rate_of(const System& system, const System& tangent) const {
    Matrix forces = Matrix::Zero(n_, size());
    forces.leftCols(n_) =
        (-2.0 * system.omega.cwiseProduct(tangent.omega).cwiseQuotient(rates_)).asDiagonal();
    forces.middleCols(n_, n_) = -tangent.damping();
    add_forcing(*tangent.forcing(), forces);
    if (tangent.load()) forces.col(2 * n_ + 2) = *tangent.load();
    return forces;
  }

  // (exp([A s, A_p s + A s_p; 0, A s]) - 1) times the deviation above the state.
  Vector exponential_less_one(double s, const Vector& both) const {
    const Eigen::Index m = size();
    Matrix block = Matrix::Zero(2 * m, 2 * m);
    block.topLeftCorner(m, m) = block.bottomRightCorner(m, m) = generator_ * s;
    block.topRightCorner(m, m) = rate_ * s + generator_ * (stretch_ * s);
    if (generator_.norm() * s >= 1.0) return matrix_exponential(block) * both - both;
    // By its series, which keeps short flights accurate; 20! is beyond 1/eps.
    Vector term = both, sum = Vector::Zero(2 * m);
    for (int k = 1; k <= 20; ++k) {
      term = block * term / k;
      sum += term;
    }
    return sum;
  }

  Eigen::Index n_;
  Vector rates_;  // rad/s, N
  std::vector<double> orders_;
  Matrix generator_, rate_;
  double stretch_ = 0.0, frequency_ = 0.0;
};

}  // namespace

ParameterGrowth parameter_growth(const System& system, const System& tangent,
                                 const ExactPhase<double>& phase, const State& start, double theta,
                                 double s, const Deviations& column) {
  if (phase.closed().empty() && system.has_closed_forms() && !tangent.coupling())
    return free_growth(system, tangent, phase, start, theta, s, column);
  return ConstrainedGenerator(system, tangent, phase.closed()).growth(start, theta, s, column);
}

void hold(const System& system, const System& tangent, const std::vector<int>& closed,
          const State& state, Deviations& column) {
  if (closed.empty()) return;
  const Matrix rows = rows_of(system, closed), directions = directions_of(system, closed),
               rows_rate = rows_of(tangent, closed);
  Vector gaps(static_cast<Eigen::Index>(closed.size()));
  for (std::size_t a = 0; a < closed.size(); ++a)
    gaps[static_cast<Eigen::Index>(a)] = tangent.stops[static_cast<std::size_t>(closed[a])].gap;
  const Vector beyond = rows.transpose() * column.q.col(0) + rows_rate.transpose() * state.q - gaps;
  const Vector speed = rows.transpose() * column.qdot.col(0) + rows_rate.transpose() * state.qdot;
  column.q.col(0) -= rows * LuFactors(rows.transpose() * rows).solve(beyond);
  column.qdot.col(0) -= directions * LuFactors(rows.transpose() * directions).solve(speed);
}

}  // namespace graze
