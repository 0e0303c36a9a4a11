// The keys of forces on a structure, constant and harmonic (schema.hpp).
#pragma once

#include "graze/scene/detail/choices.hpp"
#include "graze/scene/detail/matrix_schema.hpp"
#include "graze/scene/key.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Where a force acts.
void describe_load_point(auto& v, auto& point, const Scene& scene, bool applies = true,
                         const char* otherwise = nullptr) {
  describe_point(
      v, point, scene,
      Key{"position", "m", own_rule("in [0, L]"), "where the force acts, from the left end"}.as(
          "a number in m from the left end"),
      Key{"shape", "kg^-1/2", kAny.told("N numbers"), "phi_j there"}.as(
          "a list of numbers, the mode shapes where the force acts"),
      applies, otherwise);
}

void describe(auto& v, Of<PointLoad> auto& load, const Scene& scene) {
  describe_load_point(v, load, scene);
  v.number({"force", "N", kAny, "constant, along +u"}, load.force);
}

void describe(auto& v, Of<DryFriction> auto& friction, const Scene& scene) {
  describe_load_point(v, friction, scene);
  const char* unpressed = "it goes with coefficient, without it it must be left out";
  v.number(Key{"force", "N", kNotNegative, "against sliding"}.needed(
               "or `coefficient` and `normal_force`"),
           friction.force);
  v.number(Key{"coefficient", "", kNotNegative, "mu, in place of `force`"}.or_else("none").where(
               !friction.force, "the force is given already, it must be left out"),
           friction.coefficient);
  const bool pressed = friction.coefficient.has_value();
  v.count(Key{"stop", "", kAtLeastOne.told("a stop with a spring"),
              "its number: in place of `normal_force` its spring presses there, and the force of "
              "friction is that part of the spring's"}
              .or_else("none")
              .where(pressed, unpressed),
          friction.stop);
  v.number(Key{"normal_force", "N", kNotNegative, "that presses there"}
               .needed("with `coefficient`, or `stop`")
               .where(pressed && friction.stop == 0,
                      pressed ? "the stop presses there, it must be left out" : unpressed),
           friction.normal_force);
  v.number(Key{"static_force", "N", kNotNegative, "up to which it sticks, at least that of sliding"}
               .or_else("`force`")
               .where(!pressed, "it is static_coefficient of a coefficient, it must be left out"),
           friction.static_force);
  v.number(Key{"static_coefficient", "", kNotNegative, "likewise"}
               .or_else("`coefficient`")
               .where(pressed, unpressed),
           friction.static_coefficient);
  v.number(Key{"speed", "m/s", kAny, "along +u, of a belt that rubs there"}.or_else(),
           friction.speed);
  v.number(Key{"parallel", "N/m", kNotNegative, "of a spring beside it"}.or_else(),
           friction.parallel);
  v.number(Key{"series", "N/m", kNotNegative,
               "of a spring between the place and what rubs (a Jenkins element); 0: none"}
               .or_else(),
           friction.series);
}

void describe(auto& v, Of<SignalSource> auto& signal, const Scene&) {
  const bool drawn = !signal.spectrum.empty();
  const char* of_file = "the signal is drawn from a spectrum, it must be left out";
  const char* of_spectrum = "it goes with a spectrum, without one it must be left out";
  const auto with_spectrum = [&](const Key& key) {
    return key.needed("with `spectrum`").where(drawn, of_spectrum);
  };
  v.path(Key{"spectrum", "", own_rule("a table"),
             "in place of `file`: rows of frequency (Hz) and spectral density (unit^2/Hz) under a "
             "row of names, joined by straight lines; the signal is a sum of harmonics of random "
             "phases that has this density"}
             .or_else("none"),
         signal.spectrum);
  v.path(Key{"file", "", own_rule("a table"),
             "rows of instants (s) and values under a row of names, joined by straight lines"}
             .needed("required without `spectrum`")
             .where(!drawn, of_file),
         signal.file);
  v.text(Key{"column", "", own_rule("a name"), "of the values or densities"}.or_else("the second"),
         signal.column);
  v.text(Key{"time", "", own_rule("a name"), "of the instants"}
             .or_else("the first")
             .where(!drawn, of_file),
         signal.time);
  v.choice(Key{"quantity", "", kAny,
               "what the values are where the load is of the kind `\"base\"`: accelerations of the "
               "clamp, or its displacements, which are joined by a cubic spline"}
               .or_else()
               .where(!drawn, of_file),
           signal.quantity, kBaseRecords);
  v.flag(Key{"repeat", "", kAny, "begin again behind the last instant; else the load is gone"}
             .or_else(),
         signal.repeats);
  v.choice(
      with_spectrum(Key{"sides", "", kAny,
                        "of the density: over frequencies from 0 on, or over negative ones too, "
                        "which doubles it"}
                        .or_else())
          .or_else(),
      signal.sides, kSpectrumSides);
  v.count(with_spectrum(Key{"seed", "", kSeed, "another one draws other phases"}).or_else("1"),
          signal.seed);
  v.number(with_spectrum(Key{"duration", "s", kPositive,
                             "of the course that is drawn, whose frequencies are multiples of 1 "
                             "over it"})
               .fixed(),
           signal.duration);
  v.number(with_spectrum(Key{"step", "s", kPositive,
                             "between its instants: half of the period of the highest frequency at "
                             "most"})
               .fixed(),
           signal.step);
}

// `frequency`: describes that of the load, behind its amplitude.
void describe_harmonic(auto& v, auto& forcing, const Scene& scene, const auto& frequency) {
  const bool modal = scene.modal() != nullptr;
  const Key kind =
      Key{"kind", "",
          own_rule("`\"point\"`; `\"base\"`; `\"distributed\"` with `[beam]`, `[string]` and "
                   "`[bar]` only; `\"modal\"` with `[modal]` only; `\"load\"` with "
                   "`[matrices]` only; `\"support\"` with `[lumped]` and "
                   "`[matrices]` only; `\"none\"`"),
          "point: a force at one point; base: displacement of the clamp and of all supports, "
          "or of the ground; distributed: force per length; modal: modal forces "
          "`participation` times amplitude; load: forces `load` times amplitude; support: "
          "displacement of "
          "the far end of the springs to the ground at one mass, or of a held degree of freedom or "
          "set; none: no force, "
          "only the frequency of stops that move"}
          .or_else(
              "`\"point\"` where a point is given, else `\"base\"`, with `[modal]` "
              "`\"modal\"`")
          .or_kept();
  if (scene.matrices())
    v.choice(kind, forcing.kind, kMatrixForcings);
  else if (scene.lumped())
    v.choice(kind, forcing.kind, kLumpedForcings);
  else if (modal)
    v.choice(kind, forcing.kind, kModalForcings);
  else
    v.choice(kind, forcing.kind, kBeamForcings);
  describe_load_point(v, forcing.at, scene, forcing.has_place(),
                      "forcing of this kind acts on all of the structure: forcing.kind must be "
                      "\"point\", or it must be left out");
  const bool timed = forcing.signal.has_value();
  const Key amplitude =
      Key{"amplitude", "m, N, N/m or 1, by kind", kAny,
          "of the cosine; of a signal its factor, 1 where it is left out"}
          .as(modal ? "a number" : "a number, in m (base), N (point) or N/m (distributed)")
          .where(forcing.kind != ForcingKind::kNone,
                 "forcing of the kind \"none\" has none, it must be left out");
  v.number(timed ? amplitude.or_else() : amplitude, forcing.amplitude);
  frequency();
  const char* of_signal = "a signal has none, it must be left out";
  v.number(Key{"order", "", kPositive,
               "of the force's frequency to Omega, a whole number or a ratio of small ones (0.5); "
               "the period is that of all loads together"}
               .or_else("1")
               .fixed()
               .where(!timed, of_signal),
           forcing.order);
  v.number(
      Key{"phase", "rad", kAny, "psi, forcing phase at t = 0"}.or_else().where(!timed, of_signal),
      forcing.phase);
  v.table({"signal", Form::kInline}, forcing.signal);
}

// It may be given in rad/s or in Hz. `frequency`: null where there is none.
void describe_frequency(auto& v, auto* frequency) {
  const bool in_hertz = frequency && frequency->in_hertz;
  MayHold angular(frequency && !in_hertz ? &frequency->written : nullptr);
  MayHold hertz(in_hertz ? &frequency->written : nullptr);
  v.number(Key{"frequency", "rad/s", kPositive,
               "Omega, of the first load; of another one in place of an order, where they have no "
               "common period"}
               .needed("required without `frequency_hz`")
               .where(bool(angular)),
           *angular);
  v.number(Key{"frequency_hz", "Hz", kPositive, "Omega/(2 pi); not with `units = \"none\"`"}
               .needed("in place of `frequency`")
               .where(bool(hertz)),
           *hertz);
}

void describe(auto& v, Of<HarmonicLoad> auto& forcing, const Scene& scene) {
  describe_harmonic(v, forcing, scene,
                    [&] { describe_frequency(v, forcing.own ? &*forcing.own : nullptr); });
}

void describe(auto& v, Of<Forcing> auto& forcing, const Scene& scene) {
  describe_harmonic(v, forcing, scene,
                    [&] { describe_frequency(v, forcing.signal ? nullptr : &forcing.frequency); });
}

}  // namespace graze
