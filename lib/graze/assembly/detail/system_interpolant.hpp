// The numbers of a scene's system over a parameter, as functions that can be bounded over cells.
//
// Each number is a piecewise cubic: it and its derivative by the parameter are those of the systems
// at the ends of each piece, and pieces are halved until in their middle number and derivative
// agree with the system's own to kInterpolantTolerance. That is exact, to rounding, for numbers
// that are polynomials of the parameter up to the third degree: over the frequency, a gap, a
// restitution, the amplitude, viscous or Rayleigh damping, damping ratios, given frequencies. Over
// others (a length, a position, a density) it is an interpolation whose error is only seen in the
// middle of the pieces.
#pragma once

#include <optional>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/base/interval/detail/mean_value_form.hpp"

namespace graze {

// Relative to the largest number of its kind (all frequencies, all entries of one row, ..).
inline constexpr double kInterpolantTolerance = 1e-12;

// A System over a cell.
struct SystemForms {
  using Forms = std::vector<MeanValueForm>;
  struct Stop {
    MeanValueForm gap;
    Forms row, direction, restitution;
  };
  MeanValueForm frequency;              // rad/s; 0 without forcing
  Forms omega, delta, amplitude, load;  // of each mode; amplitude and load 0 where absent
  std::vector<Stop> stops;
};

class SystemInterpolant {
 public:
  // Refers to nothing. Requires low < high.
  SystemInterpolant(const SystemFamily& family, double low, double high);

  struct Piece {
    double low = 0.0, high = 0.0;
    std::vector<Vector> powers;  // of (value - middle)/half, from 0 on, of all numbers; none where
                                 // the scene does not allow the values
    bool agrees = true;          // to kInterpolantTolerance
    bool exists() const { return !powers.empty(); }
  };
  const std::vector<Piece>& pieces() const { return pieces_; }
  int systems() const { return systems_; }  // that were assembled

  // The system over a cell of a piece that exists, or at a value of it (low = high).
  SystemForms over(const Piece& piece, double low, double high) const;

 private:
  std::vector<Piece> pieces_;
  std::optional<System> like_;  // the shape of all
  int systems_ = 0;
};

}  // namespace graze
