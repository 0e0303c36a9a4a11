#include "graze/bifurcation/loci/detail/segment_grazing.hpp"

#include <array>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/cut/detail/segment_locus.hpp"

namespace graze {
namespace {

// Tolerance of its equations.
constexpr double kTolerance = 1e-11;

// The part that orbits with a grazing contact share, whatever their sections.
class GrazingAtStop {
 public:
  GrazingAtStop(const SegmentEquations& equations, int stop) : equations_(equations), stop_(stop) {}

  std::optional<GrazingContact> grazing(const LocusSite& at) const {
    return equations_.grazing_at(unknown(at), std::array{at.second}, stop_);
  }
  std::optional<SegmentShooting> shooting(const LocusSite& at) const {
    return equations_.without_grazing(unknown(at), std::array{at.first, at.second}, stop_);
  }
  // A touch from outside, where the gap has a minimum, and one from within a contact, which a
  // maximum splits in two, are different loci.
  bool stays_what_it_is(const LocusSite& previous, const LocusSite& here) const {
    return push(previous) * push(here) > 0.0;
  }

 private:
  Vector unknown(const LocusSite& at) const {
    Vector y(at.u.size() + 2);
    y << at.u, at.first / equations_.unit(0), at.further;
    return y;
  }
  double push(const LocusSite& at) const {
    return equations_.push(unknown(at), std::array{at.second}, stop_).value_or(0.0);
  }

  const SegmentEquations& equations_;
  int stop_;
};

class GrazingAtFixedPhase : public FixedPhaseLocus {
 public:
  GrazingAtFixedPhase(const SegmentEquations& equations, int stop)
      : FixedPhaseLocus(equations), grazing_(equations, stop) {
    tolerance = kTolerance;
  }
  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> /*zero*/) const override {
    const System* system = system_at(at);
    const auto grazing = system ? grazing_.grazing(at) : std::nullopt;
    const std::optional<Orbit> orbit =
        grazing ? orbit_of(*system, equations_.shooting(), at.u, {}, *grazing) : std::nullopt;
    if (!orbit) return {};
    return LocusPlace{
        {at.first, at.second, 0.0, orbit->impacts, true, {}, orbit->section}, Vector(), "", {}};
  }
  bool goes_on(const LocusSite& previous, const LocusSite& here) const override {
    return grazing_.stays_what_it_is(previous, here);
  }

 private:
  GrazingAtStop grazing_;
};

class GrazingAtRelease : public ReleaseLocus {
 public:
  GrazingAtRelease(const SegmentEquations& equations, int stop)
      : ReleaseLocus(equations), grazing_(equations, stop) {
    tolerance = kTolerance;
  }
  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> /*zero*/) const override {
    const std::optional<GrazingContact> grazing =
        system_at(at) ? grazing_.grazing(at) : std::nullopt;
    return grazing ? place_at_release(at, grazing) : std::nullopt;
  }
  bool goes_on(const LocusSite& previous, const LocusSite& here) const override {
    return grazing_.stays_what_it_is(previous, here) && ReleaseLocus::goes_on(previous, here);
  }

 private:
  std::optional<SegmentShooting> shooting_at(const LocusSite& at) const override {
    return grazing_.shooting(at);
  }

  GrazingAtStop grazing_;
};

std::unique_ptr<LocusOrbits> grazing_orbits(const SegmentEquations& equations, int stop) {
  if (equations.layout().released) return std::make_unique<GrazingAtRelease>(equations, stop);
  return std::make_unique<GrazingAtFixedPhase>(equations, stop);
}

}  // namespace

SegmentGrazing::SegmentGrazing(const SegmentEquations& equations, int stop)
    : OrbitCurve(equations, equations.shooting().size(), 1, equations.unit(0),
                 grazing_orbits(equations, stop)) {
  problem_.problem.evaluate = [&equations, stop](const Vector& y, Parameters at) {
    return equations.grazing(y, at, stop);
  };
  problem_.problem.wrap[problem_.first + 1] = equations.period() * kTurn;
}

std::vector<SolutionPoint> SegmentGrazing::rewritings(const SolutionPoint& point) const {
  // Other sections at the release belong to other equations.
  const auto layout = std::get<SegmentLayout>(equations_.orbit_layout());
  if (layout.released) return {point};
  const Eigen::Index size = problem_.first, n = size / equations_.period();
  std::vector<SolutionPoint> list;
  for (Eigen::Index begun = 0; begun < size; begun += n) {
    const auto from_there = [&](const Vector& turns) {
      Vector turned(size);
      turned << turns.segment(begun, size - begun), turns.head(begun);
      return turned;
    };
    SolutionPoint turned = point;
    turned.u.head(size) = from_there(point.u);
    turned.u[size + 1] -= static_cast<double>(begun / n) * kTurn;
    turned.tangent.head(size) = from_there(point.tangent);
    list.push_back(std::move(turned));
  }
  return list;
}

}  // namespace graze
