// The orders in which an orbit can meet its stops.
#pragma once

#include <vector>

namespace graze {

struct ImpactSequences {
  std::vector<std::vector<int>> sequences;  // each of k stops (index from 0), in dictionary order
  bool complete = true;                     // whether none was left out
};

// All sequences of k stops out of `stops`, each class of rotations once, as its smallest rotation;
// at most `most` of them. (Fredricksen, Kessler & Maiorana's generation of necklaces: J. Combin.
// Theory B 24, 1978.)
ImpactSequences impact_sequences(int stops, int k, std::size_t most);

}  // namespace graze
