// Units in tables and sentences: none for a scene whose numbers are pure.
#pragma once

#include <string>

#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

class TextUnits {
 public:
  explicit TextUnits(Units units) : units_(units) {}

  // "m/s" or "".
  std::string operator()(const std::string& unit) const { return unit_in(units_, unit); }
  // "gap (m)"
  std::string head(const std::string& name, const std::string& unit) const {
    return with_unit(name, (*this)(unit));
  }
  // "0.0012 m"
  std::string quantity(double value, int digits, const std::string& unit) const {
    return quantity_text(value, digits, (*this)(unit));
  }

 private:
  Units units_;
};

}  // namespace graze
