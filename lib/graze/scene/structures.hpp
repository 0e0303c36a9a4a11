// What a scene may have between its stops: a beam, a string, a bar, given modes, matrices, or
// masses and springs. SI units.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace graze {

enum class Projection { kGalerkin, kCollocation };

// A length of a section: one number, or two, at the left and at the right end, with a linear change
// between them.
using Taper = std::vector<double>;  // m, > 0

enum class SectionShape { kRectangle, kCircle, kTube };

// Each shape has its own lengths; those of others stay empty.
struct Section {
  SectionShape shape = SectionShape::kRectangle;
  Taper width, height;             // rectangle; it bends in the direction of the height
  Taper diameter, inner_diameter;  // circle and tube; tube
};

// Part of a beam or of a bar, from the end of the previous one. Values that it does not give are
// those of the whole; a section of the whole extends over the whole length.
struct Piece {
  std::optional<double>
      to;  // m from the left end; not of the last, which ends where the whole does
  std::optional<double> second_moment, area;      // m^4 (beam), m^2; or
  std::optional<Section> section;                 // in place of both
  std::optional<double> youngs_modulus, density;  // Pa, kg/m^3
};

// What holds a place: all but `kSpring` hold it rigidly. Pinned: u = 0; clamped: u = u' = 0;
// sliding: u' = 0. Strings and bars are free or pinned, which their scenes call fixed.
enum class Hold { kFree, kPinned, kClamped, kSliding, kSpring };

struct Support {
  std::optional<double> position;  // m from the left end; left out: the right end
  Hold kind = Hold::kSpring;
  double translational = 0.0, rotational = 0.0;  // N/m, N m/rad, >= 0; of springs
};

struct AttachedMass {
  std::optional<double> position;  // as above
  double mass = 0.0;               // kg, >= 0
  double inertia = 0.0;            // kg m^2, >= 0, about the place; of a beam
};

// A structure along a line, with places x from 0 to its length.
struct Span {
  double length = 0.0;  // m
  int modes = 0;        // 1..2000
  std::array<Hold, 2> ends{Hold::kClamped, Hold::kFree};
  std::vector<Support> supports{};
  std::vector<AttachedMass> masses{};
};

// Euler-Bernoulli beam; where no more is given, uniform, clamped at x = 0 and free at x = length.
struct Beam : Span {
  double youngs_modulus = 0.0;                // Pa
  double density = 0.0;                       // kg/m^3
  std::optional<double> second_moment, area;  // m^4, m^2; or
  std::optional<Section> section{};           // in place of both
  std::vector<Piece> pieces{};
  std::optional<double> tension{};  // N, negative: compression
  Projection discretisation = Projection::kGalerkin;
  std::vector<double> points{};  // m from the clamp, one per mode, in (0, length]; empty: i L/N
  // h, m, where no section gives it; strains are those at h/2 from the neutral axis.
  std::optional<double> thickness{};
};

// Stretched string, fixed at both ends where no more is given; u is across it.
struct TautString : Span {
  TautString() { ends = {Hold::kPinned, Hold::kPinned}; }
  std::vector<double> frequencies{};  // rad/s, >= 0, one per mode: measured ones; or
  std::optional<double> tension{};    // N, in place of them
  double mass_per_length = 0.0;       // kg/m
};

// Bar that is stretched along itself, fixed at x = 0 and free at x = length where no more is given;
// u is along it.
struct Bar : Span {
  Bar() { ends = {Hold::kPinned, Hold::kFree}; }
  double youngs_modulus = 0.0;       // Pa
  double density = 0.0;              // kg/m^3
  std::optional<double> area;        // m^2, or
  std::optional<Section> section{};  // in place of it
  std::vector<Piece> pieces{};
};

// Any structure given by its mass-normalised modes; all lists have one entry per mode.
struct ModalStructure {
  std::vector<double> frequencies;     // rad/s, >= 0 (0: a free mass)
  std::vector<double> damping_ratios;  // 1, >= 0; empty: none
  std::vector<double> participation;   // modal force per unit of forcing amplitude; empty: none
  std::vector<double> inertia;         // modal force per unit of uniform acceleration; empty: none
};

struct MatrixModes;  // scene/matrix_structure.hpp

// A structure of discrete coordinates u, M u'' + C u' + K u = f.
struct DiscreteStructure {
  int modes = 0;  // the lowest ones, 1..2000; 0: all
  // What its matrices make of it, by solve_matrices; shared by all copies.
  std::shared_ptr<const MatrixModes> solved{};
  ModalStructure modal{};  // the structure as its modes see it
};

// The rows of a matrix that stands in the scene. Of a mass or a stiffness, which are symmetric,
// what is below the diagonal is taken from above it.
using MatrixEntries = std::vector<std::vector<double>>;

// A structure given by the matrices of its model: those of finite elements, in files, or small ones
// in the scene. A degree of freedom is named by its number, "7", or by node and direction, "12.3".
struct MatrixStructure : DiscreteStructure {
  std::string mass, stiffness;             // files; of a scene that was read, with their whole path
  std::string damping, dofs, coordinates;  // empty: none
  // In place of files, kg, N/m, N s/m; empty: none.
  MatrixEntries mass_entries{}, stiffness_entries{}, damping_entries{};
  std::vector<std::string> constraints;  // held at zero
  std::string constraints_file;
  int direction = 0;  // of base forcing and gravity: 1, 2, 3; 0: of all degrees of freedom
  std::vector<std::string> load;    // where the forcing "load" acts,
  std::vector<double> load_values;  // N per unit of its amplitude; empty: 1 each
  std::string load_file;            // in their place
  std::string checksum;             // SHA-256 of the files; empty: whatever they hold
};

// Between two masses, or a mass and the ground.
struct LumpedSpring {
  std::vector<std::string> between;  // two of "0" or "ground", a mass by its number or its name
  double stiffness = 0.0;            // N/m, >= 0
  double damping = 0.0;              // N s/m, >= 0: of the dashpot beside it
};

// Forces across each other's velocity, without work: -coefficient u2' on the first mass and
// coefficient u1' on the second, as a disc that turns has between its two planes.
struct GyroscopicPair {
  std::vector<std::string> between;  // two masses
  double coefficient = 0.0;          // N s/m
};

// Masses in a line with springs and dashpots between them.
struct LumpedStructure : DiscreteStructure {
  std::vector<double> masses;      // kg, > 0
  std::vector<std::string> names;  // one for each; empty: their numbers alone
  std::vector<LumpedSpring> springs;
  std::vector<GyroscopicPair> gyroscopic;
};

}  // namespace graze
