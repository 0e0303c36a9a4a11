// What a response curve shows over its parameter: one number of a motion at one place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"

namespace graze {

enum class ShownQuantity {
  kAmplitude,     // largest absolute value
  kMax,           // largest
  kMin,           // smallest
  kHalfRange,     // half of what it swings
  kMean,          // over time
  kRms,           // root mean square about zero
  kDeviation,     // root mean square about the mean
  kHarmonic,      // size of the part at the forcing frequency
  kPeakVelocity,  // largest absolute velocity
  kPeakForce,     // of a stop
  kRmsForce,
  kMeanForce,  // impulse per time
  kImpactRate
};

// A quantity at a place of a list, or at its stop.
struct Shown {
  ShownQuantity quantity = ShownQuantity::kAmplitude;
  std::size_t place = 0;
};

inline constexpr ShownQuantity kShownQuantities[] = {
    ShownQuantity::kAmplitude, ShownQuantity::kMax,      ShownQuantity::kMin,
    ShownQuantity::kHalfRange, ShownQuantity::kMean,     ShownQuantity::kRms,
    ShownQuantity::kDeviation, ShownQuantity::kHarmonic, ShownQuantity::kPeakVelocity,
    ShownQuantity::kPeakForce, ShownQuantity::kRmsForce, ShownQuantity::kMeanForce,
    ShownQuantity::kImpactRate};

const char* name_of(ShownQuantity quantity);  // "peak-velocity"
bool is_of_stop(ShownQuantity quantity);
// Forces and impacts exist at stops; the largest velocity exists unless the place is a velocity.
bool exists_at(ShownQuantity quantity, const MeasuredPlace& place);
// Returns nullopt when it does not exist: no force where there are rigid impacts.
std::optional<double> shown_value(const Shown& shown, const std::vector<MeasuredPlace>& places,
                                  const Amplitudes& measured);
// The title of an axis, with quantity and place, and its SI unit.
std::string shown_title(const Shown& shown, const std::vector<MeasuredPlace>& places);
std::string shown_unit(const Shown& shown, const std::vector<MeasuredPlace>& places);

}  // namespace graze
