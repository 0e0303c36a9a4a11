// Decompositions of coupled modes, shared by all that have the same generator.
#include "graze/flow/held/detail/generator_parts.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/flow/sprung/detail/linear_spring_phase.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

// A damped oscillator beside another, weakly coupled; `stiffness` of the first.
Matrix generator_of(double stiffness) {
  return Matrix{{0.0, 0.0, 1.0, 0.0},
                {0.0, 0.0, 0.0, 1.0},
                {-stiffness, 0.3, -0.1, 0.02},
                {0.3, -9.0, 0.02, -0.2}};
}

void expect_same(const GeneratorParts& a, const GeneratorParts& b) {
  EXPECT_EQ(a.growth, b.growth);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    EXPECT_EQ(a.parts[i].block.matrix, b.parts[i].block.matrix);
    EXPECT_EQ(a.parts[i].block.basis, b.parts[i].block.basis);
    EXPECT_EQ(a.parts[i].block.coordinates, b.parts[i].block.coordinates);
    EXPECT_EQ(a.parts[i].modes.values, b.parts[i].modes.values);
    EXPECT_EQ(a.parts[i].modes.vectors, b.parts[i].modes.vectors);
  }
}

// Two oscillators that are coupled to each other, and between their coordinates two that are not:
// in the parts of either all else is zero, and together the parts are the generator.
TEST(GeneratorParts, OfCoordinatesThatNothingCouplesStayApart) {
  Matrix generator = Matrix::Zero(8, 8);  // displacements 1 to 4, velocities 1 to 4
  generator.topRightCorner(4, 4).setIdentity();
  generator.bottomLeftCorner(4, 4).diagonal() = Vector{{-2.0, -3.0, -5.0, -7.0}};
  generator(4, 2) = generator(6, 0) = 1.5;
  generator.bottomRightCorner(4, 4).diagonal().setConstant(-0.1);
  const auto set_of = [](Eigen::Index i) { return i % 4 == 0 || i % 4 == 2 ? 0 : i % 4; };
  Matrix sum = Matrix::Zero(8, 8);
  for (const GeneratorPart& part : take_apart(generator).parts) {
    const auto& [matrix, basis, coordinates] = part.block;
    sum += basis * matrix * coordinates;
    Eigen::Index first = 0;
    basis.rowwise().norm().maxCoeff(&first);
    for (Eigen::Index i = 0; i < 8; ++i) {
      if (set_of(i) == set_of(first)) continue;
      EXPECT_TRUE((basis.row(i).array() == 0.0).all() && (coordinates.col(i).array() == 0.0).all());
    }
  }
  EXPECT_LE((sum - generator).norm(), 1e-13);
}

TEST(GeneratorParts, AreFoundOnce) {
  const auto first = generator_parts(generator_of(4.0));
  EXPECT_EQ(generator_parts(generator_of(4.0)), first);
  EXPECT_NE(generator_parts(generator_of(4.0000000000000009)), first);
  expect_same(*first, take_apart(generator_of(4.0)));
  // A V = V T of every part.
  for (const GeneratorPart& part : first->parts)
    EXPECT_LT((generator_of(4.0) * part.block.basis - part.block.basis * part.block.matrix).norm(),
              1e-13);
}

TEST(GeneratorParts, OnlySoManyAreRemembered) {
  const std::weak_ptr<const GeneratorParts> first = generator_parts(generator_of(5.0));
  for (std::size_t i = 0; i + 1 < kMostGenerators; ++i)
    generator_parts(generator_of(6.0 + 0.01 * static_cast<double>(i)));
  EXPECT_FALSE(first.expired());
  generator_parts(generator_of(7.5));
  EXPECT_TRUE(first.expired());
}

TEST(GeneratorParts, AreTheSameForAllThreads) {
  std::vector<std::thread> threads;
  std::vector<std::vector<std::shared_ptr<const GeneratorParts>>> found(4);
  for (auto& own : found)
    threads.emplace_back([&own] {
      for (int i = 0; i < 200; ++i) own.push_back(generator_parts(generator_of(10.0 + i % 80)));
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& own : found)
    for (int i = 0; i < 200; ++i)
      expect_same(*own[static_cast<std::size_t>(i)], take_apart(generator_of(10.0 + i % 80)));
}

// What a map moves most often, gap and forcing, leaves the structure on its spring as it was; the
// stiffness of the spring does not.
TEST(GeneratorParts, AreSharedByCellsOfTheSameStructure) {
  PhaseKey key;
  key.springs.loaded = {0};
  const auto parts = [&](const std::vector<std::string>& settings) {
    const System system = assemble(support::shipped_scene("13_beam_on_a_spring", settings));
    const LinearSpringPhase phase(system, key);
    return generator_parts(phase.coupled_arc()->flow().first_order().generator);
  };
  const auto whole = parts({});
  EXPECT_EQ(parts({"stop.gap=1.3e-3"}), whole);
  EXPECT_EQ(parts({"forcing.frequency=35.0"}), whole);
  EXPECT_EQ(parts({"forcing.amplitude=0.001"}), whole);
  EXPECT_NE(parts({"stop.spring.stiffness=2e7"}), whole);
}

}  // namespace
}  // namespace graze
