// How a smooth piece of motion is integrated step by step, where a scene asks for that in place of
// the exact flow: explicit Runge-Kutta methods, with a fixed step or with error control.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

enum class StepMethod {
  kRk4,        // the classical one, order 4; fixed steps only
  kDopri5,     // Dormand and Prince, order 5, with dense output
  kFehlberg78  // Fehlberg, order 8 with an estimate of order 7
};

struct StepSetting {
  StepMethod method = StepMethod::kRk4;
  double step = 0.0;       // s; 0: error control (not with rk4)
  double tolerance = 0.0;  // allowed error of a step, relative to `speed`; with error control
  double speed = 0.0;      // size of the modal motion, kg^1/2 m/s: of the velocities and of the
                           // displacements times their frequencies
  double longest = 0.0;    // s, longest step with error control: longest_stable_step
};

// The longest step with which no mode of the system grows by rounding alone, s; infinite where
// nothing oscillates or decays. On the test equation x' = l x a step h is stable where |R(h l)| <=
// 1, R the method's stability polynomial: for an undamped mode w h <= 2.828 (rk4), 0.997 (dopri5),
// 2.365 (fehlberg78). See Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I and
// II.
double longest_stable_step(const System& system, StepMethod method);

}  // namespace graze
