#include "graze/bifurcation/touch_curve.hpp"

#include <array>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/passage_locus.hpp"

namespace graze {
namespace {

// With their touch.
class TouchingStrobe : public StrobeLocus {
 public:
  TouchingStrobe(const PassageEquations& equations, int stop)
      : StrobeLocus(equations), stop_(stop) {
    tolerance = 1e-11;
  }

  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> /*zero*/) const override {
    const System* system = system_at(at);
    const auto touch =
        system ? equations_.touch_at(unknown(at), std::array{at.second}, stop_) : std::nullopt;
    const std::optional<Orbit> orbit =
        touch ? orbit_of(*system, equations_.shooting(), at.u, {}, *touch) : std::nullopt;
    if (!orbit) return {};
    return LocusPlace{
        {at.first, at.second, 0.0, orbit->impacts, true, {}, orbit->section}, Vector(), "", {}};
  }

  // A touch from outside, where the gap has a minimum, and one from within a contact, which a
  // maximum parts in two, are two things.
  bool goes_on(const LocusSite& previous, const LocusSite& here) const override {
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

  int stop_;
};

}  // namespace

TouchCurve::TouchCurve(const PassageEquations& equations, int stop)
    : OrbitCurve(equations, equations.shooting().size(), 1, equations.unit(0),
                 std::make_unique<TouchingStrobe>(equations, stop)) {
  problem_.problem.evaluate = [&equations, stop](const Vector& y, Parameters at) {
    return equations.touching(y, at, stop);
  };
  problem_.problem.wrap[problem_.first + 1] = equations.period() * kTurn;
}

std::vector<BranchPoint> TouchCurve::rewritings(const BranchPoint& point) const {
  const Eigen::Index size = problem_.first, n = size / equations_.period();
  std::vector<BranchPoint> list;
  for (Eigen::Index begun = 0; begun < size; begun += n) {
    const auto from_there = [&](const Vector& turns) {
      Vector turned(size);
      turned << turns.segment(begun, size - begun), turns.head(begun);
      return turned;
    };
    BranchPoint turned = point;
    turned.u.head(size) = from_there(point.u);
    turned.u[size + 1] -= static_cast<double>(begun / n) * kTurn;
    turned.tangent.head(size) = from_there(point.tangent);
    list.push_back(std::move(turned));
  }
  return list;
}

}  // namespace graze
