// A closed curve as a sequence of places that repeats its first one.
#pragma once

#include <algorithm>
#include <vector>

namespace graze {

// Rotates it to start outside, so that the start cuts no inner part in two.
template <class Place, class Outside>
void open_outside(std::vector<Place>& places, const Outside& is_outside) {
  const auto outside = std::find_if(places.begin(), places.end(), is_outside);
  if (outside == places.begin() || outside == places.end()) return;
  const auto offset = outside - places.begin();
  places.pop_back();  // repeats the first
  std::rotate(places.begin(), places.begin() + offset, places.end());
  places.push_back(places.front());
}

}  // namespace graze
