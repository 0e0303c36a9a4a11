// Contacts in 50 digits against closed forms, written down in that scalar.
#include "graze/study/cost/detail/extended_contact.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

const Extended kPi = boost::math::constants::pi<Extended>();

// A free body of 1/4 kg, whose row 2 has no rounding.
ExtendedContact contact_of(const ContactForce& law, const Extended& speed, double longest = 1.0) {
  System system{Vector::Zero(1), NaturalModes{Vector::Zero(1)}, {}};
  const Vector row = Vector::Constant(1, 2.0);
  system.stops.push_back({row, 1.0, law});
  RealVector<Extended> q(1), qdot(1);
  q << Extended(0.5);
  qdot << speed / 2;
  return follow_contact(system, 0, q, qdot, {0, longest, {}});
}

ContactForce spring(double k, double exponent) {
  ContactForce law;
  law.stiffness = k;
  law.exponent = exponent;
  return law;
}

// What errs by 1e-18 or more counts: double precision rounds at 1e-16.
void expect_equal(const Extended& a, const Extended& b) {
  EXPECT_LT(static_cast<double>(abs(a / b - 1)), 1e-18) << a << " " << b;
}

TEST(ExtendedContact, LinearSpringTakesHalfAPeriod) {
  const ExtendedContact contact = contact_of(spring(1e6, 1.0), Extended(0.25));
  EXPECT_EQ(contact.message, "");
  expect_equal(contact.separation, kPi * sqrt(Extended(0.25) / Extended(1e6)));
  expect_equal(contact.end, contact.separation);
  expect_equal(-2 * contact.qdot[0], Extended(0.25));
}

// Duration by the gamma function, c = 4/5 sqrt(pi) G(2/5)/G(9/10) = 2.94327.., K. L. Johnson.
TEST(ExtendedContact, HertzGivesBackTheSpeed) {
  const Extended v = 0.125, k = 3e9;
  const ExtendedContact contact = contact_of(spring(3e9, 1.5), v);
  expect_equal(-2 * contact.qdot[0], v);
  const Extended deepest = pow(Extended(5) / 4 * Extended(0.25) * v * v / k, Extended(2) / 5);
  expect_equal(contact.separation, Extended(4) / 5 * sqrt(kPi) * tgamma(Extended(2) / 5) /
                                       tgamma(Extended(9) / 10) * deepest / v);
}

// e = exp(-2 zeta arccos(zeta)/sqrt(1 - zeta^2)) where the force is gone, below the surface; the
// body then flies on at that speed.
TEST(ExtendedContact, DashpotPartsBelowTheSurface) {
  ContactForce law = spring(1e6, 1.0);
  law.damping = ContactDamping::kConstant;
  const Extended m = 0.25, zeta = 0.25;
  law.coefficient = 250.0;  // 2 zeta sqrt(k m)
  const ExtendedContact contact = contact_of(law, Extended(0.25));
  EXPECT_EQ(contact.message, "");
  const Extended turn = sqrt(1 - zeta * zeta);
  expect_equal(-2 * contact.qdot[0] / Extended(0.25), exp(-2 * zeta * acos(zeta) / turn));
  EXPECT_GT(contact.end, contact.separation);
  // At zero depth the half period of the damped oscillator is over.
  law.separation = Separation::kAtZeroDepth;
  const ExtendedContact whole = contact_of(law, Extended(0.25));
  expect_equal(whole.separation, kPi / (turn * sqrt(Extended(1e6) / m)));
  expect_equal(-2 * whole.qdot[0] / Extended(0.25), exp(-kPi * zeta / turn));
}

// A (1 + e) = ln[(1 + A)/(1 - A e)], A = d v: as an equation that the result has to satisfy.
TEST(ExtendedContact, HuntCrossley) {
  ContactForce law = spring(2e8, 1.5);
  law.damping = ContactDamping::kPower;
  law.coefficient = 8e8;
  const Extended v = 0.25, a = 1;
  const ExtendedContact contact = contact_of(law, v);
  EXPECT_EQ(contact.message, "");
  const Extended e = -2 * contact.qdot[0] / v;
  expect_equal(a * (1 + e), log((1 + a) / (1 - a * e)));
}

TEST(ExtendedContact, SaysWhatItDoesNotFollow) {
  EXPECT_NE(contact_of(spring(1.0, 1.0), Extended(0.25), 0.1).message.find("longer"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
