#include "graze/bifurcation/loci/detail/touch_curve.hpp"

#include <array>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/cut/detail/passage_locus.hpp"

namespace graze {
namespace {

// To what its equations are solved.
constexpr double kTolerance = 1e-11;

// What orbits with a touch are asked, whatever sections they have.
class Touching {
 public:
  Touching(const PassageEquations& equations, int stop) : equations_(equations), stop_(stop) {}

  std::optional<Touch> touch(const LocusSite& at) const {
    return equations_.touch_at(unknown(at), std::array{at.second}, stop_);
  }
  std::optional<PassageShooting> shooting(const LocusSite& at) const {
    return equations_.without_touch(unknown(at), std::array{at.first, at.second}, stop_);
  }
  // A touch from outside, where the gap has a minimum, and one from within a contact, which a
  // maximum parts in two, are two things.
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

  const PassageEquations& equations_;
  int stop_;
};

class GrazingAtFixedPhase : public FixedPhaseLocus {
 public:
  GrazingAtFixedPhase(const PassageEquations& equations, int stop)
      : FixedPhaseLocus(equations), touching_(equations, stop) {
    tolerance = kTolerance;
  }
  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> /*zero*/) const override {
    const System* system = system_at(at);
    const auto touch = system ? touching_.touch(at) : std::nullopt;
    const std::optional<Orbit> orbit =
        touch ? orbit_of(*system, equations_.shooting(), at.u, {}, *touch) : std::nullopt;
    if (!orbit) return {};
    return LocusPlace{
        {at.first, at.second, 0.0, orbit->impacts, true, {}, orbit->section}, Vector(), "", {}};
  }
  bool goes_on(const LocusSite& previous, const LocusSite& here) const override {
    return touching_.stays_what_it_is(previous, here);
  }

 private:
  Touching touching_;
};

class TouchingRelease : public ReleaseLocus {
 public:
  TouchingRelease(const PassageEquations& equations, int stop)
      : ReleaseLocus(equations), touching_(equations, stop) {
    tolerance = kTolerance;
  }
  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> /*zero*/) const override {
    const std::optional<Touch> touch = system_at(at) ? touching_.touch(at) : std::nullopt;
    return touch ? place_at_release(at, touch) : std::nullopt;
  }
  bool goes_on(const LocusSite& previous, const LocusSite& here) const override {
    return touching_.stays_what_it_is(previous, here) && ReleaseLocus::goes_on(previous, here);
  }

 private:
  std::optional<PassageShooting> shooting_at(const LocusSite& at) const override {
    return touching_.shooting(at);
  }

  Touching touching_;
};

std::unique_ptr<LocusOrbits> touching_orbits(const PassageEquations& equations, int stop) {
  if (equations.layout().released) return std::make_unique<TouchingRelease>(equations, stop);
  return std::make_unique<GrazingAtFixedPhase>(equations, stop);
}

}  // namespace

TouchCurve::TouchCurve(const PassageEquations& equations, int stop)
    : OrbitCurve(equations, equations.shooting().size(), 1, equations.unit(0),
                 touching_orbits(equations, stop)) {
  problem_.problem.evaluate = [&equations, stop](const Vector& y, Parameters at) {
    return equations.touching(y, at, stop);
  };
  problem_.problem.wrap[problem_.first + 1] = equations.period() * kTurn;
}

std::vector<SolutionPoint> TouchCurve::rewritings(const SolutionPoint& point) const {
  // The other sections at a release are other equations.
  const auto& layout = std::get<PassageLayout>(equations_.orbit_layout());
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
