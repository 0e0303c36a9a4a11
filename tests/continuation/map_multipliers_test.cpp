// Multipliers of periodic points of maps, where those of one turn differ widely in size.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "graze/continuation/map.hpp"

namespace graze {
namespace {

// Determinant 1 and trace t: multipliers m and 1 / m, m = (t + sqrt(t^2 - 4)) / 2.
Matrix slope() { return Matrix{{10000.0, 1.0}, {19999.0, 2.0}}; }

// Of p turns: m^p and m^-p. The formed product of two turns carries a rounding error of about
// eps m^2 = 2e-8 in its entries, twice the small multiplier. From the factors it is known to their
// rounding: relative error about eps p |A| |x| |y| / (1 / m) = p eps m^2 = p 2e-8, with |x| |y| of
// about 1; a hundred times that leaves room for the bound's factors n and |y| |x|.
void expect_powers(const std::vector<Eigenvalue>& list, int turns) {
  ASSERT_EQ(list.size(), 2u);
  const double trace = slope().trace();
  const double large = std::pow(0.5 * (trace + std::sqrt(trace * trace - 4.0)), turns);
  const double small = 1.0 / large, most = 2e-6 * turns * small;
  EXPECT_LE(std::abs(list[0].value - large), list[0].error);
  EXPECT_LE(std::abs(list[1].value - small), list[1].error);
  EXPECT_LE(list[1].error, most) << turns << " turns";
  EXPECT_NE(list[1].error, 0.0);
}

TEST(MapMultipliers, SmallOnesOfManyTurnsAreKnownToTheRoundingOfOneTurn) {
  const Map map{[](const Vector& x, Parameters) -> std::optional<MapEvaluation> {
    return MapEvaluation{slope() * x, slope(), Vector::Zero(2)};
  }};
  for (const int turns : {2, 3, 8})
    expect_powers(periodic_points(map, turns)
                      .multipliers(Vector::Zero(2 * turns), std::array{0.0}, ErrorBounds::kGiven),
                  turns);
}

TEST(MapMultipliers, SmallOnesOfManyTurnsOverAPlaneLikewise) {
  Map map;
  map.evaluate = [](const Vector& x, Parameters) -> std::optional<MapEvaluation> {
    return MapEvaluation{slope() * x, slope(), Matrix::Zero(2, 2)};
  };
  for (const int turns : {2, 3, 8})
    expect_powers(
        periodic_points(map, turns)
            .multipliers(Vector::Zero(2 * turns), std::array{0.0, 0.0}, ErrorBounds::kGiven),
        turns);
}

}  // namespace
}  // namespace graze
