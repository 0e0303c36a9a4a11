// The generator of a linear system x' = A x split into parts, once for all systems that share it:
// the costly decomposition of coupled modes depends on A alone, not on loads, forcing or gaps. The
// cells of a map, the systems of a continuation over those, and all their motions share it.
#pragma once

#include <memory>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/invariant_blocks.hpp"

namespace graze {

struct GeneratorPart {
  InvariantBlock block;
  ComplexModes modes;  // of the block's matrix
};

struct GeneratorParts {
  double growth = 0.0;  // 1/s: largest growth beyond the error of its eigenvalue; 0: none grows
  std::vector<GeneratorPart> parts;
};

// The parts of a square matrix, computed anew.
GeneratorParts take_apart(const Matrix& generator);

// The same, bit for bit, from a cache that all threads share; it keeps the latest matrices, as many
// as kMostGenerators and kMostGeneratorNumbers allow.
std::shared_ptr<const GeneratorParts> generator_parts(const Matrix& generator);
inline constexpr std::size_t kMostGenerators = 64;
inline constexpr std::size_t kMostGeneratorNumbers = std::size_t{1} << 22;  // in all, 32 MB

}  // namespace graze
