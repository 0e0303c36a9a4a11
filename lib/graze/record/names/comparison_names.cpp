#include "graze/record/names/detail/comparison_names.hpp"

#include <limits>

#include "graze/record/names/detail/sweep_names.hpp"

namespace graze {
namespace {

bool has_attractor(const AttractorClass& attractor) {
  return attractor.status == SweepStatus::kSettled || attractor.status == SweepStatus::kNotPeriodic;
}

}  // namespace

std::string name_of(ComparedQuantity quantity) {
  switch (quantity) {
    case ComparedQuantity::kAttractor:
      return "attractor";
    case ComparedQuantity::kAgreeing:
      return "agreeing";
    case ComparedQuantity::kFirstTime:
      return "first_time";
    case ComparedQuantity::kFirstSpeed:
      return "first_speed";
    case ComparedQuantity::kDisplacement:
      return "displacement";
    case ComparedQuantity::kVelocity:
      return "velocity";
    case ComparedQuantity::kEnergy:
      return "energy";
    case ComparedQuantity::kTaken:
      break;
  }
  return "taken";
}

std::string title_of(ComparedQuantity quantity) {
  switch (quantity) {
    case ComparedQuantity::kAttractor:
      return "settles on the same";
    case ComparedQuantity::kAgreeing:
      return "first impacts that agree";
    case ComparedQuantity::kFirstTime:
      return "time of the first impact, difference / forcing period";
    case ComparedQuantity::kFirstSpeed:
      return "speed of the first impact, relative difference";
    case ComparedQuantity::kDisplacement:
      return "displacement, rms difference / rms";
    case ComparedQuantity::kVelocity:
      return "velocity, rms difference / rms";
    case ComparedQuantity::kEnergy:
      return "mean energy, relative difference";
    case ComparedQuantity::kTaken:
      break;
  }
  return "energy taken by the stops, relative difference";
}

bool is_signed(ComparedQuantity quantity) {
  return quantity == ComparedQuantity::kFirstTime || quantity == ComparedQuantity::kFirstSpeed ||
         quantity == ComparedQuantity::kEnergy || quantity == ComparedQuantity::kTaken;
}

double compared_value(const MotionDifference& difference, ComparedQuantity quantity) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  switch (quantity) {
    case ComparedQuantity::kAttractor:
      return difference.is_same_attractor ? 1.0 : 0.0;
    case ComparedQuantity::kAgreeing:
      return difference.first > 0 ? difference.agreeing : kNone;
    case ComparedQuantity::kFirstTime:
      return difference.first_time.value_or(kNone);
    case ComparedQuantity::kFirstSpeed:
      return difference.first_speed.value_or(kNone);
    case ComparedQuantity::kDisplacement:
      return difference.displacement.value_or(kNone);
    case ComparedQuantity::kVelocity:
      return difference.velocity.value_or(kNone);
    case ComparedQuantity::kEnergy:
      return difference.energy.value_or(kNone);
    case ComparedQuantity::kTaken:
      break;
  }
  return difference.taken.value_or(kNone);
}

bool is_comparable(const ComparedCell& cell) {
  return cell.is_known && has_attractor(cell.one) && has_attractor(cell.other);
}

std::string cell_name(const ComparedCell& cell) {
  if (!cell.is_known) return "not run";
  if (!is_comparable(cell)) return attractor_label(has_attractor(cell.one) ? cell.other : cell.one);
  return cell.difference.is_same_attractor ? "both " + attractor_label(cell.one) : "different";
}

}  // namespace graze
