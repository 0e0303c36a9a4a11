#include "graze/record/names/plane_names.hpp"

#include <limits>

#include "graze/record/names/motion_names.hpp"

namespace graze {

std::string name_of(MapQuantity quantity) {
  switch (quantity) {
    case MapQuantity::kAttractor:
      return "attractor";
    case MapQuantity::kImpacts:
      return "impacts";
    case MapQuantity::kExponent:
      return "exponent";
    case MapQuantity::kSpeed:
      return "speed";
    case MapQuantity::kMeasured:
      return "measured";
    case MapQuantity::kStuck:
      break;
  }
  return "stuck";
}

std::string title_of(MapQuantity quantity) {
  switch (quantity) {
    case MapQuantity::kAttractor:
      return "attractor";
    case MapQuantity::kImpacts:
      return "impacts a forcing period";
    case MapQuantity::kExponent:
      return "largest exponent";
    case MapQuantity::kSpeed:
      return "speed of the fastest impact";
    case MapQuantity::kMeasured:
      return "how large the motion is";
    case MapQuantity::kStuck:
      break;
  }
  return "part of the time at rest on a stop";
}

std::string unit_of(MapQuantity quantity) {
  if (quantity == MapQuantity::kExponent) return "1/s";
  return quantity == MapQuantity::kSpeed ? "m/s" : "";
}

namespace {

// `label` of the attractor's class, with a letter where there are several of it.
std::string numbered(const AttractorMap& map, std::size_t attractor, const std::string& label) {
  const AttractorClass& own = map.attractors[attractor].attractor;
  std::size_t before = 0, all = 0;
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    if (map.attractors[i].attractor != own) continue;
    ++all;
    if (i < attractor) ++before;
  }
  if (all == 1) return label;
  return label + " " +
         (before < 26 ? std::string(1, static_cast<char>('a' + before))
                      : std::to_string(before + 1));
}

}  // namespace

std::string attractor_name(const AttractorMap& map, std::size_t attractor) {
  return numbered(map, attractor, attractor_label(map.attractors[attractor].attractor));
}

std::string attractor_title(const AttractorMap& map, std::size_t attractor) {
  return numbered(map, attractor, attractor_title(map.attractors[attractor].attractor));
}

std::string cell_name(const AttractorMap& map, const MapCell& cell) {
  if (!cell.is_known) return "not run";
  return cell.place >= 0 ? attractor_title(map, static_cast<std::size_t>(cell.place))
                         : attractor_title(cell.attractor);
}

bool is_clear(const MapCell& cell) {
  return cell.is_known && cell.attractor.period > 0 && attractor_kind(cell.attractor) == "clear";
}

double cell_value(const MapCell& cell, MapQuantity quantity) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!cell.is_known || cell.attractor.status == SweepStatus::kNoStart) return kNone;
  switch (quantity) {
    case MapQuantity::kAttractor:
      return cell.place;
    case MapQuantity::kImpacts:
      return cell.impacts_per_period.value_or(kNone);
    case MapQuantity::kExponent:
      return cell.exponent.value_or(kNone);
    case MapQuantity::kSpeed:
      return cell.peak_speed;
    case MapQuantity::kStuck:
      return cell.stuck_part;
    case MapQuantity::kMeasured:
      break;
  }
  return kNone;
}

DrawnQuantity drawn_quantity(const MapRecord& record, MapQuantity quantity) {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (quantity == MapQuantity::kMeasured)
    return {shown_title(*record.measured, record.places),
            unit_in(record.info.units, shown_unit(*record.measured, record.places)),
            [&record](const MapCell& cell) {
              if (!cell.amplitudes) return kNone;
              return shown_value(*record.measured, record.places, *cell.amplitudes).value_or(kNone);
            }};
  return {title_of(quantity), unit_in(record.info.units, unit_of(quantity)),
          [quantity](const MapCell& cell) {
            const bool blank = quantity == MapQuantity::kSpeed && is_clear(cell);
            return blank ? kNone : cell_value(cell, quantity);
          }};
}

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
  return "energy lost at the stops, relative difference";
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
  if (!is_comparable(cell)) return attractor_title(has_attractor(cell.one) ? cell.other : cell.one);
  return cell.difference.is_same_attractor ? "both " + attractor_title(cell.one) : "different";
}

}  // namespace graze
