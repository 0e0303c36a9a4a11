// Random choices that are the same everywhere for the same seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace graze {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  // One of 0 .. count - 1; 0 of none.
  std::size_t below(std::size_t count) {
    return count == 0 ? 0 : static_cast<std::size_t>(engine_() % count);
  }
  // True once in `times`.
  bool once_in(std::size_t times) { return below(times) == 0; }
  // One of a list that is not empty.
  template <class Item>
  const Item& of(const std::vector<Item>& list) {
    return list[below(list.size())];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace graze
