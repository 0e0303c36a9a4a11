#include "graze/contact/contact_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace graze {
namespace {

ContactForce law(double exponent, ContactDamping damping) {
  return {3e4, exponent, damping, 40.0, 0.02, 3.0, Separation::kAtZeroForce};
}

std::vector<ContactForce> all_laws() {
  std::vector<ContactForce> laws;
  for (const double exponent : {1.0, 1.5, 2.3})
    for (const ContactDamping damping :
         {ContactDamping::kNone, ContactDamping::kConstant, ContactDamping::kDepth,
          ContactDamping::kOnset, ContactDamping::kPower, ContactDamping::kStep,
          ContactDamping::kApproach, ContactDamping::kCapped})
      laws.push_back(law(exponent, damping));
  return laws;
}

// F = k x^n + C T(x) v as physics.md writes it, with pow and the paper's formula of the onset.
double written_out(const ContactForce& f, double x, double v) {
  const double spring = f.stiffness * std::pow(x, f.exponent);
  switch (f.damping) {
    case ContactDamping::kNone:
      return spring;
    case ContactDamping::kConstant:
      return spring + f.coefficient * v;
    case ContactDamping::kDepth:
      return spring + f.coefficient * x * v;
    case ContactDamping::kOnset:
      return spring + f.coefficient * v * ((x + std::abs(x)) / (2.0 * x)) *
                          std::exp(((x - f.onset_depth) - std::abs(x - f.onset_depth)) *
                                   (f.onset_sharpness / f.onset_depth));
    case ContactDamping::kPower:
      return spring + f.coefficient * std::pow(x, f.exponent) * v;
    case ContactDamping::kStep: {
      const double part = std::min(x / f.onset_depth, 1.0);
      return spring + f.coefficient * part * part * (3.0 - 2.0 * part) * v;
    }
    case ContactDamping::kApproach:
      return spring + f.coefficient * std::pow(x, 0.5 * (f.exponent - 1.0)) * std::max(v, 0.0);
    case ContactDamping::kCapped:
      return spring + std::min(std::max(f.coefficient * v, -spring), spring);
  }
  return 0.0;
}

TEST(ContactForce, IsWhatTheLawsSay) {
  for (const ContactForce& f : all_laws())
    for (const double x : {1e-9, 1e-3, 0.019, 0.021, 0.3})
      for (const double v : {-0.7, 0.0, 0.4})
        EXPECT_NEAR(f.at(x, v), written_out(f, x, v), 1e-14 * std::abs(f.at(x, v)) + 1e-300);
}

// Richardson's central differences are good to about 1e-10 here.
double slope(const auto& f, double at) {
  const double h = 1e-3 * at;
  const double wide = (f(at + 2.0 * h) - f(at - 2.0 * h)) / (4.0 * h);
  const double close = (f(at + h) - f(at - h)) / (2.0 * h);
  return (4.0 * close - wide) / 3.0;
}

TEST(ContactForce, DerivativesByDepthAndRate) {
  for (const ContactForce& f : all_laws())
    for (const double x : {1e-3, 0.015, 0.3})
      for (const double v : {-0.7, 0.4}) {
        const double meant = slope([&](double d) { return written_out(f, d, v); }, x);
        EXPECT_NEAR(f.by_depth(x, v), meant, 1e-8 * std::abs(meant));
        const double by_rate = slope([&](double u) { return written_out(f, x, u); }, v);
        EXPECT_NEAR(f.by_rate(x, v), by_rate, 1e-9 * (1.0 + std::abs(by_rate)));
        EXPECT_NEAR(f.resisting(x, v), written_out(f, x, v) - written_out(f, x, 0.0),
                    1e-12 * std::abs(f.at(x, 1.0)));
      }
}

TEST(ContactForce, DerivativesByItsNumbers) {
  for (const ContactForce& f : all_laws()) {
    // What acts only on the way in is looked at there.
    const double x = 0.013, v = f.damping == ContactDamping::kApproach ? 0.4 : -0.4;
    const auto by = [&](double ContactForce::*number) {
      return slope(
          [&](double value) {
            ContactForce moved = f;
            moved.*number = value;
            return written_out(moved, x, v);
          },
          f.*number);
    };
    ContactForce rates;
    rates.exponent = 0.0;
    const auto check = [&](double ContactForce::*number) {
      ContactForce one = rates;
      one.*number = 1.0;
      const double meant = by(number);
      EXPECT_NEAR(f.rate_at(x, v, one), meant, 1e-8 * std::abs(meant) + 1e-12);
    };
    check(&ContactForce::stiffness);
    check(&ContactForce::exponent);
    check(&ContactForce::coefficient);
    check(&ContactForce::onset_depth);
    check(&ContactForce::onset_sharpness);
  }
}

TEST(ContactForce, StoresTheWorkOfItsSpring) {
  for (const double exponent : {1.0, 1.5, 2.3}) {
    const ContactForce f = law(exponent, ContactDamping::kNone);
    const double x = 0.2;
    EXPECT_NEAR(slope([&](double d) { return f.stored(d); }, x), f.at(x, 0.0), 1e-9 * f.at(x, 0.0));
    EXPECT_EQ(f.stored(0.0), 0.0);
  }
}

TEST(ContactForce, JumpsAtTheOnsetOnlyWhereDampingDoes) {
  for (const ContactForce& f : all_laws()) EXPECT_EQ(f.sets_in_smoothly(), f.at(0.0, 1.0) == 0.0);
}

}  // namespace
}  // namespace graze
