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

// `frequency`: describes that of the first load, behind its amplitude.
void describe_harmonic(auto& v, auto& forcing, const Scene& scene, const auto& frequency) {
  const bool modal = scene.modal() != nullptr;
  const Key kind =
      Key{"kind", "",
          own_rule("`\"point\"`; `\"base\"`; `\"distributed\"` with `[beam]`, `[string]` and "
                   "`[bar]` only; `\"modal\"` with `[modal]` only; `\"load\"` with "
                   "`[matrices]` only"),
          "point: a force at one point; base: displacement of the clamp and of all supports, "
          "or of the ground; distributed: force per length; modal: modal forces "
          "`participation` times amplitude; load: forces `load` times amplitude"}
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
  describe_load_point(v, forcing.at, scene, forcing.kind == ForcingKind::kPoint,
                      "forcing of this kind acts on all of the structure: forcing.kind must be "
                      "\"point\", or it must be left out");
  v.number(Key{"amplitude", "m, N, N/m or 1, by kind", kAny, "of the cosine"}.as(
               modal ? "a number" : "a number, in m (base), N (point) or N/m (distributed)"),
           forcing.amplitude);
  frequency();
  v.number(Key{"order", "", kPositive,
               "of the force's frequency to Omega, a whole number or a ratio of small ones (0.5); "
               "the period is that of all loads together"}
               .or_else("1")
               .fixed(),
           forcing.order);
  v.number(Key{"phase", "rad", kAny, "psi, forcing phase at t = 0"}.or_else(), forcing.phase);
}

void describe(auto& v, Of<HarmonicLoad> auto& forcing, const Scene& scene) {
  describe_harmonic(v, forcing, scene, [] {});
}

void describe(auto& v, Of<Forcing> auto& forcing, const Scene& scene) {
  describe_harmonic(v, forcing, scene, [&] {
    // The frequency may be given in rad/s or in Hz.
    const bool in_hertz = forcing.frequency.in_hertz;
    MayHold angular(in_hertz ? nullptr : &forcing.frequency.written);
    MayHold hertz(in_hertz ? &forcing.frequency.written : nullptr);
    v.number(Key{"frequency", "rad/s", kPositive, "Omega, once, of the first load"}
                 .needed("required without `frequency_hz`")
                 .where(bool(angular)),
             *angular);
    v.number(Key{"frequency_hz", "Hz", kPositive, "Omega/(2 pi); not with `units = \"none\"`"}
                 .needed("in place of `frequency`")
                 .where(bool(hertz)),
             *hertz);
  });
}

}  // namespace graze
