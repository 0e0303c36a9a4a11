#include "graze/assembly/detail/driven_motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/scene/detail/table_paths.hpp"

namespace graze {
namespace {

// Roundings by which a row may miss being a sum of others, and a motion of the modes one of a stop.
constexpr double kPlaceRounding = 64.0 * std::numeric_limits<double>::epsilon();

// A value, and beside it its derivative along a direction of the scene, zero without one.
template <class Value>
struct Rated {
  Value value, rate;
};

// The rows of stops of which those of all others are sums: indices.
std::vector<std::size_t> independent_rows(const std::vector<Vector>& rows) {
  std::vector<std::size_t> chosen;
  std::vector<Vector> basis;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Vector rest = rows[i];
    for (int pass = 0; pass < 2; ++pass)
      for (const Vector& one : basis) rest -= one.dot(rest) * one;
    if (!(rest.norm() > kPlaceRounding * rows[i].norm())) continue;
    chosen.push_back(i);
    basis.push_back(rest.normalized());
  }
  return chosen;
}

// The motion of least kinetic energy that moves stops as given: c = R^T (R R^T)^-1 m, R the
// independent rows.
class FollowedStops {
 public:
  // `rate`: null for the value alone.
  FollowedStops(const ModalModel& model, const ModalModel* rate)
      : all_(model.shapes), chosen_(independent_rows(model.shapes)) {
    const auto count = static_cast<Eigen::Index>(chosen_.size());
    rows_ = Matrix::Zero(count, model.omega.size());
    rates_ = rows_;
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::size_t stop = chosen_[static_cast<std::size_t>(k)];
      rows_.row(k) = model.shapes[stop].transpose();
      if (rate) rates_.row(k) = rate->shapes[stop].transpose();
    }
    gram_.emplace(rows_ * rows_.transpose());
  }

  Rated<Vector> following(const Rated<Vector>& stops) const {
    const Vector push = gram_->solve(chosen(stops.value));
    const Matrix turned = rates_ * rows_.transpose();
    const Vector push_rate =
        gram_->solve(chosen(stops.rate) - turned * push - turned.transpose() * push);
    return {rows_.transpose() * push, rates_.transpose() * push + rows_.transpose() * push_rate};
  }

  // The first stop that does not move so; nullopt where all do.
  std::optional<std::size_t> left_behind(const Vector& motion, const Vector& stops) const {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const double wanted = stops[static_cast<Eigen::Index>(i)], got = all_[i].dot(motion);
      const double size = std::abs(wanted) + all_[i].norm() * motion.norm();
      if (std::abs(wanted - got) > kPlaceRounding * static_cast<double>(all_.size()) * size) return i;
    }
    return {};
  }

 private:
  Vector chosen(const Vector& of_all) const {
    Vector list(static_cast<Eigen::Index>(chosen_.size()));
    for (std::size_t k = 0; k < chosen_.size(); ++k)
      list[static_cast<Eigen::Index>(k)] = of_all[static_cast<Eigen::Index>(chosen_[k])];
    return list;
  }

  const std::vector<Vector>& all_;
  std::vector<std::size_t> chosen_;
  Matrix rows_, rates_;
  std::optional<PivotedLu<double>> gram_;
};

// Sums the harmonics. Phases count from that of the first load, whose force is the amplitude where
// it has the lowest order: A cos(k theta + phase) of another one is cosine cos(k theta) + sine
// sin(k theta).
class DriveSum {
 public:
  // `direction`, `rate`: null for the value alone.
  DriveSum(const Scene& scene, const ModalModel& model, const Scene* direction,
           const ModalModel* rate)
      : scene_(scene), direction_(direction), model_(model), rate_(rate) {
    common_ = scene.common_order();
    const HarmonicLoad& first = *scene.forcing;
    const double order = order_of(first);
    frequency_ = {scene.forcing->frequency, direction ? direction->forcing->frequency : 0.0};
    phase_ = {first.phase / order, direction ? direction->forcing->phase / order : 0.0};
    sum_.value.forcing = {common_ * frequency_.value, phase_.value, {}, {}};
    sum_.rate.forcing = {common_ * frequency_.rate, phase_.rate, {}, {}};
    sum_.value.forcing.repeats = sum_.rate.forcing.repeats = scene.repeats();
    sum_.value.forcing.has_phase = sum_.rate.forcing.has_phase = !first.signal || scene.repeats();
    moves_ = scene.has_moving_stop();
    for (std::size_t k = 0; k <= scene.further.size(); ++k) add_load(k);
    if (moves_) add_carried();
    for (DrivenMotion* part : {&sum_.value, &sum_.rate})
      if (part->forcing.amplitude.size() == 0) part->forcing.amplitude = none();
  }

  Rated<DrivenMotion> sum() && { return std::move(sum_); }

 private:
  static const HarmonicLoad& load_of(const Scene& scene, std::size_t k) {
    return k == 0 ? *scene.forcing : scene.further[k - 1];
  }
  Vector none() const { return Vector::Zero(model_.omega.size()); }
  double order_of(const std::optional<double>& order) const {
    return std::round(order.value_or(1.0) / common_);
  }
  double order_of(const HarmonicLoad& load) const {
    return load.own ? *load.own / (common_ * frequency_.value) : order_of(load.order);
  }
  // Of order k, rad/s.
  Rated<double> frequency_of(double order) const {
    return {order * common_ * frequency_.value, order * common_ * frequency_.rate};
  }

  // The place of an order in both lists of harmonics, made where they lack it.
  std::size_t place_of(double order, std::vector<Harmonic>& value,
                       std::vector<Harmonic>& rate) const {
    for (std::size_t k = 0; k < value.size(); ++k)
      if (!value[k].timed && value[k].order == order) return k;
    value.push_back({order, none(), none()});
    rate.push_back({order, none(), none()});
    return value.size() - 1;
  }

  // Cosine and sine of a cos(k theta + psi).
  Rated<Harmonic> turned(double order, const Rated<Vector>& size, double phase,
                         double phase_rate) const {
    const double behind = phase - order * phase_.value, moves = phase_rate - order * phase_.rate;
    const double c = std::cos(behind), n = std::sin(behind);
    return {
        {order, c * size.value, -n * size.value},
        {order, c * size.rate - n * moves * size.value, -n * size.rate - c * moves * size.value}};
  }

  void add(const Rated<Harmonic>& part, std::vector<Harmonic>& value, std::vector<Harmonic>& rate) {
    const std::size_t k = place_of(part.value.order, value, rate);
    value[k].cosine += part.value.cosine;
    value[k].sine += part.value.sine;
    rate[k].cosine += part.rate.cosine;
    rate[k].sine += part.rate.sine;
  }

  void add_load(std::size_t k) {
    const HarmonicLoad& load = load_of(scene_, k);
    const HarmonicLoad* moved = direction_ ? &load_of(*direction_, k) : nullptr;
    if (load.signal) return add_signal(load, model_.participations[k]);
    const double order = order_of(load);
    // A moving clamp accelerates by the square of its frequency times its amplitude.
    const bool is_base = load.kind == ForcingKind::kBase;
    const double turns = load.order.value_or(1.0);
    const double frequency = load.own ? double{*load.own} : turns * frequency_.value;
    const double factor = is_base ? frequency * frequency : 1.0;
    const Vector& on = model_.participations[k];
    if (load.kind == ForcingKind::kSupport) return add_support(load, moved, order, k);
    Rated<Vector> force{load.amplitude * factor * on, {}};
    if (moved) {
      const double factor_rate =
          is_base ? 2.0 * frequency * turns * frequency_.rate * load.amplitude : 0.0;
      force.rate = (moved->amplitude * factor + factor_rate) * on +
                   load.amplitude * factor * rate_->participations[k];
    }
    // Beside stops that move it is a harmonic like the others, so that what they cancel is gone.
    if (k == 0 && order == 1.0 && !moves_) {
      sum_.value.forcing.amplitude = std::move(force.value);
      sum_.rate.forcing.amplitude = std::move(force.rate);
      return;
    }
    if (!moved) force.rate = none();
    add(turned(order, force, load.phase, moved ? moved->phase : 0.0), sum_.value.forcing.harmonics,
        sum_.rate.forcing.harmonics);
  }

  // A support that moves by y presses with y by the stiffness, y' by damping and y'' by mass.
  void add_support(const HarmonicLoad& load, const HarmonicLoad* moved, double order,
                   std::size_t k) {
    const Rated<double> frequency = frequency_of(order);
    const double w = frequency.value;
    const Rated<double> factors[] = {
        {1.0, 0.0}, {w, frequency.rate}, {-w * w, -2.0 * w * frequency.rate}};
    const Matrix none_following = Matrix::Zero(none().size(), 2);
    const Matrix& following = model_.following[supports_];
    const Matrix& following_rate = moved ? rate_->following[supports_] : none_following;
    ++supports_;
    for (int i = 0; i < 3; ++i) {
      const Vector on = i == 0 ? model_.participations[k] : Vector(following.col(i - 1));
      const Vector on_rate = i > 0   ? Vector(following_rate.col(i - 1))
                             : moved ? rate_->participations[k]
                                     : none();
      if (on.isZero(0.0) && on_rate.isZero(0.0)) continue;
      const auto& [factor, factor_rate] = factors[i];
      const Rated<Vector> force{
          load.amplitude * factor * on,
          ((moved ? moved->amplitude : 0.0) * factor + load.amplitude * factor_rate) * on +
              load.amplitude * factor * on_rate};
      // A velocity is a quarter of a turn ahead.
      add(turned(order, force, load.phase + (i == 1 ? std::numbers::pi / 2.0 : 0.0),
                 moved ? moved->phase : 0.0),
          sum_.value.forcing.harmonics, sum_.rate.forcing.harmonics);
    }
  }

  // A clamp that is accelerated leaves the structure behind.
  void add_signal(const HarmonicLoad& load, const Vector& on) {
    if (load.kind == ForcingKind::kSupport) ++supports_;
    const double sign = load.kind == ForcingKind::kBase ? -1.0 : 1.0;
    const HarmonicForcing& forcing = sum_.value.forcing;
    const Harmonic::Timed timed{load.signal->course, forcing.frequency, forcing.phase};
    sum_.value.forcing.harmonics.push_back({0.0, sign * load.amplitude * on, none(), timed});
    sum_.rate.forcing.harmonics.push_back({0.0, none(), none(), timed});
  }

  // The motions of all stops, as harmonics of as many entries as there are stops.
  Rated<std::vector<Harmonic>> stop_motions() const {
    const auto count = static_cast<Eigen::Index>(scene_.stops.size());
    Rated<std::vector<Harmonic>> motions;
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto stop = static_cast<std::size_t>(i);
      const std::vector<StopMotion> terms = scene_.motion_of(scene_.stops[stop]);
      std::vector<StopMotion> moved;
      if (direction_) moved = direction_->motion_of(direction_->stops[stop]);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const Vector at = Vector::Unit(count, i);
        const Rated<Vector> size{terms[k].amplitude * at,
                                 (moved.empty() ? 0.0 : moved[k].amplitude) * at};
        const Rated<Harmonic> part = turned(order_of(terms[k].order), size, terms[k].phase,
                                            moved.empty() ? 0.0 : moved[k].phase);
        motions.value.push_back(part.value);
        motions.rate.push_back(part.rate);
      }
    }
    return motions;
  }

  void add_carried() {
    const FollowedStops followed(model_, rate_);
    const Rated<std::vector<Harmonic>> motions = stop_motions();
    for (std::size_t k = 0; k < motions.value.size(); ++k) {
      const Harmonic &motion = motions.value[k], &moved = motions.rate[k];
      add(carried_by(followed, motion, moved), sum_.value.carried, sum_.rate.carried);
    }
    for (std::size_t k = 0; k < sum_.value.carried.size(); ++k) {
      const Rated<Harmonic> part = resistance_to({sum_.value.carried[k], sum_.rate.carried[k]});
      add(part, sum_.value.forcing.harmonics, sum_.rate.forcing.harmonics);
      Harmonic& whole = sum_.value.forcing.harmonics[place_of(
          part.value.order, sum_.value.forcing.harmonics, sum_.rate.forcing.harmonics)];
      clear_rounding(part.value.cosine, whole.cosine);
      clear_rounding(part.value.sine, whole.sine);
    }
    check(followed, motions.value);
  }

  // A structure that would move with its stops by itself is left at rest, not to rounding.
  static void clear_rounding(const Vector& part, Vector& whole) {
    for (Eigen::Index j = 0; j < whole.size(); ++j)
      if (std::abs(whole[j]) <= kPlaceRounding * std::abs(part[j])) whole[j] = 0.0;
  }

  static Rated<Harmonic> carried_by(const FollowedStops& followed, const Harmonic& motion,
                                    const Harmonic& moved) {
    const Rated<Vector> cosine = followed.following({motion.cosine, moved.cosine});
    const Rated<Vector> sine = followed.following({motion.sine, moved.sine});
    return {{motion.order, cosine.value, sine.value}, {motion.order, cosine.rate, sine.rate}};
  }

  // -(c'' + D c' + w^2 c)
  Rated<Harmonic> resistance_to(const Rated<Harmonic>& c) const {
    const Rated<double> at = frequency_of(c.value.order);
    const Vector stiffness = (model_.omega.array().square() - at.value * at.value).matrix();
    Rated<Harmonic> force{{c.value.order, -stiffness.cwiseProduct(c.value.cosine),
                           -stiffness.cwiseProduct(c.value.sine)},
                          {c.value.order, none(), none()}};
    force.value.cosine -= at.value * damped(model_, c.value.sine);
    force.value.sine += at.value * damped(model_, c.value.cosine);
    if (!rate_) return force;
    const Vector stiffness_rate =
        (2.0 * model_.omega.array() * rate_->omega.array() - 2.0 * at.value * at.rate).matrix();
    force.rate.cosine = -stiffness_rate.cwiseProduct(c.value.cosine) -
                        stiffness.cwiseProduct(c.rate.cosine) -
                        at.rate * damped(model_, c.value.sine) -
                        at.value * (damped(*rate_, c.value.sine) + damped(model_, c.rate.sine));
    force.rate.sine = -stiffness_rate.cwiseProduct(c.value.sine) -
                      stiffness.cwiseProduct(c.rate.sine) +
                      at.rate * damped(model_, c.value.cosine) +
                      at.value * (damped(*rate_, c.value.cosine) + damped(model_, c.rate.cosine));
    return force;
  }

  static Vector damped(const ModalModel& model, const Vector& velocity) {
    Vector force = 2.0 * model.delta.cwiseProduct(velocity);
    if (model.coupling.size() > 0) force += model.coupling * velocity;
    return force;
  }

  // Throws InputError where a stop moves otherwise than the structure that follows the others.
  void check(const FollowedStops& followed, const std::vector<Harmonic>& motions) const {
    for (const Harmonic& c : sum_.value.carried) {
      Vector cosine = Vector::Zero(static_cast<Eigen::Index>(scene_.stops.size())), sine = cosine;
      for (const Harmonic& motion : motions) {
        if (motion.order != c.order) continue;
        cosine += motion.cosine;
        sine += motion.sine;
      }
      std::optional<std::size_t> left = followed.left_behind(c.cosine, cosine);
      if (!left) left = followed.left_behind(c.sine, sine);
      if (!left) continue;
      throw scene_error(
          scene_, numbered_path("stop", *left + 1) + ".motion",
          fmt::format("stop {} moves otherwise than the {} mode{} can while {} follow{} the stops "
                      "before it; stops of one place must move alike, and no more stops than modes "
                      "can move each by itself",
                      *left + 1, scene_.modes(), scene_.modes() == 1 ? "" : "s",
                      scene_.modes() == 1 ? "it" : "they", scene_.modes() == 1 ? "s" : ""));
    }
  }

  const Scene& scene_;
  const Scene* direction_;
  const ModalModel& model_;
  const ModalModel* rate_;
  double common_ = 1.0;
  std::size_t supports_ = 0;  // added so far
  bool moves_ = false;        // a stop does
  Rated<double> frequency_{}, phase_{};
  Rated<DrivenMotion> sum_;
};

}  // namespace

DrivenMotion driven_motion(const Scene& scene, const ModalModel& model) {
  return DriveSum(scene, model, nullptr, nullptr).sum().value;
}

DrivenMotion driven_motion_rate(const Scene& scene, const Scene& direction, const ModalModel& model,
                                const ModalModel& rate) {
  return DriveSum(scene, model, &direction, &rate).sum().rate;
}

}  // namespace graze
