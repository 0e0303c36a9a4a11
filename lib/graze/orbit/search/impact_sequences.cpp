#include "graze/orbit/search/detail/impact_sequences.hpp"

namespace graze {

ImpactSequences impact_sequences(int stops, int k, std::size_t most) {
  ImpactSequences result;
  const auto length = static_cast<std::size_t>(k);
  std::vector<int> word(length, 0);
  // `word` runs through the prefixes of necklaces, in dictionary order; it is a necklace itself
  // when the length of its shortest period divides k.
  for (std::size_t head = 1; head > 0;) {
    if (length % head == 0) {
      if (result.sequences.size() == most) {
        result.complete = false;
        return result;
      }
      result.sequences.push_back(word);
    }
    // The next one: raise the last letter that can be raised, and repeat from there.
    head = length;
    while (head > 0 && word[head - 1] == stops - 1) --head;
    if (head == 0) break;
    ++word[head - 1];
    for (std::size_t i = head; i < length; ++i) word[i] = word[i - head];
  }
  return result;
}

}  // namespace graze
