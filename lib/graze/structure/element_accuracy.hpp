// How well modes that are found by elements are resolved.
#pragma once

namespace graze {

// How the modes of a beam, a string or a bar without a closed form were found.
struct ElementAccuracy {
  int elements = 0;
  int order = 0;  // degree of the shapes on an element
  int rigid = 0;  // modes that are rigid motions, of frequency 0
  // The largest relative change of a frequency by the last refinement: of modes 1 to 32, and of
  // those beyond (0 without any).
  double change = 0.0, change_beyond = 0.0;
};

}  // namespace graze
