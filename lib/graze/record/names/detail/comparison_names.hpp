// The words in which results speak of a comparison.
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
// In a few words: "mean energy, relative difference".
std::string title_of(ComparedQuantity quantity);
// Whether it is a difference with a sign.
bool is_signed(ComparedQuantity quantity);

// As a number; of an attractor 1 where it is the same, else 0. Not finite where there is none.
double compared_value(const MotionDifference& difference, ComparedQuantity quantity);

// Whether both motions of a cell settle on, or keep to, something.
bool is_comparable(const ComparedCell& cell);
// Of what both settle on: "both (1,1)", "different", "no start", ..
std::string cell_name(const ComparedCell& cell);

}  // namespace graze
