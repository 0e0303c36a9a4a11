#include "graze/scene/discrete_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/suggestion.hpp"
#include "graze/scene/value_checker.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Both ends of a spring that was checked.
std::array<int, 2> ends_of(const LumpedStructure& lumped, const std::vector<std::string>& between) {
  return {*mass_named(lumped, between[0]), *mass_named(lumped, between[1])};
}

// Adds what acts on the displacement of the first end relative to the second; the ground has none.
void add_between(Matrix& matrix, const std::array<int, 2>& ends, double value) {
  for (const int i : ends)
    if (i >= 0) matrix(i, i) += value;
  if (ends[0] < 0 || ends[1] < 0) return;
  matrix(ends[0], ends[1]) -= value;
  matrix(ends[1], ends[0]) -= value;
}

// The displacement at which friction acts, by the degrees of freedom.
Vector row_of(const Scene& scene, const DryFriction& friction, Index n) {
  Vector row = Vector::Zero(n);
  const auto add = [&](const std::string& text, double sign) {
    if (text.empty()) return;
    const std::optional<int> at = scene.lumped() ? mass_named(*scene.lumped(), text)
                                                 : std::optional(std::atoi(text.c_str()) - 1);
    if (at && *at >= 0 && *at < n) row[*at] += sign;
  };
  add(friction.node, 1.0);
  add(friction.against, -1.0);
  return row;
}

// With the springs beside friction, and with a coordinate for each spring in series: what rubs, by
// its displacement z against the ground or the other place. It is at rest or follows its place, so
// that its mass does not matter: it has that of the place.
DiscreteMatrices with_friction(const Scene& scene, const Scene& numbers, DiscreteMatrices all) {
  for (std::size_t k = 0; k < scene.frictions.size(); ++k) {
    const DryFriction &friction = scene.frictions[k], &number = numbers.frictions[k];
    Index n = all.mass.rows();
    Vector row = row_of(scene, friction, n);
    all.stiffness += number.parallel * row * row.transpose();
    if (friction.series == 0.0) continue;
    for (Matrix* matrix : {&all.mass, &all.damping, &all.stiffness}) {
      matrix->conservativeResize(n + 1, n + 1);
      matrix->row(n).setZero();
      matrix->col(n).setZero();
    }
    all.mass(n, n) = row.cwiseAbs2().dot(all.mass.diagonal().head(n));
    row.conservativeResize(n + 1);
    row[n] = -1.0;
    all.stiffness += number.series * row * row.transpose();
  }
  return all;
}

DiscreteMatrices of_masses(const LumpedStructure& lumped) {
  const auto n = static_cast<Index>(lumped.masses.size());
  DiscreteMatrices all{Matrix::Zero(n, n), Matrix::Zero(n, n), Matrix::Zero(n, n)};
  for (Index i = 0; i < n; ++i) all.mass(i, i) = lumped.masses[static_cast<std::size_t>(i)];
  for (const LumpedSpring& spring : lumped.springs) {
    const std::array<int, 2> ends = ends_of(lumped, spring.between);
    add_between(all.stiffness, ends, spring.stiffness);
    add_between(all.damping, ends, spring.damping);
  }
  for (const GyroscopicPair& pair : lumped.gyroscopic) {
    const auto [first, second] = ends_of(lumped, pair.between);
    all.damping(first, second) += pair.coefficient;
    all.damping(second, first) -= pair.coefficient;
  }
  return all;
}

Matrix of_rows(const MatrixEntries& rows, Index n, bool is_symmetric) {
  Matrix matrix = Matrix::Zero(n, n);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      matrix(static_cast<Index>(i), static_cast<Index>(j)) =
          is_symmetric && j < i ? rows[j][i] : rows[i][j];
  return matrix;
}

void check_names(const Scene& scene, const LumpedStructure& lumped) {
  if (lumped.masses.empty())
    throw scene_error(scene, "lumped.masses", "the list is empty, it must have a mass");
  if (lumped.names.empty()) return;
  if (lumped.names.size() != lumped.masses.size())
    throw scene_error(scene, "lumped.names",
                      fmt::format("the list has {} entries, it must have {}, one for each mass",
                                  lumped.names.size(), lumped.masses.size()));
  for (std::size_t k = 0; k < lumped.names.size(); ++k) {
    const auto found = mass_named(lumped, lumped.names[k]);
    if (found != static_cast<int>(k))
      throw scene_error(
          scene, fmt::format("lumped.names.{}", k + 1),
          fmt::format("\"{}\" names {} already", lumped.names[k],
                      *found < 0 ? "the ground" : fmt::format("mass {}", *found + 1)));
  }
}

void check_ends(const Scene& scene, const LumpedStructure& lumped, const std::string& path,
                const std::vector<std::string>& between, bool may_be_ground) {
  if (between.size() != 2)
    throw scene_error(scene, path,
                      fmt::format("the list has {} entries, it must have two", between.size()));
  for (std::size_t k = 0; k < 2; ++k) {
    const std::optional<int> end = mass_named(lumped, between[k]);
    if (end && (*end >= 0 || may_be_ground)) continue;
    throw scene_error(scene, fmt::format("{}.{}", path, k + 1),
                      mass_refusal(lumped, between[k], may_be_ground));
  }
  if (*mass_named(lumped, between[0]) == *mass_named(lumped, between[1]))
    throw scene_error(scene, path, "both ends are the same, they must be two");
}

void check_lumped(const Scene& scene, const LumpedStructure& lumped) {
  check_names(scene, lumped);
  const ValueChecker masses(scene, "lumped");
  for (std::size_t k = 0; k < lumped.masses.size(); ++k)
    masses.entry("masses", k + 1, lumped.masses[k], kPositive);
  for (std::size_t k = 0; k < lumped.springs.size(); ++k) {
    const std::string path = numbered_path("lumped.spring", k + 1);
    check_ends(scene, lumped, path + ".between", lumped.springs[k].between, true);
    const ValueChecker spring(scene, path);
    spring.number("stiffness", lumped.springs[k].stiffness, kNotNegative);
    spring.number("damping", lumped.springs[k].damping, kNotNegative);
  }
  for (std::size_t k = 0; k < lumped.gyroscopic.size(); ++k)
    check_ends(scene, lumped, numbered_path("lumped.gyroscopic", k + 1) + ".between",
               lumped.gyroscopic[k].between, false);
}

void check_rows(const Scene& scene, const MatrixStructure& matrices) {
  if (matrices.stiffness_entries.empty() || (!matrices.damping.empty()))
    throw scene_error(
        scene, matrices.stiffness_entries.empty() ? "matrices.stiffness" : "matrices.damping",
        "the mass stands in the scene, it must be a list of rows as well");
  const std::size_t n = matrices.mass_entries.size();
  for (const auto& [name, rows] : {std::pair("stiffness", &matrices.stiffness_entries),
                                   std::pair("damping", &matrices.damping_entries)})
    if (!rows->empty() && rows->size() != n)
      throw scene_error(
          scene, fmt::format("matrices.{}", name),
          fmt::format("the matrix has {} rows, it must have {} as the mass has", rows->size(), n));
}

}  // namespace

bool has_own_matrices(const Scene& scene) {
  const MatrixStructure* matrices = scene.matrices();
  return scene.lumped() || (matrices && !matrices->mass_entries.empty());
}

DiscreteMatrices discrete_matrices(const Scene& scene, const Scene& numbers) {
  if (numbers.lumped()) return with_friction(scene, numbers, of_masses(*numbers.lumped()));
  const MatrixStructure& matrices = *numbers.matrices();
  const auto n = static_cast<Index>(matrices.mass_entries.size());
  return with_friction(
      scene, numbers,
      {of_rows(matrices.mass_entries, n, true), of_rows(matrices.damping_entries, n, false),
       of_rows(matrices.stiffness_entries, n, true)});
}

int own_coordinates(const Scene& scene) {
  return static_cast<int>(scene.lumped() ? scene.lumped()->masses.size()
                                         : scene.matrices()->mass_entries.size());
}

DofLabel label_of_rubbing(const Scene& scene, std::size_t friction) {
  const auto before = scene.frictions.begin() + static_cast<std::ptrdiff_t>(friction);
  return {own_coordinates(scene) + 1 +
              std::count_if(scene.frictions.begin(), before,
                            [](const DryFriction& other) { return other.series > 0.0; }),
          kOfNoPlace};
}

std::optional<int> mass_named(const LumpedStructure& lumped, const std::string& text) {
  if (text == "0" || text == "ground") return -1;
  const auto name = std::find(lumped.names.begin(), lumped.names.end(), text);
  if (name != lumped.names.end()) return static_cast<int>(name - lumped.names.begin());
  // At most as many digits as a number of masses has.
  constexpr std::size_t kMostDigits = 6;
  const bool is_number = !text.empty() && text.size() <= kMostDigits && text.front() != '0' &&
                         text.find_first_not_of("0123456789") == std::string::npos;
  const int number = is_number ? std::stoi(text) : 0;
  if (number < 1 || number > static_cast<int>(lumped.masses.size())) return {};
  return number - 1;
}

std::array<double, 2> support_of(const Scene& scene, const HarmonicLoad& load) {
  const LumpedStructure& lumped = *scene.lumped();
  std::array<double, 2> sums{};
  const std::optional<int> mass = mass_named(lumped, load.at.node);
  for (const LumpedSpring& spring : lumped.springs) {
    const std::optional<int> first = mass_named(lumped, spring.between[0]),
                             second = mass_named(lumped, spring.between[1]);
    if (!(first == mass && second == -1) && !(first == -1 && second == mass)) continue;
    sums[0] += spring.stiffness;
    sums[1] += spring.damping;
  }
  return sums;
}

std::string mass_refusal(const LumpedStructure& lumped, const std::string& text,
                         bool may_be_ground) {
  const std::string meant = closest_name(text, lumped.names);
  return fmt::format("\"{}\" is not allowed, it must be {}a mass from 1 to {}{}{}", text,
                     may_be_ground ? "0 (the ground) or " : "", lumped.masses.size(),
                     lumped.names.empty() ? "" : " or the name of one",
                     meant.empty() ? "" : fmt::format("; did you mean {}?", meant));
}

void check_discrete(const Scene& scene) {
  if (scene.lumped()) check_lumped(scene, *scene.lumped());
  const MatrixStructure* matrices = scene.matrices();
  if (!matrices) return;
  if (!matrices->mass_entries.empty()) {
    check_rows(scene, *matrices);
    return;
  }
  if (!matrices->stiffness_entries.empty() || !matrices->damping_entries.empty())
    throw scene_error(
        scene, matrices->stiffness_entries.empty() ? "matrices.damping" : "matrices.stiffness",
        "the mass is in a file, it must be a file as well");
}

}  // namespace graze
