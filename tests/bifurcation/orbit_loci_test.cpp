// Loci of (1,1) orbits in two parameters against the closed form.
#include "graze/bifurcation/loci/orbit_loci.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "branch_checks.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

Scene four_modes() {
  return support::shipped_scene("05_wagg_one_mode", {"beam.modes=4", "stop.gap=5e-3"});
}

OrbitLoci loci(const Scene& scene, OrbitLocusKind kind, double from, double to, double gap_from,
               double gap_to, bool keep_virtual, double max_step = 0.0) {
  LociOptions options;
  options.branches.from = from;
  options.branches.to = to;
  options.branches.keep_virtual = keep_virtual;
  options.branches.max_step = max_step;
  options.branches.finder.from_simulation = options.branches.finder.from_random = false;
  options.second_from = gap_from;
  options.second_to = gap_to;
  options.kinds = {kind};
  return trace_loci(scene, "forcing.frequency", "stop.gap", options);
}

System system_at(const Scene& scene, double frequency, double gap) {
  return assemble(
      with_parameter(with_parameter(scene, "forcing.frequency", frequency), "stop.gap", gap));
}

TEST(OrbitLoci, FoldsOfTheFourModeBeamAreWhereKappaIsTheGap) {
  const Scene scene = four_modes();
  const OrbitLoci found = loci(scene, OrbitLocusKind::kFold, 20.0, 120.0, 0.0, 0.02, true);
  ASSERT_FALSE(found.loci.empty());
  std::vector<double> frequencies;
  for (const OrbitLocus& locus : found.loci)
    for (const OrbitLocusPoint& point : locus.points) {
      const System system = system_at(scene, point.value, point.second);
      const double kappa = std::abs(closed_form(system, 0, 1).form->kappa);
      EXPECT_NEAR(point.second / kappa, 1.0, 1e-9) << point.value;
      frequencies.push_back(point.value);
    }
  // Nothing of the range is left out where |kappa| is within that of the gap.
  std::sort(frequencies.begin(), frequencies.end());
  for (double frequency = 20.0; frequency <= 120.0; frequency += 0.05) {
    const double kappa = std::abs(closed_form(system_at(scene, frequency, 5e-3), 0, 1).form->kappa);
    if (kappa > 0.02) continue;
    const auto above = std::lower_bound(frequencies.begin(), frequencies.end(), frequency);
    const double nearest = std::min(above == frequencies.end() ? 1e9 : *above - frequency,
                                    above == frequencies.begin() ? 1e9 : frequency - *(above - 1));
    EXPECT_LE(nearest, 2.0) << frequency;
  }
}

// The multipliers of the closed form's own orbit nearest to an impact.
std::vector<Eigenvalue> closed_multipliers(const System& system, const OrbitImpact& near) {
  const auto solutions = closed_form(system, 0, 1).form->solutions(system.stops[0].gap);
  const auto distance = [&](const ImpactPoint& p) {
    return std::abs(std::remainder(p.theta - near.phase, kTurn));
  };
  const ImpactPoint& point =
      *std::min_element(solutions.begin(), solutions.end(),
                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  EXPECT_LE(distance(point), 1e-6);
  return orbit_multipliers(system, {1, {0}}, {point});
}

// How far a multiplier is from being at mu, beyond its own error; beside a resonance, where two
// are, the square of that.
double distance_to(const std::vector<Eigenvalue>& list, Complex mu) {
  double product = 1.0;
  for (const Eigenvalue& m : list)
    product *= std::clamp(std::abs(m.value - mu) - m.error, 0.0, 1.0);
  return product;
}

TEST(OrbitLoci, DoublingsAndToriHaveTheClosedFormsMultipliers) {
  for (const char* modes : {"beam.modes=1", "beam.modes=2", "beam.modes=4"})
    for (const OrbitLocusKind kind : {OrbitLocusKind::kPeriodDoubling, OrbitLocusKind::kTorus}) {
      const Scene scene = support::shipped_scene("05_wagg_one_mode", {modes, "stop.gap=2e-3"});
      const OrbitLoci found = loci(scene, kind, 30.0, 60.0, 5e-4, 0.01, false);
      int points = 0;
      for (const OrbitLocus& locus : found.loci)
        for (const OrbitLocusPoint& point : locus.points) {
          const System system = system_at(scene, point.value, point.second);
          // Beside a grazing multipliers grow like 1/v, and their error with them.
          if (point.impacts[0].speed < 1e-3) continue;
          const SystemFamily family(with_parameter(scene, "stop.gap", point.second),
                                    "forcing.frequency");
          if (support::fold_distance(family, point.value)->relative() < support::kBesideFold)
            continue;
          const auto multipliers = closed_multipliers(system, point.impacts[0]);
          EXPECT_LE(distance_to(multipliers, std::polar(1.0, point.angle)), 1e-9)
              << modes << label_of(kind) << point.value << " " << point.impacts[0].speed;
          EXPECT_TRUE(point.admissible);
          ++points;
        }
      const bool single = std::string(modes) == "beam.modes=1" && kind == OrbitLocusKind::kTorus;
      if (single) {
        EXPECT_EQ(points, 0);  // the product of its two multipliers is below 1
      } else {
        EXPECT_GE(points, 20) << modes << label_of(kind);
      }
      EXPECT_EQ(found.cut_short, 0);
    }
}

double linear_amplitude(const System& system) {
  Complex amplitude = 0.0;
  const double w = system.forcing()->frequency;
  for (int j = 0; j < system.modes(); ++j)
    amplitude += system.stops[0].row[j] * system.forcing()->amplitude[j] /
                 Complex(system.omega[j] * system.omega[j] - w * w, 2.0 * system.delta()[j] * w);
  return std::abs(amplitude);
}

TEST(OrbitLoci, GrazingOfTheLinearResponseHasItsAmplitude) {
  for (const char* modes : {"beam.modes=1", "beam.modes=4"}) {
    const Scene scene = support::shipped_scene("05_wagg_one_mode", {modes, "stop.gap=2e-3"});
    const OrbitLoci found = loci(scene, OrbitLocusKind::kGrazing, 30.0, 60.0, 2e-4, 0.01, false);
    int points = 0;
    for (const OrbitLocus& locus : found.loci) {
      if (locus.pattern.impacts() != 1) continue;
      for (const OrbitLocusPoint& point : locus.points) {
        const System system = system_at(scene, point.value, point.second);
        EXPECT_NEAR(point.second / linear_amplitude(system), 1.0, 1e-9) << point.value;
        ++points;
      }
    }
    EXPECT_GE(points, 10) << modes;
  }
}

// The fold of the closed form at this frequency, with the gap that makes it one: contact at
// |kappa| cos(phi + arg kappa) = |kappa|.
std::vector<Eigenvalue> fold_multipliers(const Scene& scene, double frequency) {
  const ClosedForm form = *closed_form(system_at(scene, frequency, 1e-3), 0, 1).form;
  const System system = system_at(scene, frequency, std::abs(form.kappa));
  ImpactPoint point{-std::arg(form.kappa), form.rest};
  const ComplexVector before = form.response * std::polar(1.0, point.theta);
  const Eigen::Index n = system.modes();
  point.before.q += before.head(n).real();
  point.before.qdot += before.tail(n).real();
  return orbit_multipliers(system, {1, {0}}, {point});
}

// Of the fold's multipliers: prod (mu_i + 1) and prod (mu_i mu_j - 1) over all pairs.
struct FoldTests {
  double doubling = 1.0, torus = 1.0;
};
FoldTests fold_tests(const Scene& scene, double frequency) {
  const auto list = fold_multipliers(scene, frequency);
  Complex doubling = 1.0, torus = 1.0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    doubling *= list[i].value + 1.0;
    for (std::size_t k = 0; k < i; ++k) torus *= list[i].value * list[k].value - 1.0;
  }
  return {doubling.real(), torus.real()};
}

TEST(OrbitLoci, FoldsMeetDoublingsAndToriWhereTheClosedFormSaysSo) {
  const Scene scene = four_modes();
  const OrbitLoci found = loci(scene, OrbitLocusKind::kFold, 38.0, 60.0, 1.2e-3, 0.01, false);
  int doublings = 0, tori = 0;
  for (const OrbitLocus& locus : found.loci)
    for (const OrbitLocusSpecial& special : locus.special) {
      const FoldTests before = fold_tests(scene, special.at.value * (1.0 - 1e-9));
      const FoldTests behind = fold_tests(scene, special.at.value * (1.0 + 1e-9));
      if (special.label == "LPPD") {
        EXPECT_LT(before.doubling * behind.doubling, 0.0) << special.at.value;
        ++doublings;
      } else if (special.label == "LPNS") {
        EXPECT_LT(before.torus * behind.torus, 0.0) << special.at.value;
        ++tori;
      }
    }
  EXPECT_GE(doublings, 1);
  EXPECT_GE(tori, 1);
}

// Doublings and folds come up to a grazing along a parabola: H. Dankowicz and X. Zhao, Physica D
// 202 (2005) 238; P. Thota, X. Zhao and H. Dankowicz, J. Comput. Nonlinear Dyn. 1 (2006) 328. With
// one mode the point is where the free mode makes whole half turns in a period, sin(w_d T) = 0.
TEST(OrbitLoci, DoublingsMeetGrazingAlongAParabola) {
  const Scene scene =
      support::shipped_scene("05_wagg_one_mode", {"stop.gap=1.25e-3", "forcing.frequency=54.0"});
  const OrbitLoci found =
      loci(scene, OrbitLocusKind::kPeriodDoubling, 53.5, 54.5, 1.2e-3, 1.3e-3, false);
  ASSERT_EQ(found.loci.size(), 1u);
  const OrbitLocus& locus = found.loci[0];
  ASSERT_EQ(locus.special.size(), 1u);
  EXPECT_EQ(locus.special[0].label, "PDGR");
  const System at_end = system_at(scene, locus.special[0].at.value, 1e-3);
  const double free =
      std::sqrt(at_end.omega[0] * at_end.omega[0] - at_end.delta()[0] * at_end.delta()[0]);
  const double end = 2.0 * free;
  EXPECT_NEAR(locus.special[0].at.value / end, 1.0, 1e-10);
  EXPECT_NEAR(locus.special[0].at.second / linear_amplitude(at_end), 1.0, 1e-10);
  int compared = 0;
  double rest = 0.0;
  for (const OrbitLocusPoint& point : locus.points) {
    const double away = point.value - end;
    if (!(away > 0.005 && away < 0.1)) continue;
    const System system = system_at(scene, point.value, point.second);
    const double ratio = (point.second - linear_amplitude(system)) / (away * away);
    if (compared++ > 0) {
      EXPECT_NEAR(ratio / rest, 1.0, 0.02) << point.value;
    } else {
      rest = ratio;
    }
  }
  EXPECT_GE(compared, 5);
}

std::vector<double> places(const OrbitLoci& found, const std::string& label) {
  std::vector<double> values;
  for (const OrbitLocus& locus : found.loci)
    for (const OrbitLocusSpecial& special : locus.special)
      if (special.label == label) values.push_back(special.at.value);
  std::sort(values.begin(), values.end());
  return values;
}

// Where an orbit touches twice two loci of grazing cross. They are of different sequences of
// impacts, and each finds the other one's touch among the gaps between its own.
TEST(OrbitLoci, TwoGrazingContactsAreTheSameFromBothLociAndWithAnyStep) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {"beam.modes=2", "stop.gap=2e-3"});
  const auto double_grazings = [&](double max_step) {
    return places(loci(scene, OrbitLocusKind::kGrazing, 20.0, 60.0, 5e-4, 0.01, false, max_step),
                  "GRGR");
  };
  const std::vector<double> grazings = double_grazings(0.0);
  // Met on both loci where both are orbits there.
  int met_twice = 0;
  for (std::size_t i = 1; i < grazings.size(); ++i) {
    const double apart = grazings[i] - grazings[i - 1];
    EXPECT_TRUE(apart < 1e-9 || apart > 1e-3) << grazings[i];
    met_twice += apart < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(met_twice, 4);
  const std::vector<double> closer = double_grazings(0.2);
  EXPECT_EQ(closer.size(), grazings.size());
  for (const double grazing : grazings) {
    double nearest = 1e9;
    for (const double other : closer) nearest = std::min(nearest, std::abs(other / grazing - 1.0));
    EXPECT_LE(nearest, 1e-10) << grazing;
  }
}

// With no slices but the scene's own, loci that these do not meet are found where they meet others.
TEST(OrbitLoci, LeadToOneAnother) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {"beam.modes=2", "stop.gap=2e-3"});
  LociOptions options;
  options.branches.from = 20.0;
  options.branches.to = 60.0;
  options.branches.finder.from_simulation = options.branches.finder.from_random = false;
  options.second_from = 5e-4;
  options.second_to = 0.01;
  options.slices = 0;
  using Kind = OrbitLocusKind;
  std::size_t alone = 0;
  for (const Kind kind : {Kind::kFold, Kind::kPeriodDoubling, Kind::kTorus, Kind::kGrazing}) {
    options.kinds = {kind};
    alone += trace_loci(scene, "forcing.frequency", "stop.gap", options).loci.size();
  }
  options.kinds = {Kind::kFold, Kind::kPeriodDoubling, Kind::kTorus, Kind::kGrazing};
  const OrbitLoci together = trace_loci(scene, "forcing.frequency", "stop.gap", options);
  EXPECT_GT(together.loci.size(), alone);
  // Every doubling or torus on a fold is on a locus of these too.
  for (const auto& [label, kind] :
       {std::pair("LPPD", Kind::kPeriodDoubling), std::pair("LPNS", Kind::kTorus)})
    for (const OrbitLocus& locus : together.loci)
      for (const OrbitLocusSpecial& special : locus.special) {
        if (locus.kind != Kind::kFold || special.label != label) continue;
        double nearest = 1e9;
        for (const OrbitLocus& other : together.loci)
          for (const OrbitLocusSpecial& same : other.special)
            if (other.kind == kind && same.label == label)
              nearest = std::min(nearest, std::abs(same.at.value / special.at.value - 1.0));
        EXPECT_LE(nearest, 1e-9) << label << " " << special.at.value;
      }
}

// Loci are traced several at once, and are those of one after the other to the last bit.
TEST(OrbitLoci, DoNotDependOnTheNumberOfThreads) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {"beam.modes=2", "stop.gap=2e-3"});
  LociOptions options;
  options.branches.from = 40.0;
  options.branches.to = 60.0;
  options.second_from = 5e-4;
  options.second_to = 5e-3;
  options.slices = 1;
  using Kind = OrbitLocusKind;
  options.kinds = {Kind::kFold, Kind::kPeriodDoubling, Kind::kTorus, Kind::kGrazing};
  options.branches.finder.threads = 1;
  const OrbitLoci alone = trace_loci(scene, "forcing.frequency", "stop.gap", options);
  ASSERT_GT(alone.loci.size(), 5u);
  options.branches.finder.threads = 0;
  const OrbitLoci at_once = trace_loci(scene, "forcing.frequency", "stop.gap", options);
  EXPECT_EQ(at_once.starts, alone.starts);
  EXPECT_EQ(at_once.lost_starts, alone.lost_starts);
  EXPECT_EQ(at_once.shooting_evaluations, alone.shooting_evaluations);
  ASSERT_EQ(at_once.loci.size(), alone.loci.size());
  for (std::size_t i = 0; i < alone.loci.size(); ++i) {
    const OrbitLocus &a = alone.loci[i], &b = at_once.loci[i];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.special.size(), b.special.size());
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t k = 0; k < a.points.size(); ++k) {
      EXPECT_EQ(a.points[k].value, b.points[k].value);
      EXPECT_EQ(a.points[k].second, b.points[k].second);
      EXPECT_EQ(a.points[k].impacts.front().speed, b.points[k].impacts.front().speed);
    }
  }
}

// An end called grazing is among the special points, no special point is named twice on a locus,
// and no locus is a point.
TEST(OrbitLoci, EndOnGrazingsOnce) {
  for (const char* modes : {"beam.modes=1", "beam.modes=2"})
    for (const OrbitLocusKind kind : {OrbitLocusKind::kFold, OrbitLocusKind::kPeriodDoubling,
                                      OrbitLocusKind::kTorus, OrbitLocusKind::kGrazing}) {
      const Scene scene = support::shipped_scene("05_wagg_one_mode", {modes, "stop.gap=2e-3"});
      for (const OrbitLocus& locus : loci(scene, kind, 42.0, 60.0, 5e-4, 0.01, false).loci) {
        const auto apart = [](const OrbitLocusPoint& a, const OrbitLocusPoint& b) {
          return std::hypot((a.value - b.value) / 18.0, (a.second - b.second) / 0.0095);
        };
        double length = 0.0;
        for (const OrbitLocusPoint& point : locus.points)
          length = std::max(length, apart(point, locus.points.front()));
        EXPECT_GT(length, 1e-9) << modes << " " << label_of(kind) << locus.id;
        for (std::size_t i = 0; i < locus.special.size(); ++i)
          for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(locus.special[i].label == locus.special[k].label &&
                         apart(locus.special[i].at, locus.special[k].at) < 1e-9)
                << modes << " " << locus.special[i].label << " " << locus.special[i].at.value;
        for (const std::size_t side : {0u, 1u}) {
          if (locus.ends[side] != OrbitLocusEnd::kGrazing) continue;
          const OrbitLocusPoint& end = side == 0 ? locus.points.front() : locus.points.back();
          EXPECT_TRUE(std::any_of(
              locus.special.begin(), locus.special.end(),
              [&](const OrbitLocusSpecial& special) { return apart(special.at, end) == 0.0; }))
              << modes << " " << label_of(kind) << locus.id;
        }
      }
    }
}

}  // namespace
}  // namespace graze
