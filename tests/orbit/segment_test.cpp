// The segment of a motion with its deviations where nothing sticks: the monodromy matrix.
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"

#include <gtest/gtest.h>

#include "graze/base/angle.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/search/finder.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// The multipliers of an orbit by flow and saltation matrices, and by a segment from the start of a
// forcing period.
void expect_same_multipliers(const System& system, const Orbit& orbit, double tolerance) {
  const Eigen::Index n = system.modes();
  // From just after the last impact to the next start of a period.
  const OrbitImpact& last = orbit.impacts.back();
  const State after = after_impact(system.stops[static_cast<std::size_t>(last.stop)], last.before);
  const ExactFlow<double> flow(system);
  const double s = (kTurn + system.forcing()->phase - last.phase) / system.forcing()->frequency;
  Arc<double> arc(flow);
  arc.start(last.phase, after.q, after.qdot);
  State start{Vector(n), Vector(n)};
  arc.state(s, start.q, start.qdot);
  Deviations deviations{Matrix::Zero(n, 2 * n), Matrix::Zero(n, 2 * n),
                        Eigen::RowVectorXd::Zero(2 * n)};
  deviations.q.leftCols(n).setIdentity();
  deviations.qdot.rightCols(n).setIdentity();
  const TrajectorySegment segment =
      pass(system, Motion<double>(system, {}, start.q, start.qdot).state(), {orbit.period, 0.0}, {},
           &deviations);
  EXPECT_EQ(segment.failure, "");
  ASSERT_EQ(segment.impacts.size(), orbit.impacts.size());
  EXPECT_LE((segment.end.q - start.q).norm() / start.q.norm(), 1e-8);
  Matrix map(2 * n, 2 * n);
  map << deviations.q, deviations.qdot;
  const std::vector<Eigenvalue> multipliers = eigenvalues(map);
  ASSERT_EQ(multipliers.size(), orbit.multipliers.size());
  for (std::size_t i = 0; i < multipliers.size(); ++i)
    EXPECT_LE(std::abs(multipliers[i].value - orbit.multipliers[i].value), tolerance);
}

TEST(TrajectorySegment, CarriesDeviationsLikeTheMonodromyMatrix) {
  int seen = 0;
  for (const double frequency : {1.4, 1.6, 2.1, 2.8})
    for (const double restitution : {0.5, 0.8}) {
      SCOPED_TRACE(testing::Message() << "W " << frequency << ", r " << restitution);
      for (const double zeta : {0.02, 0.3}) {
        System system = support::forced_oscillator(1.0, zeta, 0.3, restitution, frequency, 1.0);
        system.omega = (Vector(3) << 1.0, 3.3, 6.1).finished();
        system.modal().delta = zeta * system.omega;
        system.modal().forcing->amplitude = (Vector(3) << 1.0, 0.4, 0.2).finished();
        const Vector row = (Vector(3) << 1.0, 0.6, -0.5).finished();
        system.stops[0].row = row;
        system.stops[0].impact().direction = momentum_direction(row);
        FinderOptions options;
        options.from_simulation = options.from_random = false;
        for (const Orbit& orbit : find_orbits(system, {}, options).orbits) {
          expect_same_multipliers(system, orbit, 1e-9);
          ++seen;
        }
      }
    }
  EXPECT_GE(seen, 3);
}

}  // namespace
}  // namespace graze
