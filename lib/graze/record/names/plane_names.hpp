// The words of results for planes: maps and comparisons.
#pragma once

#include <functional>
#include <string>

#include "graze/record/study_records.hpp"

namespace graze {

inline constexpr MapQuantity kMapQuantities[] = {MapQuantity::kAttractor, MapQuantity::kImpacts,
                                                 MapQuantity::kExponent, MapQuantity::kSpeed,
                                                 MapQuantity::kStuck};

// "attractor", "impacts", "exponent", "speed", "stuck".
std::string name_of(MapQuantity quantity);

// "largest exponent" and its unit "1/s", ..
std::string title_of(MapQuantity quantity);
std::string unit_of(MapQuantity quantity);

// "(1,1)", or "(1,1) b" for the second of several of the same class.
std::string attractor_name(const AttractorMap& map, std::size_t attractor);
// The same for tables and pictures: "no impact" in place of "clear".
std::string attractor_title(const AttractorMap& map, std::size_t attractor);

// The name of a cell's motion in tables and pictures: "(2,1)", "no impact", "no start", ..
std::string cell_name(const AttractorMap& map, const MapCell& cell);

// Whether the settled motion of the cell meets no stop.
bool is_clear(const MapCell& cell);

// A quantity of a cell as a number; not finite where it has none.
double cell_value(const MapCell& cell, MapQuantity quantity);

// The quantity that a picture shows of cells: not finite where there is none, as a speed where no
// stop is met. Refers to the record.
struct DrawnQuantity {
  std::string title, unit;  // SI
  std::function<double(const MapCell&)> of;
};
DrawnQuantity drawn_quantity(const MapRecord& record, MapQuantity quantity);

// The words of results for a comparison.

inline constexpr ComparedQuantity kComparedQuantities[] = {
    ComparedQuantity::kAttractor,  ComparedQuantity::kAgreeing,     ComparedQuantity::kFirstTime,
    ComparedQuantity::kFirstSpeed, ComparedQuantity::kDisplacement, ComparedQuantity::kVelocity,
    ComparedQuantity::kEnergy,     ComparedQuantity::kTaken};

// "attractor", "agreeing", "first_time", ..
std::string name_of(ComparedQuantity quantity);
// A short description: "mean energy, relative difference".
std::string title_of(ComparedQuantity quantity);
// Whether it is a difference with a sign.
bool is_signed(ComparedQuantity quantity);

// The value as a number; for an attractor 1 if it is the same, else 0. Not finite where there is
// none.
double compared_value(const MotionDifference& difference, ComparedQuantity quantity);

// Whether the cell was run and both of its motions have an attractor.
bool is_comparable(const ComparedCell& cell);
// What both settle on, likewise: "both (1,1)", "different", "no start", ..
std::string cell_name(const ComparedCell& cell);

}  // namespace graze
