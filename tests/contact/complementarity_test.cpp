// Several contacts at once, against a search of all sets of contacts.
#include "graze/contact/detail/complementarity.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
