// The rules for single numbers and lists of a scene.
#pragma once

#include <string>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// Largest size of a number: stiffnesses, energies and norms are made of squares, and the square of
// a larger one overflows.
inline constexpr double kLargestNumber = 0x1p511;  // 6.7e153

// A key is put together only where a rule is broken, since every step of a continuation checks its
// scene. Every function throws InputError about `table`.`key`.
class ValueChecker {
 public:
  // Refers to the scene.
  ValueChecker(const Scene& scene, std::string table);

  [[noreturn]] void fail(const std::string& key, const std::string& sentence) const;
  // "-1 is not allowed, it must be <what>" unless `kept`.
  void require(bool kept, const std::string& key, double value, const char* what) const;
  void finite(const char* key, double value) const;
  void positive(const char* key, double value) const;
  void not_negative(const char* key, double value) const;
  // Also of what is made of several numbers: "with it <what> is <value>" unless it has a size.
  void usable(const char* key, double value, const char* what) const;
  // As many finite numbers as there are modes.
  void entries(const char* key, const std::vector<double>& values, int modes,
               bool negative_allowed) const;

 private:
  void not_too_large(const std::string& key, double value) const;

  const Scene& scene_;
  std::string table_;
};

}  // namespace graze
