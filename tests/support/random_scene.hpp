// Random scenes with everything that a hybrid motion can meet: modes over two decades of every
// damping, free masses, exact and near resonance, constant loads, stops on both sides with
// positive, zero and negative gaps, every restitution, both impulse laws. Each starts clear of its
// stops and reads back from its TOML text, so that a case that fails is its own reproduction.
//
// Sizes are random too: a rate `pace` (rad/s) and a displacement `reach` (m) set the scale.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/scene/reader.hpp"
#include "graze/system/system.hpp"
#include "support/systems.hpp"

namespace graze::support {

// A checked scene with what it assembles to.
struct Prepared {
  Scene scene;
  System system;
  State start;
};

// Nothing where the scene is not allowed or its motion cannot start.
inline std::optional<Prepared> prepared(const Scene& scene) {
  try {
    Prepared result{parse_scene(write_scene(scene), "random scene"), {}, {}};
    result.system = assemble(result.scene);
    result.start = initial_state(result.scene, result.system);
    return result;
  } catch (const InputError&) {
    return {};
  }
}

// What the motion is counted in, s: the forcing period, else the slowest oscillation, else the fall
// through the widest gap.
inline double time_unit(const Prepared& prepared) {
  const System& system = prepared.system;
  if (system.forcing()) return system.first_period();
  double slowest = 0.0;
  for (const double omega : system.omega)
    if (omega > 0.0 && (slowest == 0.0 || omega < slowest)) slowest = omega;
  if (slowest > 0.0) return 2.0 * std::numbers::pi / slowest;
  double unit = 0.0;
  for (const Stop& stop : system.stops) {
    const double gap = std::abs(stop.gap) + std::abs(stop.row.dot(prepared.start.q));
    const double speed = std::abs(stop.row.dot(prepared.start.qdot));
    const double push = system.load() ? std::abs(stop.row.dot(*system.load())) : 0.0;
    if (speed > 0.0) unit = std::max(unit, gap / speed);
    if (push > 0.0)
      unit = std::max(unit, std::max(std::sqrt(2.0 * gap / push), 2.0 * speed / push));
  }
  return unit > 0.0 ? unit : 1.0;
}

class RandomScene {
 public:
  explicit RandomScene(Dice& dice) : dice_(dice) {}

  // Draws until a scene is allowed.
  Scene draw() {
    for (;;) {
      Scene scene = chance(0.3) ? beam_scene() : modal_scene();
      if (scene.forcing && chance(0.25)) add_loads(scene);
      if (scene.forcing && chance(0.2)) move_stops(scene);
      if (const auto usable = prepared(scene)) return usable->scene;
    }
  }

 private:
  bool chance(double probability) { return dice_.uniform(0.0, 1.0) < probability; }
  double log_uniform(double low, double high) {
    return low * std::pow(high / low, dice_.uniform(0.0, 1.0));
  }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  std::vector<double> list(int size, double scale) {
    std::vector<double> values;
    for (int j = 0; j < size; ++j) values.push_back(scale * dice_.uniform(-1.0, 1.0));
    return values;
  }

  Scene modal_scene() {
    modes_ = 1 + dice_.pick(8);
    pace_ = log_uniform(0.1, 100.0);
    reach_ = log_uniform(1e-3, 10.0);
    unit_ = 1.0;
    Scene scene;
    ModalStructure modal;
    for (int j = 0; j < modes_; ++j)
      modal.frequencies.push_back(chance(0.08) ? 0.0 : pace_ * log_uniform(1.0, 100.0));
    if (chance(0.7)) scene.forcing = modal_forcing(modal);
    if (chance(0.35)) {
      modal.inertia = list(modes_, 1.0);
      scene.gravity = Gravity{sign() * reach_ * pace_ * pace_ * log_uniform(0.03, 3.0)};
    }
    if (chance(0.8)) scene.damping = damping();
    frequencies_ = modal.frequencies;
    scene.structure = modal;
    const int stops = stop_count();
    for (int i = 0; i < stops; ++i) {
      SceneStop stop;
      const SceneStop* before = i > 0 ? &scene.stops.back() : nullptr;
      if (before && chance(0.35)) {
        stop.shape = before->shape;
        stop.side = chance(0.8) == (before->side == Side::kAbove) ? Side::kBelow : Side::kAbove;
      } else {
        stop.shape = list(modes_, chance(0.5) ? 1.0 : log_uniform(0.1, 10.0));
        if (chance(0.15)) stop.shape = single_mode(stop.shape);
        stop.side = chance(0.5) ? Side::kAbove : Side::kBelow;
      }
      set_gap_and_restitution(stop);
      scene.stops.push_back(stop);
    }
    set_start(scene);
    return scene;
  }

  Scene beam_scene() {
    modes_ = 1 + dice_.pick(8);
    Scene scene;
    Beam beam;
    beam.length = log_uniform(0.1, 3.0);
    const double height = beam.length * log_uniform(1e-3, 1e-2);
    beam.youngs_modulus = 205e9;
    beam.density = 8500.0;
    beam.area = 0.05 * beam.length * height;
    beam.second_moment = *beam.area * height * height / 12.0;
    beam.modes = modes_;
    beam.discretisation = chance(0.5) ? Projection::kGalerkin : Projection::kCollocation;
    if (chance(0.1)) beam.points = random_points(beam.length);
    pace_ = 3.516 * height * std::sqrt(beam.youngs_modulus / (12.0 * beam.density)) /
            (beam.length * beam.length);
    reach_ = beam.length * log_uniform(1e-4, 1e-2);
    unit_ = 0.5 * std::sqrt(beam.density * *beam.area * beam.length);
    scene.structure = beam;
    frequencies_.clear();
    for (int j = 0; j < modes_; ++j) {
      const double number = (j + 0.5) * std::numbers::pi;
      frequencies_.push_back(j == 0 ? pace_ : pace_ * number * number / 3.516);
    }
    if (chance(0.8)) scene.damping = damping();
    if (scene.damping && chance(0.4))
      scene.damping =
          ViscousDamping{2.0 * beam.density * *beam.area * pace_ * log_uniform(1e-4, 0.3)};
    if (chance(0.7)) scene.forcing = beam_forcing(beam);
    if (chance(0.35))
      scene.gravity = Gravity{sign() * reach_ * pace_ * pace_ * log_uniform(0.03, 3)};
    const Impulse impulse = chance(0.5) ? Impulse::kMomentum : Impulse::kCollocation;
    const int stops = stop_count();
    for (int i = 0; i < stops; ++i) {
      SceneStop stop;
      stop.impulse = impulse;
      stop.position = stop_position(beam, impulse);
      if (i > 0 && chance(0.3)) stop.position = scene.stops.back().position;
      stop.side = chance(0.5) ? Side::kAbove : Side::kBelow;
      set_gap_and_restitution(stop);
      scene.stops.push_back(stop);
    }
    set_start(scene);
    return scene;
  }

  double stop_position(const Beam& beam, Impulse impulse) {
    if (impulse == Impulse::kMomentum)
      return chance(0.5) ? beam.length : beam.length * dice_.uniform(0.1, 1.0);
    const int point = chance(0.5) ? modes_ : 1 + dice_.pick(modes_);
    if (!beam.points.empty()) return beam.points[static_cast<std::size_t>(point - 1)];
    return point == modes_ ? beam.length : point * beam.length / modes_;
  }

  std::vector<double> random_points(double length) {
    std::vector<double> points;
    for (int j = 0; j < modes_; ++j) points.push_back(length * dice_.uniform(0.05, 1.0));
    std::sort(points.begin(), points.end());
    return points;
  }

  // Between 0 and 3, most often one.
  int stop_count() {
    const double u = dice_.uniform(0.0, 1.0);
    return u < 0.05 ? 0 : u < 0.55 ? 1 : u < 0.8 ? 2 : 3;
  }

  std::vector<double> single_mode(std::vector<double> shape) {
    const auto kept = static_cast<std::size_t>(dice_.pick(modes_));
    for (std::size_t j = 0; j < shape.size(); ++j)
      if (j != kept) shape[j] = 0.0;
    return shape;
  }

  double forcing_frequency(const std::vector<double>& frequencies) {
    const auto mode = static_cast<std::size_t>(dice_.pick(modes_));
    if (frequencies[mode] > 0.0 && chance(0.25)) {
      constexpr double kDetunings[] = {0.0, 1e-12, 1e-8, 1e-4, 1e-2};
      return frequencies[mode] * (1.0 + sign() * kDetunings[dice_.pick(5)]);
    }
    return pace_ * log_uniform(0.3, 30.0);
  }

  // Every mode moves by `reach` or less, but at resonance.
  Forcing modal_forcing(ModalStructure& modal) {
    Forcing forcing;
    forcing.kind = ForcingKind::kModal;
    forcing.frequency = forcing_frequency(modal.frequencies);
    forcing.phase = chance(0.3) ? 0.0 : dice_.uniform(0.0, 2.0 * std::numbers::pi);
    forcing.amplitude = reach_ * forcing.frequency * forcing.frequency;
    const double stiffness_weight = chance(0.5) ? 0.0 : dice_.uniform(0.0, 2.0);
    modal.participation = list(modes_, 1.0);
    for (int j = 0; j < modes_; ++j) {
      const auto k = static_cast<std::size_t>(j);
      modal.participation[k] *=
          std::pow(std::max(modal.frequencies[k] / forcing.frequency, 1.0), stiffness_weight);
    }
    return forcing;
  }

  // At multiples of the first one's frequency, as strong as that.
  void add_loads(Scene& scene) {
    constexpr double kOrders[] = {0.5, 1.0, 1.5, 2.0, 3.0, 5.0};
    const int count = 1 + dice_.pick(2);
    for (int i = 0; i < count; ++i) {
      HarmonicLoad load = *scene.forcing;
      load.order = kOrders[dice_.pick(6)];
      load.phase = dice_.uniform(0.0, 2.0 * std::numbers::pi);
      load.amplitude *= dice_.uniform(-1.0, 1.0);
      if (load.kind == ForcingKind::kModal) {
        load.kind = ForcingKind::kPoint;
        load.at.shape = list(modes_, 1.0);
      }
      if (chance(0.1)) {
        load.own = Frequency{scene.forcing->frequency * dice_.uniform(0.3, 3.0)};
        load.order.reset();
      }
      scene.further.push_back(load);
    }
  }

  // By up to some of the reach; a scene whose modes cannot follow all of them is drawn again.
  void move_stops(Scene& scene) {
    constexpr double kOrders[] = {0.5, 1.0, 1.5, 2.0, 3.0};
    for (SceneStop& stop : scene.stops) {
      if (chance(0.3)) {
        stop.frame = StopFrame::kSpace;
        continue;
      }
      for (int i = dice_.pick(3); i > 0; --i)
        stop.motion.push_back({reach_ * dice_.uniform(-0.3, 0.3), kOrders[dice_.pick(5)],
                               dice_.uniform(0.0, 2.0 * std::numbers::pi)});
    }
  }

  Forcing beam_forcing(const Beam& beam) {
    Forcing forcing;
    forcing.kind = chance(0.6) ? ForcingKind::kBase : ForcingKind::kDistributed;
    forcing.frequency = forcing_frequency(frequencies_);
    forcing.phase = chance(0.3) ? 0.0 : dice_.uniform(0.0, 2.0 * std::numbers::pi);
    forcing.amplitude = reach_;
    if (forcing.kind == ForcingKind::kDistributed)
      forcing.amplitude *= beam.density * *beam.area * pace_ * pace_;
    return forcing;
  }

  Damping damping() {
    const double kind = dice_.uniform(0.0, 1.0);
    if (kind < 0.25) return RayleighDamping{pace_ * log_uniform(1e-3, 0.5), 0.0};
    if (kind < 0.5)
      return RayleighDamping{pace_ * log_uniform(1e-3, 0.3), log_uniform(1e-5, 0.05) / pace_};
    DampingRatios ratios;
    for (int j = 0; j < modes_; ++j) ratios.ratios.push_back(damping_ratio());
    if (kind < 0.65) ratios.ratios.assign(ratios.ratios.size(), ratios.ratios.front());
    return ratios;
  }

  double damping_ratio() {
    switch (dice_.pick(10)) {
      case 0:
        return 0.0;
      case 1:
        return 1.0;
      case 2:
        return 1.0 + 1e-6 * dice_.uniform(-1.0, 1.0);
      case 3:
        return dice_.uniform(1.0, 4.0);
      case 4:
      case 5:
        return dice_.uniform(0.0, 0.5);
      default:
        return log_uniform(1e-4, 0.1);
    }
  }

  void set_gap_and_restitution(SceneStop& stop) {
    const double kind = dice_.uniform(0.0, 1.0);
    if (kind < 0.7)
      stop.gap = reach_ * log_uniform(0.003, 3.0);
    else if (kind > 0.85)
      stop.gap = -reach_ * log_uniform(0.01, 0.5);
    const double law = dice_.uniform(0.0, 1.0);
    if (law < 0.15) {
      stop.restitution = {0.0};
    } else if (law < 0.25) {
      stop.restitution = {1.0};
    } else if (law < 0.75) {
      stop.restitution = {dice_.uniform(0.0, 1.0)};
    } else {
      const double slowness = 1.0 / (reach_ * pace_);  // s/m
      stop.restitution = {chance(0.2) ? 1.0 : dice_.uniform(0.3, 1.0),
                          slowness * log_uniform(0.01, 1.0)};
      if (chance(0.4)) stop.restitution.push_back(slowness * slowness * dice_.uniform(-0.02, 0.1));
    }
  }

  // At rest, or anywhere clear of the stops.
  void set_start(Scene& scene) {
    if (chance(0.4)) return;
    Initial initial{list(modes_, reach_ * unit_), list(modes_, reach_ * unit_)};
    for (int j = 0; j < modes_; ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double soft = pace_ / std::max(frequencies_[k], pace_);
      initial.q[k] *= std::pow(soft, 1.0 + dice_.uniform(0.0, 1.0));
      initial.qdot[k] *= pace_ * std::pow(soft, dice_.uniform(0.0, 1.0));
    }
    if (chance(0.2)) initial.qdot.assign(initial.qdot.size(), 0.0);
    scene.initial = initial;
    move_clear(scene);
  }

  // Projects q onto the half-spaces of the stops in turn, with a little to spare.
  void move_clear(Scene& scene) {
    Scene trial = scene;
    trial.initial.reset();
    for (SceneStop& stop : trial.stops) stop.gap = 0.0;
    const auto rows = prepared(trial);
    if (!rows) return;
    Eigen::Map<Vector> q(scene.initial->q.data(), modes_);
    const double spare = 1e-3 * reach_;
    for (int pass = 0; pass < 200; ++pass)
      for (std::size_t i = 0; i < scene.stops.size(); ++i) {
        const Vector& row = rows->system.stops[i].row;
        const double beyond = row.dot(q) - scene.stops[i].gap;
        if (beyond > 0.0) q -= row * ((beyond + spare) / row.squaredNorm());
      }
  }

  Dice& dice_;
  int modes_ = 1;
  double pace_ = 1.0;   // rad/s
  double reach_ = 1.0;  // m
  double unit_ = 1.0;   // kg^1/2, of a coordinate that moves a stop by about its own size
  std::vector<double> frequencies_;
};

}  // namespace graze::support
