// Motions flown side by side in lanes are those that are followed one by one: the same impacts at
// the same stops, at the same phases and speeds to the rounding that the motion itself lets grow.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <random>

#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/motion/lanes/detail/lane_motions.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

struct Cell {
  System system;
  State start;
};

// Underdamped modes at most 40 times apart; one to three stops on either side, some of them near
// each other; restitution from weak to none lost; start anywhere between the stops. So many
// harmonics beside the first, which is then missing at times.
Cell random_cell(std::mt19937_64& random, int harmonics = 0) {
  const auto number = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto index = [&](int from, int to) {
    return std::uniform_int_distribution<int>(from, to)(random);
  };
  const int modes = index(1, 4), stops = index(1, 3);
  Cell cell;
  cell.system.omega.resize(modes);
  Vector delta(modes);
  for (int j = 0; j < modes; ++j) {
    cell.system.omega[j] = std::exp(number(0.0, std::log(40.0)));
    delta[j] = index(0, 3) == 0 ? 0.0 : cell.system.omega[j] * std::exp(number(-7.0, -0.7));
  }
  std::sort(cell.system.omega.begin(), cell.system.omega.end());
  NaturalModes natural{
      delta, HarmonicForcing{number(0.3, 3.0), number(-3.0, 3.0), Vector(modes)}, {}};
  for (int j = 0; j < modes; ++j) natural.forcing->amplitude[j] = number(-4.0, 4.0);
  if (index(0, 2) == 0) {
    natural.load = Vector(modes);
    for (int j = 0; j < modes; ++j) (*natural.load)[j] = number(-1.0, 1.0);
  }
  if (harmonics > 0 && index(0, 3) == 0) natural.forcing->amplitude.setZero();
  for (int k = 0; k < harmonics; ++k) {
    Vector cosine(modes), sine(modes);
    for (int j = 0; j < modes; ++j) {
      cosine[j] = number(-3.0, 3.0);
      sine[j] = number(-3.0, 3.0);
    }
    natural.forcing->harmonics.push_back({double(index(2, 7)), cosine, sine});
  }
  cell.system.structure = natural;
  for (int i = 0; i < stops; ++i) {
    Vector row(modes);
    for (int j = 0; j < modes; ++j) row[j] = number(-1.0, 1.0);
    Vector direction = row / row.squaredNorm();
    if (modes > 1 && index(0, 2) == 0) {  // an oblique law
      direction[0] += 0.2;
      direction /= row.dot(direction);
    }
    cell.system.stops.push_back({row, number(0.01, 0.4), ImpactLaw{direction, number(0.3, 0.95)}});
  }
  // At rest at zero, no gap being negative.
  cell.start = {Vector::Zero(modes), Vector::Zero(modes)};
  for (int j = 0; j < modes; ++j) cell.start.qdot[j] = number(-1.0, 1.0);
  return cell;
}

SettleOptions whole_run(long long periods) {
  SettleOptions options;
  options.periods = options.tail = periods;
  options.longest_period = 0;  // looks for no repetition
  options.nearness = 0.0;
  options.max_impacts = 400;
  return options;
}

class Cells : public SettleTasks {
 public:
  Cells(const std::deque<Cell>& cells, const SettleOptions& options)
      : cells_(cells), options_(options), motions(cells.size()), at_(kLanes) {}
  std::optional<SettleTask> next(std::size_t place) override {
    if (given_ == cells_.size()) return {};
    at_[place] = given_;
    const Cell& cell = cells_[given_++];
    return SettleTask{&cell.system, cell.start, options_};
  }
  void take(std::size_t place, SettledMotion motion) override {
    motions[at_[place]] = std::move(motion);
  }

 private:
  const std::deque<Cell>& cells_;
  SettleOptions options_;

 public:
  std::vector<SettledMotion> motions;

 private:
  std::vector<std::size_t> at_;
  std::size_t given_ = 0;
};

// By how much at most a deviation has grown, impact by impact: at an approach speed v its instant
// moves by as much over v, in which the motion turns by its accelerations.
double growth(const System& system, const SettledMotion& motion) {
  const MotionScale scale = motion_scale(system);
  double grown = 1.0;
  for (const MetImpact& impact : motion.impacts)
    grown *=
        1.0 + 2.0 * scale.velocity.maxCoeff() / scale.displacement * scale.length / impact.speed;
  return grown;
}

struct Compared {
  int told = 0, rounded = 0, in_lanes = 0, impacts = 0;
};

void compare(const Cell& cell, const SettledMotion& alone, const SettledMotion& beside,
             Compared& compared) {
  // Alone, several harmonics are followed by exponentials of matrices, which round by the angle of
  // the quickest mode.
  double rounding = 1e-13;
  if (cell.system.harmonics())
    rounding += 4.0 * std::numeric_limits<double>::epsilon() * cell.system.omega.maxCoeff() *
                cell.system.period() * static_cast<double>(alone.periods);
  const double allowed = rounding * growth(cell.system, alone);
  if (alone.kind != SettledKind::kNotPeriodic || !(allowed < 1e-4)) {
    ++compared.rounded;  // hits so slowly or so often that nothing is to be told
    return;
  }
  ++compared.told;
  EXPECT_EQ(beside.kind, alone.kind);
  EXPECT_EQ(beside.periods, alone.periods);
  ASSERT_EQ(beside.impacts.size(), alone.impacts.size());
  const MotionScale scale = motion_scale(cell.system);
  for (std::size_t i = 0; i < alone.impacts.size(); ++i) {
    const MetImpact &a = alone.impacts[i], &b = beside.impacts[i];
    EXPECT_EQ(b.stop, a.stop);
    EXPECT_EQ(b.period, a.period);
    EXPECT_NEAR(b.phase, a.phase, allowed);
    EXPECT_NEAR(b.speed, a.speed, allowed * scale.velocity.maxCoeff());
  }
  compared.impacts += static_cast<int>(alone.impacts.size());
  ASSERT_EQ(beside.period_states.size(), alone.period_states.size());
  for (std::size_t n = 0; n < alone.period_states.size(); ++n) {
    const State &a = alone.period_states[n], &b = beside.period_states[n];
    EXPECT_LE((b.q - a.q).cwiseAbs().maxCoeff(), allowed * scale.displacement);
    EXPECT_LE((b.qdot - a.qdot).cwiseQuotient(scale.velocity).cwiseAbs().maxCoeff(), allowed);
  }
}

Compared compare_random_cells(int count, int harmonics) {
  std::mt19937_64 random(2026);
  std::deque<Cell> all;
  for (int i = 0; i < count; ++i) all.push_back(random_cell(random, harmonics));
  // Lanes fly systems of one shape side by side.
  Compared compared;
  for (int modes = 1; modes <= 4; ++modes)
    for (std::size_t stops = 1; stops <= 3; ++stops) {
      std::deque<Cell> cells;
      for (const Cell& cell : all)
        if (cell.system.modes() == modes && cell.system.stops.size() == stops)
          cells.push_back(cell);
      const SettleOptions options = whole_run(3);
      Cells tasks(cells, options);
      settle_side_by_side(tasks);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        SCOPED_TRACE("modes " + std::to_string(modes) + " stops " + std::to_string(stops) +
                     " cell " + std::to_string(i));
        if (lane_form(cells[i].system, ExactFlow<double>(cells[i].system))) ++compared.in_lanes;
        compare(cells[i], settle(cells[i].system, cells[i].start, options), tasks.motions[i],
                compared);
        if (testing::Test::HasFatalFailure()) return compared;
      }
    }
  return compared;
}

TEST(SideBySide, IsTheMotionThatIsFollowedAlone) {
  const Compared compared = compare_random_cells(10000, 0);
  EXPECT_GT(compared.in_lanes, 8000);
  EXPECT_GT(compared.told, 5000);
  EXPECT_GT(compared.impacts, 8000);
}

TEST(SideBySide, IsThatOfSeveralHarmonics) {
  for (const int harmonics : {1, 3}) {
    const Compared compared = compare_random_cells(1500, harmonics);
    EXPECT_GT(compared.in_lanes, 1000);
    EXPECT_GT(compared.told, 500);
    EXPECT_GT(compared.impacts, 1000);
  }
}

void expect_equal(const SettledMotion& a, const SettledMotion& b) {
  EXPECT_EQ(a.classification, b.classification);
  ASSERT_EQ(a.period_states.size(), b.period_states.size());
  for (std::size_t n = 0; n < a.period_states.size(); ++n) {
    EXPECT_TRUE((a.period_states[n].q.array() == b.period_states[n].q.array()).all());
    EXPECT_TRUE((a.period_states[n].qdot.array() == b.period_states[n].qdot.array()).all());
  }
}

// Squares of these leave the range of the numbers.
TEST(SideBySide, MissesNoImpactWhereSquaresUnderflow) {
  for (const double scale : {1e-170, 1e-155, 1e150}) {
    std::mt19937_64 random(3);
    std::deque<Cell> cells;
    while (cells.size() < 60) {
      Cell cell = random_cell(random);
      if (cell.system.modes() != 2 || cell.system.stops.size() != 2) continue;
      cell.system.modal().forcing->amplitude *= scale;
      if (cell.system.load()) *cell.system.modal().load *= scale;
      for (Stop& stop : cell.system.stops) stop.gap *= scale;
      cell.start.qdot *= scale;
      cells.push_back(cell);
    }
    const SettleOptions options = whole_run(2);
    Cells tasks(cells, options);
    settle_side_by_side(tasks);
    Compared compared;
    for (std::size_t i = 0; i < cells.size(); ++i)
      compare(cells[i], settle(cells[i].system, cells[i].start, options), tasks.motions[i],
              compared);
    EXPECT_GT(compared.told, 20) << scale;
    EXPECT_GT(compared.impacts, 20) << scale;
  }
}

// Tasks that follow each other in their places: more chains than lanes, of any length.
class Chains : public SettleTasks {
 public:
  explicit Chains(const Cell& cell) : cell_(cell), at_(kLanes) {
    for (std::size_t i = 0; i < 40; ++i) left_.push_back(1 + i * 7 % 6);
    taken = std::vector<std::size_t>(left_.size(), 0);
  }
  std::optional<SettleTask> next(std::size_t place) override {
    std::optional<std::size_t>& chain = at_[place];
    if (chain && left_[*chain] == 0) chain.reset();
    if (!chain && begun_ < left_.size()) chain = begun_++;
    if (!chain) return {};
    --left_[*chain];
    return SettleTask{&cell_.system, cell_.start,
                      whole_run(1 + static_cast<long long>(*chain) % 3)};
  }
  void take(std::size_t place, SettledMotion) override { ++taken[*at_[place]]; }
  std::size_t left() const { return left_.size() - begun_; }

  std::vector<std::size_t> taken;

 private:
  const Cell& cell_;
  std::vector<std::optional<std::size_t>> at_;
  std::vector<std::size_t> left_;
  std::size_t begun_ = 0;
};

TEST(SideBySide, FinishesEveryChain) {
  std::mt19937_64 random(5);
  Cell cell = random_cell(random);
  while (!lane_form(cell.system, ExactFlow<double>(cell.system))) cell = random_cell(random);
  Chains chains(cell);
  settle_side_by_side(chains);
  EXPECT_EQ(chains.left(), 0u);
  for (std::size_t i = 0; i < chains.taken.size(); ++i) EXPECT_EQ(chains.taken[i], 1 + i * 7 % 6);
}

// Whoever flies beside it, and in whichever lane.
TEST(SideBySide, DoesNotFeelItsNeighbours) {
  std::mt19937_64 random(7);
  std::deque<Cell> cells;
  while (cells.size() < 200) {
    Cell cell = random_cell(random);
    if (cell.system.modes() == 3 && cell.system.stops.size() == 2) cells.push_back(cell);
  }
  const SettleOptions options = whole_run(20);
  Cells together(cells, options);
  settle_side_by_side(together);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::deque<Cell> one{cells[i]};
    Cells alone(one, options);
    settle_side_by_side(alone);
    expect_equal(alone.motions[0], together.motions[i]);
  }
}

// By vectors of eight numbers or of four; both have fused multiply-add. Others differ in the last
// digit.
TEST(SideBySide, IsTheSameInShorterVectors) {
  if ((hwy::SupportedTargets() & HWY_AVX3) == 0) GTEST_SKIP() << "there are no longer vectors";
  std::mt19937_64 random(11);
  std::deque<Cell> cells;
  while (cells.size() < 300) {
    Cell cell = random_cell(random);
    if (cell.system.modes() == 2 && cell.system.stops.size() == 2) cells.push_back(cell);
  }
  const SettleOptions options = whole_run(20);
  Cells longest(cells, options), shorter(cells, options);
  settle_side_by_side(longest);
  const auto choose = [](std::int64_t disabled) {
    hwy::DisableTargets(disabled);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  constexpr std::int64_t kLong = (std::int64_t{HWY_AVX3} << 1) - 1;  // and whatever is longer
  choose(kLong);
  EXPECT_EQ(hwy::SupportedTargets() & kLong, 0);
  settle_side_by_side(shorter);
  choose(0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    expect_equal(longest.motions[i], shorter.motions[i]);
}

}  // namespace
}  // namespace graze
