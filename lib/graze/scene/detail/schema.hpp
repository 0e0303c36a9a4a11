// The keys of a scene, each described once: name, unit, range, meaning and its member of the
// struct. Reader, writer, check, parameters and the reference in docs/scenes.md use it: each passes
// a visitor (derived from SchemaVisitor) to describe(), which calls it for every key. Rules between
// keys are in check.cpp.
#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "graze/scene/detail/choices.hpp"
#include "graze/scene/detail/load_schema.hpp"
#include "graze/scene/detail/matrix_schema.hpp"
#include "graze/scene/detail/structure_schema.hpp"
#include "graze/scene/key.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// The numbers of both bodies as the scene lists them, and which lengths such a list may have.
std::vector<double> body_numbers(const SpringGeometry& geometry, BodyNumbers which);
bool set_body_numbers(SpringGeometry& geometry, BodyNumbers which,
                      const std::vector<double>& numbers);

void describe(auto& v, Of<Torque> auto& torque, const Scene&) {
  TorqueKind kind =
      std::holds_alternative<TorquePulse>(torque) ? TorqueKind::kPulse : TorqueKind::kTable;
  const TorqueKind before = kind;
  v.choice({"kind", "", kAny, "constant for a while, or through the points of a table"}, kind,
           kTorqueKinds);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(torque)>>) {
    if (kind != before) torque = kind == TorqueKind::kPulse ? Torque(TorquePulse{}) : TorqueTable{};
  }
  MayHold pulse(std::get_if<TorquePulse>(&torque));
  MayHold table(std::get_if<TorqueTable>(&torque));
  const auto of_kind = [](const Key& key, bool held, const char* refusal, const char* needed) {
    return key.needed(needed).where(held, refusal);
  };
  const char* no_pulse = "a torque of the kind \"table\" has none, it must be left out";
  const char* no_table = "a torque of the kind \"pulse\" has none, it must be left out";
  v.number(of_kind({"amplitude", "N m", kAny, "of a pulse, from t = 0 on"}, bool(pulse), no_pulse,
                   "required with `\"pulse\"`"),
           pulse->amplitude);
  v.number(of_kind({"duration", "s", kPositive, "of a pulse, which is then gone"}, bool(pulse),
                   no_pulse, "required with `\"pulse\"`"),
           pulse->duration);
  v.file(of_kind({"file", "", own_rule("a name"), "of a CSV file with times and values"},
                 bool(table), no_table, "in place of `times` and `values`"),
         *table);
  v.list(of_kind({"times", "s", own_rule("rising numbers >= 0"), "at which a table has its points"},
                 bool(table), no_table, "required with `\"table\"`")
             .as("a list of numbers in s")
             .fixed(),
         table->times);
  v.list(of_kind({"values", "N m", own_rule("one number per time"), "of a table"}, bool(table),
                 no_table, "required with `\"table\"`")
             .as("a list of numbers in N m, one per time")
             .fixed(),
         table->values);
}

// The table of a hub's friction holds one number.
void describe(auto& v, Of<double> auto& friction, const Scene&) {
  v.number({"coulomb", "N m", kNotNegative, "Coulomb friction at the joint"}, friction);
}

void describe(auto& v, Of<Hub> auto& hub, const Scene&) {
  v.number({"radius", "m", kNotNegative, "from the hub's centre to the clamp"}, hub.radius);
  v.number({"inertia", "kg m^2", kNotNegative, "of the hub alone"}, hub.inertia);
  v.table({"torque", Form::kInline}, hub.torque);
  v.choice(Key{"equations", "", kAny,
               "consistent: conserve energy; paper: as printed in Yigit, Ulsoy & Scott (1990), "
               "without two terms of the hub's equation"}
               .or_else(),
           hub.equations, kHubEquations);
  v.flag(Key{"centrifugal", "", kAny,
             "terms with the square of the rate, and the change of the inertia by the deflection"}
             .or_else(),
         hub.centrifugal);
  v.table({"friction", Form::kInline}, hub.friction);
}

void describe(auto& v, Of<RayleighDamping> auto& rayleigh, const Scene&) {
  v.number({"mass", "1/s", kNotNegative, "delta_j = (mass + stiffness w_j^2)/2"}, rayleigh.mass);
  v.number({"stiffness", "s", kNotNegative, "in the same sum"}, rayleigh.stiffness);
}

void describe(auto& v, Of<Damping> auto& damping, const Scene&) {
  MayHold viscous(std::get_if<ViscousDamping>(&damping));
  MayHold ratios(std::get_if<DampingRatios>(&damping));
  MayHold ratio(std::get_if<DampingRatio>(&damping));
  v.number(Key{"viscous", "N s/m^2", kNotNegative,
               "eta, force per length per velocity relative to the clamp; not with `[modal]`, nor "
               "where the mass per length m varies or masses are attached. delta_j = eta/(2 m)"}
               .needed("none")
               .where(bool(viscous)),
           viscous->coefficient);
  v.number(
      Key{"ratio", "", kNotNegative, "delta_j/w_j, the same of all modes"}.needed("none").where(
          bool(ratio)),
      ratio->ratio);
  v.list(Key{"ratios", "", kNotNegative.told("N numbers >= 0"), "delta_j/w_j"}
             .needed("none")
             .where(bool(ratios))
             .as("a list of numbers, one per mode"),
         ratios->ratios);
  v.table({"rayleigh", Form::kInline}, std::get_if<RayleighDamping>(&damping));
}

void describe(auto& v, Of<Gravity> auto& gravity, const Scene&) {
  v.number({"acceleration", "m/s^2", kAny,
            "along +u, so negative where u counts upwards; with a `[hub]` along -u at angle 0, and "
            "there it stays while the beam turns"},
           gravity.acceleration);
}

void describe(auto& v, Of<SpringDamping> auto& damping, const Scene&) {
  v.choice(Key{"model", "", kAny, "T(x), see below"}.as("the name of a model of damping"),
           damping.model, kContactModels);
  const auto number = [&](const Key& key, auto& value) {
    v.number(key.or_else("by model"), value);
  };
  number({"coefficient", "by model", kNotNegative, "C"}, damping.coefficient);
  number({"ratio", "", kNotNegative, "zeta"}, damping.ratio);
  number({"alpha", "s/m", kNotNegative, "of e = 1 - alpha v"}, damping.alpha);
  number({"restitution", "", kUpToOne, "e that is asked for"}, damping.restitution);
  number({"speed", "m/s", kPositive, "v at which it is asked for"}, damping.speed);
  number({"mass", "kg", kPositive, "m that meets the stop"}, damping.mass);
  number({"onset", "m", kPositive, "depth over which `\"lee-wang-2\"` and `\"adams\"` set in"},
         damping.onset);
  number({"sharpness", "", kNotNegative, "Q of `\"lee-wang-2\"`, 3 where it is not given"},
         damping.sharpness);
  v.choice(
      Key{"inversion", "", kAny, "exact: C gives e itself, not by the model's formula"}.or_else(),
      damping.exact, kInversions);
}

void describe(auto& v, Of<Spring> auto& spring, const Scene&) {
  MayHold geometry(spring.geometry ? &*spring.geometry : nullptr);
  const bool given = bool(geometry);
  const char* follows = "it follows from radii, moduli and poisson, it must be left out with them";
  v.number_or(Key{"stiffness", "N/m^exponent", kPositive.told("> 0, or `\"residual\"`"),
                  "k; residual: 1/k is what the modes left out give way at the stop, exponent 1"}
                  .where(!given, follows)
                  .or_ignored(),
              spring.stiffness, spring.is_residual, "residual");
  v.number(Key{"exponent", "", kAtLeastOne, "n: 1 linear, 1.5 Hertz"}
               .or_else()
               .where(!given && !spring.is_residual,
                      given ? follows
                            : "the modes left out give way in proportion to the force, it must be "
                              "left out with \"residual\"")
               .or_ignored(),
           spring.exponent);
  v.bodies(Key{"radii", "m", own_rule("two, of balls, or four, in two planes body by body"),
               "Hertz's k and n = 3/2 from geometry; `inf` is flat, negative hollow"}
               .needed("in place of `stiffness` and `exponent`")
               .where(given)
               .as("a list of two numbers in m, or of four"),
           *geometry, BodyNumbers::kRadii);
  v.bodies(Key{"moduli", "Pa", kPositive.told("two numbers > 0"), "of the two bodies"}
               .needed("with `radii`")
               .where(given)
               .as("a list of two numbers in Pa"),
           *geometry, BodyNumbers::kModuli);
  v.bodies(Key{"poisson", "", kPoissonRatio.told("two numbers in (-1, 0.5]"), "of the two bodies"}
               .needed("with `radii`")
               .where(given)
               .as("a list of two numbers"),
           *geometry, BodyNumbers::kPoissonRatios);
  v.number(Key{"angle", "rad", kAny, "between the first planes of the bodies"}
               .or_else()
               .where(given, "it needs radii, moduli and poisson")
               .fixed(),
           geometry->angle);
  v.table({"damping", Form::kInline}, spring.damping);
  v.choice(Key{"release", "", kAny,
               "the contact ends where the force is gone, or where the depth is (the force may "
               "then pull at last)"}
               .or_else(),
           spring.release, kReleases);
}

void describe(auto& v, Of<StopMotion> auto& motion, const Scene&) {
  v.number({"amplitude", "m", kAny, "of the cosine, along u"}, motion.amplitude);
  v.number(Key{"order", "", kPositive, "as of a load"}.or_else("1").fixed(), motion.order);
  v.number(Key{"phase", "rad", kAny, "at t = 0"}.or_else(), motion.phase);
}

void describe(auto& v, Of<SceneStop> auto& stop, const Scene& scene) {
  const bool rigid = !stop.spring;
  const char* none = "a stop with a spring has none, it must be left out";
  describe_point(v, stop, scene,
                 Key{"position", "m", own_rule("in [0, L], where nothing holds it"),
                     "B, distance from the left end; with the collocation impulse it must be a "
                     "collocation point"}
                     .as("a number in m from the clamp"),
                 Key{"shape", "kg^-1/2", kAny.told("N numbers, not all 0"),
                     "phi_j(B): how far each mode moves the point of contact"}
                     .as("a list of numbers, the mode shapes at the stop"));
  v.number({"gap", "m", kAny, "a; 0 touches at rest, negative is a preload"}, stop.gap);
  v.choice(Key{"side", "", kAny, "above: free while u < gap; below: free while u > -gap"}.or_else(),
           stop.side, kSides);
  v.series(Key{"restitution", "", kFraction.told("0 to 1, or a list"), "r, v+ = -r v-"}
               .needed("required without `[stop.spring]`")
               .where(rigid, none)
               .as("a number from 0 to 1 or a list [a0, a1, ..] of numbers"),
           stop.restitution);
  v.choice(Key{"impulse", "", own_rule("or `\"collocation\"` (`[beam]` only)"),
               "the impulse law, the same for all stops; the collocation law can add kinetic "
               "energy"}
               .or_else()
               .where(rigid, none),
           stop.impulse, kImpulses);
  v.choice(Key{"frame", "", kAny,
               "clamp: the stop is shaken with the clamp, the supports or the ground; space: it "
               "stays in space while forcing of the kind `\"base\"` shakes these"}
               .or_else(),
           stop.frame, kFrames);
  v.table({"spring"}, stop.spring);
  v.tables({"motion"}, stop.motion);
}

void describe(auto& v, Of<Probe> auto& probe, const Scene& scene) {
  describe_point(v, probe, scene,
                 Key{"position", "m", own_rule("in [0, L]"), "distance from the left end"}.as(
                     "a number in m from the clamp"),
                 Key{"shape", "kg^-1/2", kAny.told("N numbers"), "phi_j there"}.as(
                     "a list of numbers, the mode shapes at the probe"),
                 !is_of_hub(probe.quantity),
                 "angle and rate are those of the hub, it must be left out");
  v.choice(Key{"quantity", "", kAny,
               "displacement (m) and velocity (m/s) of the point, relative to the clamp, with a "
               "`[hub]` along its arc from angle 0 on; deflection (m) from the line that turns "
               "with the hub, without one the displacement; strain: -h/2 u'', of the fibre at half "
               "the thickness on the side of +u (`[beam]`), or u' (`[bar]`); angle (rad) and rate "
               "(rad/s) of "
               "the `[hub]`, without `position`"}
               .or_else(),
           probe.quantity, kQuantities);
}

void describe(auto& v, Of<Initial> auto& initial, const Scene& scene) {
  const bool hub = scene.hub.has_value();
  const char* none = "it is that of a [hub], without one it must be left out";
  const bool own = scene.lumped() || (scene.matrices() && !scene.matrices()->mass_entries.empty());
  const bool spans = scene.span() && !hub;
  const auto of_own = [&](const Key& key) {
    return key.or_else("none").where(
        own || spans,
        "it is that of [lumped], of matrices in the scene or of a span that does not turn, it must "
        "be left out");
  };
  v.choice(Key{"at", "", kAny, "equilibrium: displacements are those at rest under constant loads"}
               .or_else()
               .where(!hub, "a structure on a hub has none, it must be left out"),
           initial.in_equilibrium, kStarts);
  v.values(Key{"positions", "m", own_rule("rising, 0..L"),
               "of a beam, string or bar: where it has the displacements and velocities that "
               "follow, linear between these places and even beyond them"}
               .or_else("none")
               .where(spans, "they are those of a span that does not turn, it must be left out")
               .as("a list of numbers in m"),
           initial.positions);
  const Key displacement =
      of_own(Key{"displacement", "m", own_rule("one for each"),
                 "of the masses or degrees of freedom, or at the positions"})
          .as("a list of numbers in m, one for each mass, degree of freedom or position");
  v.values(initial.in_equilibrium
               ? displacement.where(false, "it is that at rest, it must be left out")
               : displacement,
           initial.displacement);
  v.values(of_own(Key{"velocity", "m/s", own_rule("one for each"), "their rates"})
               .as("a list of numbers in m/s, one for each mass, degree of freedom or position"),
           initial.velocity);
  v.number(Key{"speed", "m/s", kAny, "of the whole structure along +u, in addition"}
               .or_else("none")
               .where(!hub, "a structure on a hub starts with its rate, it must be left out"),
           initial.speed);
  v.list(Key{"q", "kg^1/2 m", kAny.told("N numbers"),
             "modal coordinates; the point of contact may touch its stop, not lie beyond a rigid "
             "one; a compliant one it compresses there"}
             .or_zeros()
             .where(initial.displacement.empty() && !initial.in_equilibrium,
                    "the displacements are given already, it must be left out")
             .or_ignored(),
         initial.q);
  v.list(
      Key{"qdot", "kg^1/2 m/s", kAny.told("N numbers"), "their rates"}
          .or_zeros()
          .where(initial.velocity.empty(), "the velocities are given already, it must be left out")
          .or_ignored(),
      initial.qdot);
  v.number(
      Key{"angle", "rad", kAny, "of the `[hub]`; left out without one"}.or_else().where(hub, none),
      initial.angle);
  v.number(
      Key{"rate", "rad/s", kAny, "of the `[hub]`; left out without one"}.or_else().where(hub, none),
      initial.rate);
}

void describe(auto& v, Of<Solver> auto& solver, const Scene&) {
  v.choice(
      Key{"flow", "",
          own_rule("`\"auto\"`, `\"exact\"`, `\"rk4\"`, `\"dopri5\"`, `\"fehlberg78\"`, with a "
                   "`[hub]` `\"bulirsch-stoer\"` in place of `\"exact\"`"),
          "`exact`: closed forms, every contact certified. The others take steps and see a contact "
          "by the sign of a gap at the end of a step: what comes and goes within one they miss. "
          "They are there to be compared with ([accuracy.md](accuracy.md)). `auto` takes `exact`, "
          "and with a `[hub]` `bulirsch-stoer`, extrapolation to 1e-14 a step"}
          .or_else(),
      solver.flow, kFlows);
  v.number(
      Key{"tolerance", "", kWithinOne,
          "error of a step of `dopri5` and `fehlberg78` without `step`, relative to the speed of "
          "the motion; with any flow it sets the closure speed of chatters (`--closure-speed`)"}
          .or_else(),
      solver.tolerance);
  v.number(Key{"step", "s", kPositive,
               "length of all steps; needed with `rk4`, possible with `dopri5` and `fehlberg78`, "
               "refused with the others. Steps at which the quickest mode would grow without bound "
               "are refused with the limit: 2.828/w_N (`rk4`), 0.997/w_N (`dopri5`), 2.365/w_N "
               "(`fehlberg78`), less for `rk4` where damping is strong"}
               .or_else("none"),
           solver.step);
}

void describe(auto& v, Of<Scene> auto& scene) {
  v.text(Key{"title", "", own_rule("a string"), "heads the output of `check`"}.or_else("none"),
         scene.title);
  v.choice(Key{"units", "", kAny,
               "none: the numbers are pure ones, and results are told without units; the units in "
               "this reference then only tell how they belong together"}
               .or_else(),
           scene.units, kUnitWords);
  v.table({"beam"}, std::get_if<Beam>(&scene.structure));
  v.table({"string"}, std::get_if<TautString>(&scene.structure));
  v.table({"bar"}, std::get_if<Bar>(&scene.structure));
  v.table({"hub"}, scene.hub);
  v.table({"modal"}, std::get_if<ModalStructure>(&scene.structure));
  v.table({"matrices"}, std::get_if<MatrixStructure>(&scene.structure));
  v.table({"lumped"}, std::get_if<LumpedStructure>(&scene.structure));
  v.table({"damping"}, scene.damping);
  v.leading({"forcing"}, scene.forcing, scene.further);
  v.table({"gravity"}, scene.gravity);
  v.tables({"load"}, scene.loads);
  v.tables({"stop"}, scene.stops);
  v.tables({"friction"}, scene.frictions);
  v.tables({"probe", Form::kHeader, false}, scene.probes);
  v.table({"initial", Form::kHeader, false}, scene.initial);
  v.table({"solver", Form::kHeader, false}, &scene.solver);
}

}  // namespace graze
