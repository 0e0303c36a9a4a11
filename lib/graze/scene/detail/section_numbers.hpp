// Area and second moment of sections, of numbers or of polynomials along a piece.
#pragma once

#include <numbers>

#include "graze/scene/structures.hpp"

namespace graze {

template <class Number>
struct SectionNumbers {
  Number area, second_moment;  // m^2, m^4
};

inline double scaled(double factor, double number) { return factor * number; }

// `length(taper)`: a length of the section as a Number, which can be multiplied and subtracted.
template <class Number>
SectionNumbers<Number> section_numbers(const Section& section, auto&& length) {
  if (section.shape == SectionShape::kRectangle) {
    const Number width = length(&Section::width), height = length(&Section::height);
    return {width * height, scaled(1.0 / 12.0, width * height * height * height)};
  }
  const auto square = [&](auto which) {
    const Number diameter = length(which);
    return diameter * diameter;
  };
  const Number outer = square(&Section::diameter);
  Number area = outer, moment = outer * outer;
  if (section.shape == SectionShape::kTube) {
    const Number inner = square(&Section::inner_diameter);
    area = outer - inner;
    moment = moment - inner * inner;
  }
  return {scaled(std::numbers::pi / 4.0, area), scaled(std::numbers::pi / 64.0, moment)};
}

// Of a section that does not taper, or at its left end.
inline SectionNumbers<double> section_numbers(const Section& section) {
  return section_numbers<double>(section, [&](auto which) { return (section.*which).front(); });
}

}  // namespace graze
