#include "graze/flow/variation/detail/parameter_growth.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/flow/sprung/detail/spring_arc.hpp"
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
// q', cos theta, sin theta, 1, and the cosine and sine of each further harmonic). Constraints are
// integrals of it, so they are kept.
class HeldGenerator {
 public:
  HeldGenerator(const System& system, const PhaseKey& key)
      : n_(system.modes()),
        frequency_(system.forcing() ? system.forcing()->frequency : 0.0),
        rates_(system.omega.cwiseMax(frequency_ > 0.0 ? frequency_ : 1.0)),
        orders_(orders_of(system)) {
    Matrix forces = forces_of(system);
    for (const int i : key.springs.loaded) {
      const Stop& stop = system.stops[static_cast<std::size_t>(i)];
      const ContactForce& law = stop.force();
      const Vector pushing = pushing_row(system, i, key.frictions);
      forces.leftCols(n_) -= law.stiffness * pushing * stop.row.cwiseQuotient(rates_).transpose();
      forces.middleCols(n_, n_) -= dashpot_of(law) * pushing * stop.row.transpose();
    }
    generator_ = Matrix::Zero(size(), size());
    generator_.topRows(n_).middleCols(n_, n_) = rates_.asDiagonal();
    generator_.middleRows(n_, n_) = held_projection(system, key.closed) * forces;
    turn(frequency_, generator_);
  }

  const Matrix& generator() const { return generator_; }
  const Vector& rates() const { return rates_; }
  double frequency() const { return frequency_; }
  Eigen::Index size() const { return 2 * n_ + 1 + 2 * static_cast<Eigen::Index>(orders_.size()); }
  // x of a state at forcing phase theta, and of a deviation.
  Vector packed(const State& state, double theta) const {
    Vector x = Vector::Zero(size());
    x.head(n_) = rates_.cwiseProduct(state.q);
    x.segment(n_, n_) = state.qdot;
    for (std::size_t k = 0; k < orders_.size(); ++k)
      x.segment(place(k), 2) << std::cos(orders_[k] * theta), std::sin(orders_[k] * theta);
    x[2 * n_ + 2] = 1.0;
    return x;
  }
  Matrix packed(const Deviations& of, double theta) const {
    Matrix x = Matrix::Zero(size(), of.count());
    x.topRows(n_) = rates_.asDiagonal() * of.q;
    x.middleRows(n_, n_) = of.qdot;
    for (std::size_t k = 0; k < orders_.size(); ++k) {
      const Eigen::RowVectorXd turned = orders_[k] * frequency_ * of.delay;
      x.row(place(k)) = -std::sin(orders_[k] * theta) * turned;
      x.row(place(k) + 1) = std::cos(orders_[k] * theta) * turned;
    }
    return x;
  }
  Deviations unpacked(const Matrix& x, const Eigen::RowVectorXd& delay) const {
    return {rates_.cwiseInverse().asDiagonal() * x.topRows(n_), x.middleRows(n_, n_), delay};
  }
  void turn(double frequency, Matrix& generator) const {
    for (std::size_t k = 0; k < orders_.size(); ++k) {
      generator(place(k), place(k) + 1) = -orders_[k] * frequency;
      generator(place(k) + 1, place(k)) = orders_[k] * frequency;
    }
  }
  // N x size()
  Matrix forces_of(const System& system) const {
    Matrix forces = Matrix::Zero(n_, size());
    forces.leftCols(n_) = (-system.omega.cwiseAbs2().cwiseQuotient(rates_)).asDiagonal();
    add_others(system, forces);
    return forces;
  }
  Matrix forces_rate_of(const System& system, const System& tangent) const {
    Matrix forces = Matrix::Zero(n_, size());
    forces.leftCols(n_) =
        (-2.0 * system.omega.cwiseProduct(tangent.omega).cwiseQuotient(rates_)).asDiagonal();
    add_others(tangent, forces);
    return forces;
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
  // Of damping, forcing and load.
  void add_others(const System& of, Matrix& forces) const {
    forces.middleCols(n_, n_) = -of.damping();
    if (of.load()) forces.col(2 * n_ + 2) = *of.load();
    if (!of.forcing()) return;
    forces.col(place(0)) = of.forcing()->amplitude;
    for (std::size_t k = 0; k < of.forcing()->harmonics.size(); ++k) {
      forces.col(place(k + 1)) = of.forcing()->harmonics[k].cosine;
      forces.col(place(k + 1) + 1) = of.forcing()->harmonics[k].sine;
    }
  }

  Eigen::Index n_;
  double frequency_;
  Vector rates_;  // rad/s, N
  std::vector<double> orders_;
  Matrix generator_;
};

// (exp(matrix) - 1) x; by its series, which keeps short flights accurate; 20! is beyond 1/eps.
template <class Columns>
Columns exponential_less_one(const Matrix& matrix, double size, const Columns& x) {
  if (size >= 1.0) return matrix_exponential(matrix) * x - x;
  Columns term = x, sum = Columns::Zero(x.rows(), x.cols());
  for (int k = 1; k <= 20; ++k) {
    term = matrix * term / k;
    sum += term;
  }
  return sum;
}

// With the derivative of A by the parameter: growth of a deviation, and of the state, over s
// seconds.
ParameterGrowth held_growth(const System& system, const System& tangent,
                            const std::vector<int>& closed, const State& start, double theta,
                            double s, const Deviations& column) {
  const HeldGenerator held(system, PhaseKey{closed});
  const Eigen::Index n = system.modes(), m = held.size();
  Matrix rate = Matrix::Zero(m, m);
  rate.middleRows(n, n) = held_projection_rate(system, tangent, closed) * held.forces_of(system) +
                          held_projection(system, closed) * held.forces_rate_of(system, tangent);
  held.turn(tangent.forcing()->frequency, rate);
  const double stretch = -tangent.forcing()->frequency / held.frequency();
  // exp([A s, A_p s + A s_p; 0, A s]) of the deviation above the state.
  Matrix block = Matrix::Zero(2 * m, 2 * m);
  block.topLeftCorner(m, m) = block.bottomRightCorner(m, m) = held.generator() * s;
  block.topRightCorner(m, m) = rate * s + held.generator() * (stretch * s);
  Vector both(2 * m);
  both << held.packed(column, theta), held.packed(start, theta);
  const Vector added = exponential_less_one(block, held.generator().norm() * s, both);
  return {held.unpacked(added.head(m), column.delay),
          added.segment(m, n).cwiseQuotient(held.rates())};
}

}  // namespace

ParameterGrowth parameter_growth(const System& system, const System& tangent,
                                 const ExactPhase<double>& phase, const State& start, double theta,
                                 double s, const Deviations& column) {
  if (phase.closed().empty() && system.has_closed_forms() && !tangent.coupling())
    return free_growth(system, tangent, phase, start, theta, s, column);
  return held_growth(system, tangent, phase.closed(), start, theta, s, column);
}

Deviations held_growth(const System& system, const PhaseKey& key, double theta, double s,
                       const Deviations& start) {
  const HeldGenerator held(system, key);
  const Matrix matrix = held.generator() * s;
  return held.unpacked(exponential_less_one(matrix, matrix.norm(), held.packed(start, theta)),
                       start.delay);
}

void hold(const System& system, const System& tangent, const std::vector<int>& closed,
          const State& state, Deviations& column) {
  if (closed.empty()) return;
  const Matrix rows = rows_of(system, closed), directions = directions_of(system, closed),
               rows_rate = rows_of(tangent, closed);
  Vector beyond = rows.transpose() * column.q.col(0) + rows_rate.transpose() * state.q;
  Vector speed = rows.transpose() * column.qdot.col(0) + rows_rate.transpose() * state.qdot;
  for (std::size_t place = 0; place < closed.size(); ++place) {
    const auto a = static_cast<Eigen::Index>(place);
    if (system.is_friction(closed[place])) {
      beyond[a] = 0.0;  // it sticks where it is
      speed[a] -= tangent.friction(closed[place]).speed;
    } else {
      beyond[a] -= tangent.stops[static_cast<std::size_t>(closed[place])].gap;
    }
  }
  column.q.col(0) -= rows * LuFactors(rows.transpose() * rows).solve(beyond);
  column.qdot.col(0) -= directions * LuFactors(rows.transpose() * directions).solve(speed);
}

}  // namespace graze
