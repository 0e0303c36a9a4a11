// Motion with closed stops against the matrix exponential of the constrained equations of motion,
//   q'' = P (f cos(theta) + load - 2 delta q' - w^2 q),   P = I - D (B^T D)^-1 B^T.
#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/detail/phase_choice.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "graze/flow/held/detail/exact_phase.hpp"
#include "graze/flow/variation/arc_work.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Dice;

enum class Law { kNormal, kOblique };
enum class Decay { kNone, kEqual, kRayleigh, kRatios, kOver };

struct Case {
  Law law;
  Decay decay;
  bool load;
};

System random_constrained_system(Dice& dice, const Case& c, int modes, int stops) {
  System system{Vector(modes), NaturalModes{Vector(modes)}, {}};
  const double equal = dice.uniform(0.02, 0.4);
  for (int j = 0; j < modes; ++j) {
    const double w = system.omega[j] = dice.uniform(0.5, 1.5) * (1.0 + 2.0 * j);
    system.modal().delta[j] = c.decay == Decay::kNone       ? 0.0
                              : c.decay == Decay::kEqual    ? equal
                              : c.decay == Decay::kRayleigh ? 0.01 + 0.004 * w * w
                              : c.decay == Decay::kRatios   ? dice.uniform(0.0, 0.4) * w
                                                            : dice.uniform(1.1, 2.0) * w;
  }
  system.modal().forcing =
      HarmonicForcing{dice.uniform(0.4, 3.0), dice.uniform(0.0, 6.0), dice.vector(modes, -1, 1)};
  if (c.load) system.modal().load = dice.vector(modes, -1.0, 1.0);
  for (int k = 0; k < stops; ++k) {
    const Vector row = dice.vector(modes, -1.0, 1.0);
    Vector direction = momentum_direction(row);
    if (c.law == Law::kOblique) {
      direction += 0.2 * direction.norm() * dice.vector(modes, -1.0, 1.0);
      direction /= row.dot(direction);
    }
    system.stops.push_back({row, dice.uniform(-0.3, 0.3), ImpactLaw{direction, 0.5}});
  }
  return system;
}

struct Constrained {
  Matrix rows, directions, projector;
};

Constrained constrained(const System& system, const std::vector<int>& closed) {
  const Eigen::Index n = system.modes(), k = static_cast<Eigen::Index>(closed.size());
  Constrained c{Matrix(n, k), Matrix(n, k), {}};
  for (Eigen::Index i = 0; i < k; ++i) {
    const Stop& stop = system.stops[static_cast<std::size_t>(closed[static_cast<std::size_t>(i)])];
    c.rows.col(i) = stop.row;
    c.directions.col(i) = stop.direction();
  }
  c.projector = Matrix::Identity(n, n) -
                c.directions * (c.rows.transpose() * c.directions).inverse() * c.rows.transpose();
  return c;
}

// A state on the closed stops, at rest against them.
State held_state(const System& system, const Constrained& c, const std::vector<int>& closed,
                 Dice& dice) {
  const int n = system.modes();
  Vector gaps(c.rows.cols());
  for (std::size_t i = 0; i < closed.size(); ++i)
    gaps[static_cast<Eigen::Index>(i)] = system.stops[static_cast<std::size_t>(closed[i])].gap;
  Vector q = dice.vector(n, -0.3, 0.3), qdot = dice.vector(n, -0.3, 0.3);
  const Matrix gram = (c.rows.transpose() * c.rows).inverse();
  q += c.rows * gram * (gaps - c.rows.transpose() * q);
  qdot -= c.rows * gram * (c.rows.transpose() * qdot);
  return {q, qdot};
}

using Longer = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// e^a by its Taylor series at a/2^k of norm 1/2 at most, where 18 terms leave less than a rounding,
// squared k times. (Eigen's own takes half a minute to compile.)
Longer exponential(Longer a) {
  const long double norm = a.cwiseAbs().rowwise().sum().maxCoeff();
  int squarings = 0;
  while (std::ldexp(norm, -squarings) > 0.5L) ++squarings;
  a *= std::ldexp(1.0L, -squarings);
  Longer term = Longer::Identity(a.rows(), a.cols()), sum = term;
  for (int k = 1; k <= 18; ++k) {
    term = (term.lazyProduct(a) / static_cast<long double>(k)).eval();
    sum += term;
  }
  for (; squarings > 0; --squarings) sum = sum.lazyProduct(sum).eval();
  return sum;
}

// Stiff modes cost digits, in what the stops leave of them and in squaring the exponential: four
// more than double has.
State by_exponential(const System& system, const Constrained& c, const State& start, double theta,
                     double s) {
  const Eigen::Index n = system.modes();
  const double w = system.forcing()->frequency;
  const Longer rows = c.rows.cast<long double>(), directions = c.directions.cast<long double>();
  const Longer projector = Longer::Identity(n, n) - directions *
                                                        (rows.transpose() * directions).inverse() *
                                                        rows.transpose();
  Longer a = Longer::Zero(2 * n + 3, 2 * n + 3);
  a.block(0, n, n, n).setIdentity();
  a.block(n, 0, n, n) = -projector * system.omega.cast<long double>().cwiseAbs2().asDiagonal();
  a.block(n, n, n, n) = -2.0 * projector * system.delta().cast<long double>().asDiagonal();
  a.block(n, 2 * n, n, 1) = projector * system.forcing()->amplitude.cast<long double>();
  if (system.load()) a.block(n, 2 * n + 2, n, 1) = projector * system.load()->cast<long double>();
  a(2 * n, 2 * n + 1) = -w;
  a(2 * n + 1, 2 * n) = w;
  Vector x(2 * n + 3);
  x << start.q, start.qdot, std::cos(theta), std::sin(theta), 1.0;
  const Longer step = exponential(a * static_cast<long double>(s));
  const Vector y = (step * x.cast<long double>()).cast<double>();
  return {y.head(n), y.segment(n, n)};
}

// Without stops, from the equation of motion.
Vector free_acceleration(const System& system, const State& state, double theta) {
  Vector free = system.forcing()->amplitude * std::cos(theta) -
                2.0 * system.delta().cwiseProduct(state.qdot) -
                system.omega.cwiseAbs2().cwiseProduct(state.q);
  if (system.load()) free += *system.load();
  return free;
}

Vector acceleration_of(const System& system, const Constrained& c, const State& state,
                       double theta) {
  return c.projector * free_acceleration(system, state, theta);
}

// lambda_i/(b_i.b_i).
double force_of(const System& system, const Constrained& c, const State& state, double theta,
                Eigen::Index i) {
  const Vector free = free_acceleration(system, state, theta);
  const Vector lambda = (c.rows.transpose() * c.directions).inverse() * c.rows.transpose() * free;
  return lambda[i] / c.rows.col(i).squaredNorm();
}

double mechanical_size(const System& system, const State& state) {
  return state.qdot.squaredNorm() + system.omega.cwiseProduct(state.q).squaredNorm();
}

// False where the phase was refused.
bool expect_motion(const System& system, const std::vector<int>& closed, Dice& dice) {
  const Constrained c = constrained(system, closed);
  const State start = held_state(system, c, closed, dice);
  const double theta = dice.uniform(0.0, 6.0), window = 5.0;
  const auto made = make_contact_phase<double>(system, {closed});
  ContactPhase<double>& phase = *made;
  if (!phase.refusal().empty()) return false;
  phase.start(theta, start.q, start.qdot);
  const int open = static_cast<int>(system.stops.size()) - 1;
  const bool is_open = std::find(closed.begin(), closed.end(), open) == closed.end();
  const double energy = mechanical_size(system, start);
  const double quickest = 1.0 + system.omega.maxCoeff();
  for (int i = 0; i <= 20; ++i) {
    const double s = window * i / 20.0, angle = theta + system.forcing()->frequency * s;
    const State expected = by_exponential(system, c, start, theta, s);
    Vector q(system.modes()), qdot(system.modes());
    phase.state(s, q, qdot);
    // Rounding is one of q, |q'| and |w q| together, and of accelerations by the quickest of rates.
    const double unit = 1.0 + expected.q.norm() + expected.qdot.norm() + std::sqrt(energy);
    // The generator is known to eps times its quickest rate, which acts for s seconds.
    const double drift = 4.0 * std::numeric_limits<double>::epsilon() * quickest * s;
    EXPECT_LE((q - expected.q).norm(), (1e-12 + drift) * unit) << s;
    EXPECT_LE((qdot - expected.qdot).norm(), 1e-11 * unit) << s;
    for (std::size_t k = 0; k < closed.size(); ++k) {
      const CurvePoint<double> force = phase.exact()->force(closed[k], window).at(s, 0);
      const double exact = force_of(system, c, expected, angle, static_cast<Eigen::Index>(k));
      EXPECT_NEAR(force.value, exact, 1e-12 * unit * quickest) << s;
    }
    if (!is_open) continue;
    const Stop& stop = system.stops[static_cast<std::size_t>(open)];
    const ArcCurve<double> gap = phase.exact()->gap(open, window, false);
    const CurvePoint<double> distance = gap.at(s, 0), closing = gap.at(s, 1);
    EXPECT_NEAR(distance.value, stop.gap - stop.row.dot(expected.q), 2e-12 * unit);
    EXPECT_NEAR(closing.value, -stop.row.dot(expected.qdot), 1e-11 * unit);
    EXPECT_NEAR(closing.slope, -stop.row.dot(acceleration_of(system, c, expected, angle)),
                1e-11 * unit * quickest);
    // The energy balance of the arc.
    const Work work = work_along(system, phase, s);
    const double change = 0.5 * (expected.qdot.squaredNorm() - start.qdot.squaredNorm() +
                                 system.omega.cwiseProduct(expected.q).squaredNorm() -
                                 system.omega.cwiseProduct(start.q).squaredNorm());
    EXPECT_NEAR(work.forcing + work.load + work.constraint - work.dissipation, change,
                1e-11 * (energy + std::abs(work.forcing) + work.dissipation))
        << s;
    EXPECT_GE(work.dissipation, 0.0);
  }
  return true;
}

class ConstrainedMotionUnder : public testing::TestWithParam<Case> {};

TEST_P(ConstrainedMotionUnder, IsThatOfTheConstrainedEquations) {
  int followed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(700 + seed);
    const int modes = 2 + dice.pick(5);
    const System system = random_constrained_system(dice, GetParam(), modes, 2);
    followed += expect_motion(system, {0}, dice);
    if (modes > 2) expect_motion(system, {0, 1}, dice);
  }
  // An oblique law may make a few of them unstable.
  EXPECT_GE(followed, GetParam().law == Law::kNormal ? 20 : 12);
}

INSTANTIATE_TEST_SUITE_P(Laws, ConstrainedMotionUnder,
                         testing::Values(Case{Law::kNormal, Decay::kNone, false},
                                         Case{Law::kNormal, Decay::kEqual, true},
                                         Case{Law::kNormal, Decay::kRayleigh, false},
                                         Case{Law::kNormal, Decay::kRatios, true},
                                         Case{Law::kNormal, Decay::kOver, false},
                                         Case{Law::kOblique, Decay::kEqual, false},
                                         Case{Law::kOblique, Decay::kRatios, true}));

// Where complex modes fail: a held structure that resonates with its forcing, undamped, under an
// oblique law (its own frequencies from the constrained stiffness).
TEST(HeldMotion, HoldsAtResonanceUnderAnObliqueLaw) {
  int followed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(900 + seed);
    System system =
        random_constrained_system(dice, {Law::kOblique, Decay::kNone, seed % 2 == 0}, 4, 2);
    const Constrained c = constrained(system, {0});
    double smallest = 1e9;
    for (const Eigenvalue& l : eigenvalues(c.projector * system.omega.cwiseAbs2().asDiagonal()))
      if (l.value.real() > 1e-6 && l.value.imag() == 0.0)
        smallest = std::min(smallest, l.value.real());
    system.modal().forcing->frequency = std::sqrt(smallest);
    followed += expect_motion(system, {0}, dice);
  }
  EXPECT_GE(followed, 8);
}

// A free direction: two free masses held together at one point still drift as one.
TEST(HeldMotion, HoldsWithAFreeDirectionLeft) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(1100 + seed);
    System system =
        random_constrained_system(dice, {Law::kNormal, Decay::kNone, seed % 2 == 0}, 3, 2);
    system.omega[0] = system.omega[1] = 0.0;
    EXPECT_TRUE(expect_motion(system, {0}, dice));
    system.modal().delta = dice.vector(3, 0.1, 0.5);
    EXPECT_TRUE(expect_motion(system, {0}, dice));
  }
}

// Several free masses beside stiff, critically damped and undamped modes: the free motions are
// defective together, the others have to be followed at their own pace all the same.
TEST(HeldMotion, HoldsWithSeveralFreeMassesBesideStiffModes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(1300 + seed);
    System system =
        random_constrained_system(dice, {Law::kNormal, Decay::kRatios, seed % 2 == 0}, 8, 3);
    system.omega.head(3).setZero();
    system.modal().delta.head(3).setZero();
    system.modal().delta.segment(3, 3) = system.omega.segment(3, 3);
    system.omega[7] = 400.0;
    system.modal().delta[7] = 12.0;
    EXPECT_TRUE(expect_motion(system, {0}, dice));
    EXPECT_TRUE(expect_motion(system, {0, 1}, dice));
  }
}

// A gap that starts from zero grows as g' s + g'' s^2/2; what rounds in it shrinks with s, in modes
// that are told apart and in those that are not.
TEST(HeldMotion, LeavesAStopWithRelativeAccuracy) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(1500 + seed);
    System system = random_constrained_system(dice, {Law::kNormal, Decay::kRatios, true}, 4, 2);
    if (seed % 2 == 0) system.omega.head(3).setOnes();
    if (seed % 2 == 0) system.modal().delta.head(3) << 1.0, 1.0001, 1.0002;
    const Constrained c = constrained(system, {0});
    const State start = held_state(system, c, {0}, dice);
    const double theta = dice.uniform(0.0, 6.0);
    const auto phase = make_contact_phase<double>(system, {{0}});
    phase->start(theta, start.q, start.qdot);
    const ArcCurve<double> gap = phase->exact()->gap(1, 1.0, true);
    const Vector& row = system.stops[1].row;
    const double speed = -row.dot(start.qdot),
                 push = -row.dot(acceleration_of(system, c, start, theta));
    const double size = row.norm() * (start.qdot.norm() + 1.0);
    for (const double s : {1e-3, 1e-6, 1e-9, 1e-12}) {
      const CurvePoint<double> point = gap.at(s, 0);
      const double third = std::abs(gap.at(0.0, 3).value) + gap.at(0.0, 2).bound * s;
      EXPECT_NEAR(point.value, s * (speed + push * s / 2.0), 1e-13 * size * s + third * s * s * s)
          << s;
      EXPECT_LE(point.noise, 1e-12 * size * s) << s;
    }
  }
}

TEST(HeldMotion, RefusesAnObliqueLawThatMakesItGrow) {
  // q'' = (I - d b^T)(-W q) with b = (1, 0), d = (1, t): the rest of it is q_2'' = -w_2^2 q_2
  // whatever t; with b = (1, 1), d = (1 + t, -t) the stiffness left is w_1^2 (-t) + w_2^2 (1 + t)
  // on q_2 = -q_1, negative where t is beyond w_2^2/(w_1^2 - w_2^2).
  const double w1 = 3.0, w2 = 1.0, limit = w2 * w2 / (w1 * w1 - w2 * w2);
  for (const double part : {0.5, 0.99, 1.01, 2.0}) {
    const double t = limit * part;
    System system{Vector(2), NaturalModes{Vector::Zero(2)}, {}};
    system.omega << w1, w2;
    system.stops.push_back(
        {Eigen::Vector2d(1.0, 1.0), 0.0, ImpactLaw{Eigen::Vector2d(1.0 + t, -t), 0.5}});
    EXPECT_EQ(make_contact_phase<double>(system, {{0}})->refusal().empty(), part < 1.0) << part;
  }
}

}  // namespace
}  // namespace graze
