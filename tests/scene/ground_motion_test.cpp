// Records of a moving clamp: displacements as accelerations, and how far accelerations drift.
#include "graze/scene/ground_motion.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "graze/base/errors.hpp"
#include "graze/scene/reader.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

struct Motion {
  std::vector<double> times, accelerations, displacements;
};

// Along straight lines between accelerations, from a displacement and a velocity.
void integrate(Motion& motion, double displacement, double velocity) {
  motion.displacements = {displacement};
  for (std::size_t k = 1; k < motion.times.size(); ++k) {
    const double h = motion.times[k] - motion.times[k - 1];
    const double a = motion.accelerations[k - 1], b = motion.accelerations[k];
    displacement += h * velocity + h * h * (a / 3.0 + b / 6.0);
    velocity += 0.5 * h * (a + b);
    motion.displacements.push_back(displacement);
  }
}

Motion random_motion(std::mt19937_64& random, std::size_t instants) {
  std::uniform_real_distribution<double> size(-3.0, 3.0), length(0.05, 0.4);
  Motion motion{{size(random)}, {size(random)}, {}};
  for (std::size_t k = 1; k < instants; ++k) {
    motion.times.push_back(motion.times.back() + length(random));
    motion.accelerations.push_back(size(random));
  }
  return motion;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-10) << k;
}

TEST(GroundMotion, DisplacementsHaveTheAccelerationsThatMadeThem) {
  std::mt19937_64 random(1940);
  for (const std::size_t instants : {2, 3, 4, 50}) {
    Motion motion = random_motion(random, instants);
    motion.accelerations.front() = motion.accelerations.back() = 0.0;
    integrate(motion, 0.7, -2.0);
    expect_same(spline_accelerations(motion.times, motion.displacements, false),
                motion.accelerations);
  }
}

// One that comes back with the velocity it left with.
TEST(GroundMotion, DisplacementsThatRepeatDoToo) {
  std::mt19937_64 random(1985);
  for (const std::size_t instants : {4, 5, 60}) {
    Motion motion = random_motion(random, instants);
    motion.accelerations.back() = motion.accelerations.front();
    const double length = motion.times.back() - motion.times.front();
    const Drift gains = drift_of(TimeCourse(motion.times, motion.accelerations, true));
    for (double& acceleration : motion.accelerations) acceleration -= gains.velocity / length;
    const double back = drift_of(TimeCourse(motion.times, motion.accelerations, true)).displacement;
    integrate(motion, 0.2, -back / length);
    EXPECT_NEAR(motion.displacements.back(), motion.displacements.front(), 1e-13);
    expect_same(spline_accelerations(motion.times, motion.displacements, true),
                motion.accelerations);
  }
}

// 2 t to t = 3 and then 6 - (t - 3) to t = 5: v = 9 + 12 - 2, and x by hand.
TEST(GroundMotion, DriftIsTheIntegral) {
  const Drift drift = drift_of(TimeCourse({0.0, 3.0, 5.0}, {0.0, 6.0, 4.0}, false));
  EXPECT_DOUBLE_EQ(drift.velocity, 19.0);
  EXPECT_DOUBLE_EQ(drift.displacement, 9.0 + 9.0 * 2.0 + 3.0 * 4.0 - 8.0 / 6.0);
}

class Record : public ::testing::Test {
 protected:
  Scene scene(const std::string& kind, const std::string& signal) {
    std::ofstream(folder_ / "x.csv") << "t (ms),x (mm)\n0,0\n100,3\n250,-1\n400,0\n";
    return parse_scene(
        "[lumped]\nmasses = [2]\n[[lumped.spring]]\nbetween = [0, 1]\nstiffness = 18\n"
        "[forcing]\nkind = \"" +
            kind + "\"\n" + (kind == "base" ? "" : "mass = 1\n") + "signal = { file = \"x.csv\", " +
            signal + " }\n",
        (folder_ / "scene.toml").string());
  }

 private:
  ScratchFolder folder_;
};

TEST_F(Record, IsReadInMetresAndSeconds) {
  const Scene read = scene("base", "quantity = \"displacement\"");
  const TimeCourse& course = *read.forcing->signal->course;
  EXPECT_EQ(course.times, (std::vector<double>{0.0, 0.1, 0.25, 0.4}));
  expect_same(course.values, spline_accelerations(course.times, {0.0, 3e-3, -1e-3, 0.0}, false));
}

TEST_F(Record, IsRefusedWhereNothingMovesByIt) {
  EXPECT_THROW(scene("point", "quantity = \"displacement\""), InputError);
  EXPECT_NO_THROW(scene("base", "quantity = \"displacement\", repeat = true"));
}

}  // namespace
}  // namespace graze
