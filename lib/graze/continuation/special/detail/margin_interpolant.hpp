// The course of several quantities over a piece of a branch, each known with its rate at the ends:
// the Hermite cubic. Asked is whether the smallest of them changes sign between the ends otherwise
// than its signs there show: there and back, or through a short stay on the other side.
//
// What the cubic misses has the shape s^2 (1 - s)^2 of its error. Its size is taken as a quarter of
// the most that the cubic bends away from its chord: on a piece that shows how the quantity moves,
// the terms of fourth order are small beside those of second and third.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace graze {

struct MarginInterpolant {
  // On the piece 0 <= s <= 1, rates per length of the piece.
  static MarginInterpolant between(double start, double start_rate, double end, double end_rate);
  // Of a quantity that is known at one end only: linear over the half next to it.
  static MarginInterpolant from_start(double start, double rate);
  static MarginInterpolant to_end(double end, double rate);

  double at(double s) const;
  // Of what it says at s.
  double error(double s) const;

  std::array<double, 4> coefficients{};  // of 1, s, s^2, s^3
  double from = 0.0, to = 1.0;           // where it holds
  double bend = 0.0;                     // most that it departs from its chord
  double rounding = 0.0;                 // values nearer to zero than this are zero
};

// Where to look within the piece for changes of sign that its ends do not show; nothing where it is
// clear of them. Where there are no quantities nothing changes.
std::optional<double> suspected_sign_change(const std::vector<MarginInterpolant>& interpolants);

// Whether the rates at the ends account for the changes between them, as far as to a part: else the
// piece is too long to show how a quantity moves, or its ends are not of one branch.
bool is_shown(const std::vector<MarginInterpolant>& interpolants);

// Whether all of them are positive there.
bool all_positive(const std::vector<MarginInterpolant>& interpolants, double s);

}  // namespace graze
