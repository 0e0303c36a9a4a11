// Scenes whose motion rests on a rigid stop while it compresses a spring.
#pragma once

#include <string>
#include <vector>

#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze::support {

// Two modes, a linear spring with a dashpot: its force sets in with a jump.
inline Scene held_against_dashpot() {
  return parse_scene(
      "title = \"held against a dashpot\"\n"
      "[modal]\nfrequencies = [1.0, 2.7]\ndamping_ratios = [0.05, 0.05]\n"
      "participation = [1.0, 0.5]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.4\n"
      "[[stop]]\nshape = [1.0, 0.6]\ngap = 0.1\nrestitution = 0.2\n"
      "[[stop]]\nshape = [0.3, -1.1]\ngap = 0.05\n"
      "[stop.spring]\nstiffness = 60.0\nexponent = 1.0\n"
      "damping = { model = \"kelvin-voigt\", restitution = 0.5, mass = 1.0, inversion = \"exact\" "
      "}\n",
      "held_against_dashpot.toml");
}

// Three modes, drawn at random, and an elastic ball.
inline Scene held_against_ball() {
  return parse_scene(
      "title = \"held against a ball\"\n"
      "[modal]\nfrequencies = [1.0, 2.31, 4.9]\ndamping_ratios = [0.08, 0.05, 0.04]\n"
      "participation = [1.0, 0.37, -0.22]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.31\n"
      "[[stop]]\nshape = [1.0, 0.43, 0.28]\ngap = 0.12\nrestitution = 0.17\n"
      "[[stop]]\nshape = [0.52, -0.81, 0.33]\ngap = 0.02\n"
      "[stop.spring]\nstiffness = 35.0\nexponent = 1.5\n",
      "held_against_ball.toml");
}

// A beam by collocation: what holds it is oblique.
inline Scene held_beam() {
  return parse_scene(
      "title = \"a beam held on its tip and pressed against a ball\"\n"
      "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
      "density = 8500.0\narea = 12.4e-6\nmodes = 3\ndiscretisation = \"collocation\"\n"
      "[damping]\nviscous = 0.2\n"
      "[forcing]\nkind = \"base\"\namplitude = 2.5e-3\nfrequency = 20.0\n"
      "[[stop]]\nposition = 0.3\ngap = 1e-3\nrestitution = 0.2\nimpulse = \"collocation\"\n"
      "[[stop]]\nposition = 0.2\ngap = 4e-4\n"
      "[stop.spring]\nstiffness = 500.0\nexponent = 1.5\n",
      "held_beam.toml");
}

}  // namespace graze::support
