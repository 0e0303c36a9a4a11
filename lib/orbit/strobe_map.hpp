// The stroboscopic map: the state after one forcing period, with its derivatives.
//
// Compliant stops make the motion between two instants depend smoothly on its start, through every
// contact and where contacts are born and lost, so that their orbits are fixed points of this map
// and no impact needs an unknown of its own. It is the simulator's own motion, certified as in a
// run, and so are its fixed points. (Where the force of a stop sets in with a jump the map has a
// corner at a grazing contact, as with rigid stops.)
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "graze/orbit/passage.hpp"

namespace graze {

class StrobeMap {
 public:
  // `reference`: the system whose units are taken. Requires forcing. `section`: the forcing phase
  // it lies at, rad; 0, where states mean the same to every map, but where a contact begins or ends
  // nearby. There the map has a corner: an event is at the end of one period, or at the start of
  // the next.
  StrobeMap(const System& reference, const PassageOptions& options, double section = 0.0);

  const PassageOptions& options() const { return options_; }
  double section() const { return section_; }
  Eigen::Index size() const { return unit_.size(); }  // 2N
  // The state in units of the map, and back.
  Vector pack(const State& state) const;
  State unpack(const Vector& x) const;
  // (x_1, .., x_p) of the states at the starts of an orbit's forcing periods.
  Vector pack(const std::vector<State>& turns) const;
  // When the motion that starts at t = 0 first comes to the section.
  Instant<double> first_instant(const System& system) const;
  // The motion's start there; nothing where a rigid stop is penetrated, or a
  // compliant one so deep that its damping would keep the structure for longer than can be
  // followed.
  std::optional<MotionState<double>> start_of(const System& system, const Vector& x) const;

  struct Image {
    Vector image;         // 2N
    Matrix jacobian;      // 2N x 2N
    Vector by_parameter;  // 2N, where a tangent was given
  };
  // Nothing where the motion cannot be followed.
  std::optional<Image> image(const System& system, const Vector& x,
                             const System* tangent = nullptr) const;
  // How the image moves with a parameter alone; nothing likewise.
  std::optional<Vector> rate(const System& system, const Vector& x, const System& tangent) const;

  // The same within the period, at a forcing angle after the section, 0 <= angle < 2 pi.
  struct Within {
    State state;
    MotionState<double> at;  // that motion goes on from
    Deviations by_state;     // 2N columns, by x
    State by_angle;          // per rad
    std::vector<State> by_parameters;
  };
  std::optional<Within> within(const System& system, const Vector& x, double angle,
                               std::span<const System* const> tangents) const;
  // The motion over the period; nothing likewise. `minima`: as in PassageOptions.
  std::optional<Passage> follow(const System& system, const Vector& x, bool minima = false) const;

 private:
  Instant<double> end_of(const MotionState<double>& start) const;
  Deviations unit_deviations() const;

  PassageOptions options_;
  double section_;
  Vector unit_;  // of (q, q')
};

}  // namespace graze
