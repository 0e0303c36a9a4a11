// A table of the natural modes of a scene's structure, of whichever kind.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {

// A uniform acceleration of the whole structure in a direction.
struct DirectionShare {
  int direction = 0;  // 1, 2, 3; 0: along u, or of all degrees of freedom
  Vector inertia;     // modal forces of a unit acceleration, kg^1/2; their squares, in kg, are the
                      // modes' effective masses
  std::optional<double> total_mass{};  // kg, which those of all modes add up to
};

// The part of the static flexibility of the structure at a stop that the kept modes give, m/N.
struct StopFlexibility {
  double kept = 0.0;              // sum of (phi_j/w_j)^2, without rigid-body modes
  std::optional<double> whole{};  // of the structure; nullopt when only its modes are known
};

struct ModeTable {
  Vector omega, decay;  // rad/s; 1/s
  int rigid = 0;        // how many of the first have the frequency 0
  Vector residuals;     // relative, of modes of matrices; empty of others
  std::vector<DirectionShare> directions;
  std::vector<StopFlexibility> flexibilities;  // of every stop
  // Of matrices: how their modes were found and counted, in sentences.
  std::vector<std::string> notes;
};

ModeTable mode_table(const Scene& scene);

// Why the mass and the stiffness of a scene's matrices look exchanged, a sentence; empty where they
// do not.
std::string exchange_sentence(const Scene& scene);

// Flexibilities alone; `model` is that of the scene.
std::vector<StopFlexibility> stop_flexibilities(const Scene& scene, const ModalModel& model);

// Shapes of modes at named places, by which two sets of modes are compared: degrees of freedom, or
// the places of a beam by their share of its length in thousandths.
struct NamedShapes {
  std::vector<std::string> names;
  Matrix values;  // places by modes
};
// Returns nullopt when only the modes of the structure are known, or when it rotates with a hub.
std::optional<NamedShapes> named_shapes(const Scene& scene);
// Reads a file whose lines are a degree of freedom and its displacement in each shape. Throws
// FileError, and InputError with file:line.
NamedShapes read_shapes(const std::string& file);

// Modal assurance criterion, (a_i.b_j)^2/(|a_i|^2 |b_j|^2) over the places that both have; `common`
// is their number. Throws InputError where there are none.
struct ModalAssurance {
  Matrix values;  // modes of the first by those of the second, 0..1
  int common = 0;
};
ModalAssurance modal_assurance(const NamedShapes& first, const NamedShapes& second);

}  // namespace graze
