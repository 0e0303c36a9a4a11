// What a picture of a run shows.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

enum class RunPicture {
  kMotion,    // over time, with phase portraits
  kReturns,   // each impact over the one before
  kSpectrum,  // amplitudes over the frequency
  kPsd,       // power spectral density
  kShapes,    // the beam's shape at chosen instants
  kForces     // of every stop over time
};

inline constexpr RunPicture kRunPictures[] = {RunPicture::kMotion,   RunPicture::kReturns,
                                              RunPicture::kSpectrum, RunPicture::kPsd,
                                              RunPicture::kShapes,   RunPicture::kForces};
const char* name_of(RunPicture picture);  // "motion"

// A beam bent: its displacement over x at an instant.
struct BeamShape {
  double time = 0.0;                  // s
  std::vector<double> x, deflection;  // m
};

}  // namespace graze
