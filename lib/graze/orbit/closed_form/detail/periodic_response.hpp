// The response of the structure to forcing, constant load and impulses that all repeat every p
// forcing periods.
//
// With E(s) the free flow over s seconds and P = pT, the motion that repeats with the forcing is
//
//   Y(theta) = Re(Y^ e^{i theta}) + Y_0,      Y^, Y_0 = (I - E(P))^-1 (response from rest over P),
//
// and the response to a unit impulse along d_j, repeated every P, is
//
//   G_j(s) = E(s) (I - E(P))^-1 (0; d_j),     0 < s <= P, s after the impulse; s = P: just before.
//
// I - E(P) is one 2 x 2 block per mode. It is singular where the free motion of a mode has the
// period P: an undamped mode in resonance with the forcing or a fraction of it, a free mass.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/flow/exact/detail/free_basis.hpp"
#include "graze/system/system.hpp"

namespace graze {

// A coordinate along a contact row and its first two derivatives by time, m, m/s, m/s^2 (for a
// response to a unit impulse: of its displacement per kg^1/2 m/s of the modes).
struct RowMotion {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

// The motion by the other impulses along the row of each impact just before it, by rows; impulse j
// by columns. The diagonal is zero: an impact's own impulse is left out.
struct ImpulseMotions {
  Matrix value, rate, acceleration;  // k x k, as of RowMotion
};

class PeriodicResponse {
 public:
  int period() const { return period_; }           // p
  double duration() const { return duration_; }    // P, s
  double frequency() const { return frequency_; }  // rad/s
  const System& system() const { return *system_; }

  // Y along the row of stop `at`, at forcing phase theta.
  RowMotion forced(int at, double theta) const;
  // Y^ and Y_0 along the row of stop `at`, m.
  Complex forced_along(int at) const { return forced_at_[static_cast<std::size_t>(at)]; }
  double rest_along(int at) const { return rest_at_[static_cast<std::size_t>(at)]; }
  // The largest rate of a mode or, if larger, the forcing frequency, rad/s.
  double quickest() const;
  // G_by along the row of stop `at`, s in (0, P].
  RowMotion impulse(int at, int by, double s) const;
  // The same between any two of many impacts on these stops at these instants, s in [0, P): the
  // motion of a mode between neighbouring instants is computed once. Of two impacts at one instant
  // each counts as a whole P after the other.
  ImpulseMotions impulses(const std::vector<int>& stops, const Vector& instants) const;

  // Displacements and velocities of each mode after a unit impulse on it alone, by columns, at
  // these instants after the impulse, by rows.
  void modal_impulses(const Vector& instants, Matrix& displacements, Matrix& velocities) const;

  // The same as states of the modes.
  State forced_state(double theta) const;
  State impulse_state(int by, double s) const;

 private:
  friend struct PeriodicResponseAnswer periodic_response(const System& system, int period);
  struct Mode {
    double delta = 0.0, omega = 0.0, discriminant = 0.0;
    double displacement = 0.0, velocity = 0.0;  // (I - E(P))^-1 (0; 1)
  };
  // Displacement and velocity of the mode s after a unit impulse on it.
  static std::pair<double, double> after(const Mode& mode, double s);

  const System* system_ = nullptr;
  int period_ = 1;
  double duration_ = 0.0, frequency_ = 0.0;
  std::vector<Mode> modes_;
  ComplexVector forced_;            // Y^, displacements, kg^1/2 m
  Vector rest_;                     // Y_0, displacements, kg^1/2 m
  std::vector<Complex> forced_at_;  // along each row, m
  std::vector<double> rest_at_;     // along each row, m
};

// Why there is no closed form where modes do not move by themselves.
inline constexpr const char* kCoupledModes = "damping couples the modes";
inline constexpr const char* kHarmonics = "there are several harmonic loads";

struct PeriodicResponseAnswer {
  std::optional<PeriodicResponse> response;
  std::string why_not;  // a sentence where there is none
};

// Requires forcing. The response refers to the system, which must outlive it.
PeriodicResponseAnswer periodic_response(const System& system, int period);

}  // namespace graze
