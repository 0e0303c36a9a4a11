// The words of results for a comparison.
#pragma once

#include <string>

#include "graze/record/study_records.hpp"

namespace graze {

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
// What both settle on: "both (1,1)", "different", "no start", ..
std::string cell_name(const ComparedCell& cell);

}  // namespace graze
