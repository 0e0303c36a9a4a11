#include "graze/flow/held/detail/generator_parts.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <list>
#include <mutex>
#include <string_view>

#include "graze/base/stop_scope.hpp"
#include "graze/flow/held/detail/first_order.hpp"

namespace graze {
namespace {

double certain_growth(const Matrix& generator) {
  double growth = 0.0;
  for (const Eigenvalue& l : eigenvalues(generator))
    if (l.value.real() > l.error) growth = std::max(growth, l.value.real());
  return growth;
}

// The coordinates in sets that no entry of the matrix couples, each ascending. Taken apart one by
// one they stay apart to the last digit: what is at rest beside motions that do not reach it is not
// moved by the rounding of a decomposition.
std::vector<std::vector<Eigen::Index>> uncoupled_sets(const Matrix& generator) {
  std::vector<std::vector<Eigen::Index>> sets;
  std::vector<bool> known(static_cast<std::size_t>(generator.rows()), false);
  for (Eigen::Index first = 0; first < generator.rows(); ++first) {
    if (known[static_cast<std::size_t>(first)]) continue;
    known[static_cast<std::size_t>(first)] = true;
    std::vector<Eigen::Index> set{first};
    for (std::size_t next = 0; next < set.size(); ++next)
      for (Eigen::Index i = 0; i < generator.rows(); ++i) {
        const bool meets = generator(i, set[next]) != 0.0 || generator(set[next], i) != 0.0;
        if (!meets || known[static_cast<std::size_t>(i)]) continue;
        known[static_cast<std::size_t>(i)] = true;
        set.push_back(i);
      }
    std::sort(set.begin(), set.end());
    sets.push_back(std::move(set));
  }
  return sets;
}

// The cache, latest first. Matrices are compared by their bits, so that a cached result is exactly
// the one that would be computed anew.
class Remembered {
 public:
  std::shared_ptr<const GeneratorParts> find(const Matrix& generator) {
    const std::size_t hash = hash_of(generator);
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
      return kept.hash == hash && bytes_of(kept.generator) == bytes_of(generator);
    });
    if (found == kept_.end()) return nullptr;
    kept_.splice(kept_.begin(), kept_, found);
    return found->parts;
  }

  // Two threads may have computed the same parts: either is good.
  void keep(const Matrix& generator, std::shared_ptr<const GeneratorParts> parts) {
    const std::lock_guard lock(mutex_);
    kept_.push_front({hash_of(generator), generator, std::move(parts)});
    numbers_ += numbers_in(generator);
    while (kept_.size() > kMostGenerators || numbers_ > kMostGeneratorNumbers) {
      numbers_ -= numbers_in(kept_.back().generator);
      kept_.pop_back();
    }
  }

 private:
  struct Kept {
    std::size_t hash;
    Matrix generator;
    std::shared_ptr<const GeneratorParts> parts;
  };
  static std::string_view bytes_of(const Matrix& matrix) {
    return {reinterpret_cast<const char*>(matrix.data()),
            static_cast<std::size_t>(matrix.size()) * sizeof(double)};
  }
  static std::size_t hash_of(const Matrix& matrix) {
    return std::hash<std::string_view>()(bytes_of(matrix));
  }
  // The matrix, the blocks' bases and coordinates, and at most two complex matrices of modes.
  static std::size_t numbers_in(const Matrix& matrix) {
    return 8 * static_cast<std::size_t>(matrix.size());
  }

  std::mutex mutex_;
  std::list<Kept> kept_;
  std::size_t numbers_ = 0;
};

}  // namespace

GeneratorParts take_apart(const Matrix& generator) {
  GeneratorParts apart{certain_growth(generator), {}};
  for (const std::vector<Eigen::Index>& set : uncoupled_sets(generator)) {
    for (InvariantBlock& block : invariant_blocks(generator(set, set), kLargestLoss)) {
      ComplexModes modes = complex_modes(block.matrix);
      const Eigen::Index n = generator.rows(), k = block.matrix.rows();
      InvariantBlock whole{std::move(block.matrix), Matrix::Zero(n, k), Matrix::Zero(k, n)};
      whole.basis(set, Eigen::all) = block.basis;
      whole.coordinates(Eigen::all, set) = block.coordinates;
      apart.parts.push_back({std::move(whole), std::move(modes)});
    }
  }
  return apart;
}

std::shared_ptr<const GeneratorParts> generator_parts(const Matrix& generator) {
  // Never destroyed: threads may still ask while the program ends.
  static auto& remembered = *new Remembered;
  if (auto parts = remembered.find(generator)) return parts;
  auto parts = std::make_shared<const GeneratorParts>(take_apart(generator));
  // Parts that were computed while it was asked to stop may be incomplete.
  if (!StopScope::current().requested()) remembered.keep(generator, parts);
  return parts;
}

}  // namespace graze
