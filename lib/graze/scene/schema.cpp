#include "graze/scene/detail/schema.hpp"

namespace graze {

// Two radii are those of balls; four those in two planes at right angles, body by body.
std::vector<double> body_numbers(const SpringGeometry& geometry, BodyNumbers which) {
  std::vector<double> numbers;
  for (const ElasticBody& body : geometry.bodies) {
    if (which == BodyNumbers::kRadii)
      numbers.insert(numbers.end(), body.radii.begin(), body.radii.end());
    else
      numbers.push_back(which == BodyNumbers::kModuli ? body.modulus : body.poisson_ratio);
  }
  return numbers;
}

bool set_body_numbers(SpringGeometry& geometry, BodyNumbers which,
                      const std::vector<double>& numbers) {
  const bool four = which == BodyNumbers::kRadii && numbers.size() == 4;
  if (numbers.size() != 2 && !four) return false;
  for (std::size_t k = 0; k < 2; ++k) {
    ElasticBody& body = geometry.bodies[k];
    switch (which) {
      case BodyNumbers::kRadii:
        body.radii = {numbers[four ? 2 * k : k], numbers[four ? 2 * k + 1 : k]};
        break;
      case BodyNumbers::kModuli:
        body.modulus = numbers[k];
        break;
      case BodyNumbers::kPoissonRatios:
        body.poisson_ratio = numbers[k];
    }
  }
  return true;
}

}  // namespace graze
