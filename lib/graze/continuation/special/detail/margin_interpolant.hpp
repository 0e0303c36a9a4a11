// Hermite cubics for several quantities over a piece of a branch, each known with its rate at the
// ends. They answer whether the smallest quantity changes sign within the piece in a way that its
// signs at the ends do not show: twice, or during a short interval.
//
// The error of a cubic has the shape s^2 (1 - s)^2. Its size is taken as a quarter of the largest
// deviation of the cubic from its chord: on a piece that resolves the quantity, the terms of fourth
// order are small beside those of second and third.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace graze {

struct MarginInterpolant {
  // On the piece 0 <= s <= 1, rates per length of the piece.
  static MarginInterpolant between(double start, double start_rate, double end, double end_rate);
  // For a quantity that is known at one end only: linear over the half next to it.
  static MarginInterpolant from_start(double start, double rate);
  static MarginInterpolant to_end(double end, double rate);

  double at(double s) const;
  // The error of the cubic at s.
  double error(double s) const;

  std::array<double, 4> coefficients{};  // of 1, s, s^2, s^3
  double from = 0.0, to = 1.0;           // where it holds
  double bend = 0.0;                     // most that it departs from its chord
  double rounding = 0.0;                 // values nearer to zero than this are zero
};

// Where within the piece the smallest quantity may change sign although its ends do not show it;
// nullopt when it cannot, or when there are no quantities.
std::optional<double> suspected_sign_change(const std::vector<MarginInterpolant>& interpolants);

// Whether the rates at the ends explain the changes between them, up to a part: else the piece is
// too long to resolve a quantity, or its ends are not on one branch.
bool is_shown(const std::vector<MarginInterpolant>& interpolants);

// Whether all of them are positive there.
bool all_positive(const std::vector<MarginInterpolant>& interpolants, double s);

}  // namespace graze
