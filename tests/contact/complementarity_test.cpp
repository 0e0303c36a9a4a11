// Several contacts at once, against a search of all sets of contacts.
#include "graze/contact/detail/complementarity.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "graze/base/vector.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// The one set of active contacts whose impulses are >= 0 and whose others need none.
Vector by_exhaustion(const Matrix& delassus, const Vector& v) {
  const auto n = static_cast<int>(v.size());
  for (int set = 0; set < 1 << n; ++set) {
    std::vector<Eigen::Index> active;
    for (int i = 0; i < n; ++i)
      if (set >> i & 1) active.push_back(i);
    Vector p = Vector::Zero(n);
    if (!active.empty())
      p(active) = delassus(active, active).eval().fullPivLu().solve(v(active).eval());
    const Vector w = v - delassus * p;
    bool fits = true;
    for (int i = 0; i < n; ++i) fits = fits && ((set >> i & 1) ? p[i] >= 0.0 : w[i] <= 0.0);
    if (fits) return p;
  }
  return Vector::Constant(n, std::nan(""));
}

TEST(Complementarity, IsTheOneSolution) {
  support::Dice dice(11);
  for (int i = 0; i < 3000; ++i) {
    const int contacts = 1 + dice.pick(6), modes = contacts + dice.pick(3);
    Matrix rows(modes, contacts);
    for (int c = 0; c < contacts; ++c) rows.col(c) = dice.vector(modes, -1.0, 1.0);
    const Matrix delassus = rows.transpose() * rows;
    const Vector v = dice.vector(contacts, -1.0, 1.0);
    const std::optional<Vector> p =
        solve_contacts<double>(delassus, v, Vector::Constant(contacts, 1e-15));
    ASSERT_TRUE(p);
    const Vector expected = by_exhaustion(delassus, v);
    EXPECT_LE((delassus * (*p - expected)).norm(), 1e-11) << "case " << i;
  }
}

// By the definition: what a solution leaves of w, p and p.w, each within n roundings of its terms.
void expect_solution(const Matrix& delassus, const Vector& v, const Vector& p, double slack) {
  const Vector w = v - delassus * p;
  const double eps = std::numeric_limits<double>::epsilon();
  const Vector size = v.cwiseAbs() + delassus.cwiseAbs() * p.cwiseAbs();
  const double roundings = 2.0 * static_cast<double>(v.size() + 2);
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    EXPECT_GE(p[i], 0.0);
    EXPECT_LE(w[i], roundings * eps * size[i] + slack);
    EXPECT_LE(std::abs(p[i] * w[i]), p[i] * (roundings * eps * size[i] + slack));
  }
}

// What Lemke's method makes of a problem that all sets can be tried on.
TEST(Complementarity, LemkeFindsWhatTheSetsGive) {
  support::Dice dice(12);
  for (int i = 0; i < 2000; ++i) {
    const int contacts = 2 + dice.pick(7), modes = contacts + dice.pick(3);
    Matrix rows(modes, contacts), directions(modes, contacts);
    for (int c = 0; c < contacts; ++c) rows.col(c) = dice.vector(modes, -1.0, 1.0);
    // Symmetric, or only positive definite: then it is a P-matrix without symmetry.
    Matrix delassus = rows.transpose() * rows;
    if (i % 2 == 1) {
      const Matrix turn =
          Matrix(dice.vector(contacts, -1.0, 1.0) * dice.vector(contacts, -1.0, 1.0).transpose());
      delassus += turn - turn.transpose();
    }
    const Vector v = dice.vector(contacts, -1.0, 1.0);
    const auto active = LemkeTableau<double>(delassus, -v).solve();
    ASSERT_TRUE(active);
    const std::optional<Vector> p =
        solve_many_contacts<double>(delassus, v, Vector::Constant(contacts, 1e-15));
    ASSERT_TRUE(p) << "case " << i;
    const Vector expected = by_exhaustion(delassus, v);
    EXPECT_LE((delassus * (*p - expected)).norm(), 1e-10 * (1.0 + expected.norm())) << "case " << i;
  }
}

TEST(Complementarity, OfAHundredContactsLeavesRounding) {
  support::Dice dice(13);
  for (int i = 0; i < 60; ++i) {
    const int contacts = 13 + dice.pick(88), modes = contacts + dice.pick(30);
    Matrix rows(modes, contacts);
    for (int c = 0; c < contacts; ++c) rows.col(c) = dice.vector(modes, -1.0, 1.0);
    const Matrix delassus = rows.transpose() * rows;
    const Vector v = dice.vector(contacts, -1.0, 1.0);
    const std::optional<Vector> p = solve_contacts<double>(delassus, v, Vector::Zero(contacts));
    ASSERT_TRUE(p) << contacts << " contacts";
    expect_solution(delassus, v, *p, 0.0);
    EXPECT_GT((p->array() > 0.0).count(), 0);
  }
}

// More stops than modes, some of them at one place, some touched at no speed at all: D is singular
// and the impulses are not unique, what they do to the motion is.
TEST(Complementarity, OfManyDependentContactsTheMotionIsOne) {
  support::Dice dice(14);
  for (int i = 0; i < 60; ++i) {
    const int modes = 2 + dice.pick(9), contacts = 14 + dice.pick(40);
    Matrix rows(modes, contacts);
    for (int c = 0; c < contacts; ++c)
      rows.col(c) = c % 4 == 3 ? Vector(rows.col(c - 1)) : dice.vector(modes, -1.0, 1.0);
    // All on one side of a motion: there is room to leave all of them.
    const Vector way = Vector::Unit(modes, 0);
    for (int c = 0; c < contacts; ++c)
      if (rows(0, c) < 0.0) rows.col(c) = -rows.col(c);
    const Matrix delassus = rows.transpose() * rows;
    Vector speed = rows.transpose() * (way + dice.vector(modes, -1.0, 1.0));
    for (int c = 0; c < contacts; c += 5) speed[c] = 0.0;
    const Vector rounding = Vector::Constant(contacts, 1e-13);
    const std::optional<Vector> p = solve_contacts<double>(delassus, speed, rounding);
    ASSERT_TRUE(p) << contacts << " contacts on " << modes << " modes, case " << i;
    expect_solution(delassus, speed, *p, 1e-13 + 1e-13 * p->lpNorm<1>());
    // Listed the other way round.
    const Vector turned = speed.reverse();
    const std::optional<Vector> other =
        solve_contacts<double>(Matrix(delassus.reverse()), turned, rounding);
    ASSERT_TRUE(other);
    EXPECT_LE((rows * (*p - other->reverse())).norm(), 1e-9 * (1.0 + p->norm())) << "case " << i;
  }
}

// Two stops that face each other and are both approached: no impulses stop both.
TEST(Complementarity, OfManyContactsThatContradictEachOtherHasNone) {
  const int contacts = 14;
  Matrix rows = Matrix::Identity(contacts, contacts);
  Matrix delassus = rows;
  delassus(0, 1) = delassus(1, 0) = -1.0;  // opposite rows at one place
  EXPECT_FALSE(solve_contacts<double>(delassus, Vector::Ones(contacts), Vector::Zero(contacts)));
}

TEST(Complementarity, StopsThatActAsOneShareNothingTwice) {
  // Two stops at one place: the first takes all, the singular matrix does no harm.
  Matrix delassus(2, 2);
  delassus << 2.0, 2.0, 2.0, 2.0;
  const std::optional<Vector> p =
      solve_contacts<double>(delassus, Eigen::Vector2d(1.0, 1.0), Vector::Constant(2, 1e-15));
  ASSERT_TRUE(p);
  EXPECT_EQ((*p)[0], 0.5);
  EXPECT_EQ((*p)[1], 0.0);
}

// A direction held from both sides, at rest to the last bit, while another stop takes a blow: what
// the two make up is the blow's rounding, not that of their own speeds.
TEST(Complementarity, BothSidesOfAHeldDirectionStandABlow) {
  support::Dice dice(12);
  for (int i = 0; i < 1000; ++i) {
    Matrix rows(2, 3);
    rows.col(0) = dice.vector(2, -1.0, 1.0);
    rows.col(1) << dice.uniform(0.1, 1.0), 0.0;
    rows.col(2) = -rows.col(1);
    const Matrix directions = rows * rows.colwise().squaredNorm().cwiseInverse().asDiagonal();
    const Matrix delassus = rows.transpose() * directions;
    const Vector blow = Eigen::Vector3d(dice.uniform(0.0, 100.0), 0.0, 0.0);
    const std::optional<Vector> p =
        solve_contacts<double>(delassus, blow, Eigen::Vector3d(1e-13, 0.0, 0.0));
    ASSERT_TRUE(p) << "case " << i;
    EXPECT_LE((blow - delassus * *p).norm(), 1e-14 * delassus.cwiseAbs().sum() * p->sum());
  }
}

TEST(Complementarity, NothingToUndoNeedsNoImpulse) {
  const std::optional<Vector> p = solve_contacts<double>(
      Matrix::Identity(3, 3), Eigen::Vector3d(-1.0, 0.0, -0.5), Vector::Zero(3));
  ASSERT_TRUE(p);
  EXPECT_EQ(p->norm(), 0.0);
}

}  // namespace
}  // namespace graze
