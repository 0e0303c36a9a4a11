#include "graze/record/shown_quantity.hpp"

#include <complex>

namespace graze {
namespace {

std::optional<double> of_row(ShownQuantity quantity, const Amplitude& row) {
  switch (quantity) {
    case ShownQuantity::kMax:
      return row.highest;
    case ShownQuantity::kMin:
      return row.lowest;
    case ShownQuantity::kHalfRange:
      return row.half_range();
    case ShownQuantity::kMean:
      return row.mean;
    case ShownQuantity::kRms:
      return row.rms;
    case ShownQuantity::kHarmonic:
      return row.harmonic ? std::optional(std::abs(*row.harmonic)) : std::nullopt;
    case ShownQuantity::kPeakVelocity:
      return row.speed;
    default:
      return row.largest();
  }
}

const char* words(ShownQuantity quantity) {
  switch (quantity) {
    case ShownQuantity::kMax:
      return "largest value";
    case ShownQuantity::kMin:
      return "smallest value";
    case ShownQuantity::kHalfRange:
      return "half range";
    case ShownQuantity::kMean:
      return "mean";
    case ShownQuantity::kRms:
      return "root mean square";
    case ShownQuantity::kHarmonic:
      return "first harmonic";
    case ShownQuantity::kPeakVelocity:
      return "largest velocity";
    case ShownQuantity::kPeakForce:
      return "largest force";
    case ShownQuantity::kRmsForce:
      return "root mean square force";
    case ShownQuantity::kImpactRate:
      return "impacts per time";
    case ShownQuantity::kAmplitude:
      break;
  }
  return "amplitude";
}

}  // namespace

const char* name_of(ShownQuantity quantity) {
  switch (quantity) {
    case ShownQuantity::kMax:
      return "max";
    case ShownQuantity::kMin:
      return "min";
    case ShownQuantity::kHalfRange:
      return "half-range";
    case ShownQuantity::kMean:
      return "mean";
    case ShownQuantity::kRms:
      return "rms";
    case ShownQuantity::kHarmonic:
      return "harmonic";
    case ShownQuantity::kPeakVelocity:
      return "peak-velocity";
    case ShownQuantity::kPeakForce:
      return "peak-force";
    case ShownQuantity::kRmsForce:
      return "rms-force";
    case ShownQuantity::kImpactRate:
      return "impact-rate";
    case ShownQuantity::kAmplitude:
      break;
  }
  return "amplitude";
}

bool is_of_stop(ShownQuantity quantity) {
  return quantity == ShownQuantity::kPeakForce || quantity == ShownQuantity::kRmsForce ||
         quantity == ShownQuantity::kImpactRate;
}

bool exists_at(ShownQuantity quantity, const MeasuredPlace& place) {
  if (is_of_stop(quantity)) return place.stop.has_value();
  return quantity != ShownQuantity::kPeakVelocity || !place.unit.ends_with("/s");
}

std::optional<double> shown_value(const Shown& shown, const std::vector<MeasuredPlace>& places,
                                  const Amplitudes& measured) {
  if (measured.rows.size() != places.size()) return {};
  if (!is_of_stop(shown.quantity)) return of_row(shown.quantity, measured.rows[shown.place]);
  const StopLoad& load = measured.stops[static_cast<std::size_t>(*places[shown.place].stop)];
  if (shown.quantity == ShownQuantity::kPeakForce) return load.peak_force;
  if (shown.quantity == ShownQuantity::kRmsForce) return load.rms_force;
  return static_cast<double>(load.impacts) / measured.duration;
}

std::string shown_title(const Shown& shown, const std::vector<MeasuredPlace>& places) {
  return std::string(words(shown.quantity)) + " at " + places[shown.place].name();
}

std::string shown_unit(const Shown& shown, const std::vector<MeasuredPlace>& places) {
  if (shown.quantity == ShownQuantity::kImpactRate) return "1/s";
  if (is_of_stop(shown.quantity)) return "N";
  const std::string& unit = places[shown.place].unit;
  if (shown.quantity != ShownQuantity::kPeakVelocity) return unit;
  return unit.empty() ? "1/s" : unit + "/s";
}

}  // namespace graze
