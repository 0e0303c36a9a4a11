// The rules for single numbers and lists of a scene.
#pragma once

#include <string>
#include <vector>

#include "graze/scene/key.hpp"
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
  // "-1 is not allowed, it must be <what>".
  [[noreturn]] void refuse(const std::string& key, double value, const std::string& what) const;
  // Also rejects numbers that are too large.
  void number(const char* key, double value, const Range& range) const;
  // The entry of a list, counted from 1.
  void entry(const char* key, std::size_t k, double value, const Range& range) const;
  // For a value made of several numbers: "with it <what> is <value>" unless it is a usable number.
  void usable(const char* key, double value, const char* what) const;
  // As many numbers as there are modes.
  void entries(const char* key, const std::vector<double>& values, int modes,
               const Range& range) const;

 private:
  [[noreturn]] void refuse_number(const std::string& key, double value, const Range& range) const;

  const Scene& scene_;
  std::string table_;
};

}  // namespace graze
