// Mass and stiffness of a scene's beam by hierarchical elements, assembled in long double. It
// shares nothing with the elements of this library, which divide by strains.
//
// The shape functions of an element of length h, s from -1 to 1: the four Hermite cubics of the
// displacements and slopes at its ends, and the bubbles that are Legendre polynomials P_k
// integrated twice, k = 2 .., which together with their slopes vanish at both ends as P_k is
// orthogonal to 1 and s. Bubbles of uniform elements are orthogonal to each other and to the cubics
// in the energy of bending. Reference: B. Szabo, I. Babuska, Finite Element Analysis, 1991,
// chapter 3.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "graze/fem/structural_matrices.hpp"
#include "graze/scene/scene.hpp"
#include "support/scratch_folder.hpp"

namespace graze::support {

struct BeamMesh {
  std::vector<double> nodes;  // m, more than those at which pieces, supports and masses meet
  double longest = 0.2;       // m, of the elements
  int bubbles = 16;           // in each element
};

struct BeamMatrices {
  // Rows: 2 and 6 of every node, its displacement and slope, then the bubbles. A unit acceleration
  // along y leaves these where they are, as rotations about x, which they are named.
  LabelledMatrix mass, stiffness;
  std::vector<DofLabel> held;
  std::vector<double> nodes;  // m

  DofLabel displacement(double x) const {
    const auto near = [x](double node) { return std::abs(node - x) < 1e-12; };
    const auto found = std::find_if(nodes.begin(), nodes.end(), near);
    if (found == nodes.end()) throw std::invalid_argument("no node there");
    return {found - nodes.begin() + 1, 2};
  }
  DofLabel slope(double x) const { return {displacement(x).node, 6}; }
  StructuralMatrices structure() const { return join_matrices(mass, stiffness, nullptr, held); }
};

namespace beam_matrices {

using Long = long double;
constexpr Long kPi = 3.14159265358979323846264338327950288L;

// P_0 .. P_n at s.
inline std::vector<Long> legendre(int n, Long s) {
  std::vector<Long> p{1.0L, s};
  for (int k = 2; k <= n; ++k) p.push_back(((2 * k - 1) * s * p[k - 1] - (k - 1) * p[k - 2]) / k);
  return p;
}

struct GaussPoint {
  Long s, weight;
};

// Zeros of P_n by Newton's iteration.
inline std::vector<GaussPoint> gauss_points(int n) {
  std::vector<GaussPoint> points;
  for (int i = 1; i <= n; ++i) {
    Long s = std::cos(kPi * (i - 0.25L) / (n + 0.5L)), slope = 0.0L;
    for (int step = 0; step < 20; ++step) {
      const std::vector<Long> p = legendre(n, s);
      slope = n * (s * p[n] - p[n - 1]) / (s * s - 1.0L);
      s -= p[n] / slope;
    }
    points.push_back({s, 2.0L / ((1.0L - s * s) * slope * slope)});
  }
  return points;
}

struct ShapeFunctions {
  std::vector<Long> w, w1, w2;  // and their derivatives by x
};

inline ShapeFunctions shape_functions(Long s, Long h, int bubbles) {
  ShapeFunctions f;
  const Long half = h / 2.0L;
  f.w = {(2 - 3 * s + s * s * s) / 4, half * (1 - s - s * s + s * s * s) / 4,
         (2 + 3 * s - s * s * s) / 4, half * (-1 - s + s * s + s * s * s) / 4};
  f.w1 = {(-3 + 3 * s * s) / 4, half * (-1 - 2 * s + 3 * s * s) / 4, (3 - 3 * s * s) / 4,
          half * (-1 + 2 * s + 3 * s * s) / 4};
  f.w2 = {6 * s / 4, half * (-2 + 6 * s) / 4, -6 * s / 4, half * (2 + 6 * s) / 4};
  const std::vector<Long> p = legendre(bubbles + 4, s);
  for (int k = 2; k < bubbles + 2; ++k) {
    f.w2.push_back(p[k]);
    f.w1.push_back((p[k + 1] - p[k - 1]) / (2 * k + 1));
    f.w.push_back(((p[k + 2] - p[k]) / (2 * k + 3) - (p[k] - p[k - 2]) / (2 * k - 1)) /
                  (2 * k + 1));
  }
  for (Long& value : f.w1) value /= half;
  for (Long& value : f.w2) value /= half * half;
  return f;
}

inline Long along(const Taper& taper, Long part) {
  return taper.front() + (static_cast<Long>(taper.back()) - taper.front()) * part;
}

// EI and mass per length of the beam at x, inside the piece that begins and ends at `from`, `to`.
struct BeamLaw {
  const Beam& beam;
  const Piece* piece = nullptr;
  Long from = 0.0L, to = 0.0L;

  std::pair<Long, Long> at(Long x) const {
    const bool own = piece && piece->section;
    const Section& section = own ? *piece->section : beam.section.value();
    const Long part = own ? (x - from) / (to - from) : x / beam.length;
    Long area = 0.0L, moment = 0.0L;
    if (section.shape == SectionShape::kRectangle) {
      const Long b = along(section.width, part), t = along(section.height, part);
      area = b * t;
      moment = b * t * t * t / 12.0L;
    } else {
      const Long d = along(section.diameter, part);
      const Long i =
          section.shape == SectionShape::kTube ? along(section.inner_diameter, part) : 0.0L;
      area = kPi / 4.0L * (d * d - i * i);
      moment = kPi / 64.0L * (d * d * d * d - i * i * i * i);
    }
    const Long modulus =
        piece && piece->youngs_modulus ? *piece->youngs_modulus : beam.youngs_modulus;
    const Long density = piece && piece->density ? *piece->density : beam.density;
    return {modulus * moment, density * area};
  }
};

inline BeamLaw law_at(const Beam& beam, Long x) {
  Long from = 0.0L;
  for (const Piece& piece : beam.pieces) {
    const Long to = piece.to.value_or(beam.length);
    if (x < to) return {beam, &piece, from, to};
    from = to;
  }
  return {beam};
}

inline std::vector<double> mesh_nodes(const Beam& beam, const BeamMesh& mesh) {
  std::vector<double> marks = mesh.nodes;
  marks.insert(marks.end(), {0.0, beam.length});
  for (const Piece& piece : beam.pieces) marks.push_back(piece.to.value_or(beam.length));
  for (const Support& support : beam.supports)
    marks.push_back(support.position.value_or(beam.length));
  for (const AttachedMass& mass : beam.masses) marks.push_back(mass.position.value_or(beam.length));
  std::sort(marks.begin(), marks.end());
  std::vector<double> nodes{0.0};
  for (const double mark : marks) {
    const double from = nodes.back();
    if (mark - from < 1e-12) continue;
    const int parts = static_cast<int>(std::ceil((mark - from) / mesh.longest));
    for (int i = 1; i < parts; ++i) nodes.push_back(from + (mark - from) * i / parts);
    nodes.push_back(mark);
  }
  return nodes;
}

// Both matrices, entry by entry, before they are rounded to double.
using Entries = std::map<std::pair<int, int>, Long>;

inline LabelledMatrix rounded(const Entries& entries, const std::vector<DofLabel>& labels,
                              const char* name) {
  const auto size = static_cast<Eigen::Index>(labels.size());
  std::vector<Eigen::Triplet<double>> triplets;
  for (const auto& [place, value] : entries)
    triplets.emplace_back(place.first, place.second, static_cast<double>(value));
  LabelledMatrix result{name, SparseMatrix(size, size), labels, true, {}};
  result.matrix.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

inline void add_element(const Beam& beam, Long from, Long to, int bubbles,
                        const std::vector<int>& rows, Entries& mass, Entries& stiffness) {
  const Long h = to - from, tension = beam.tension.value_or(0.0);
  const BeamLaw law = law_at(beam, 0.5L * (from + to));
  // Exact for sections that vary up to the fourth power.
  for (const GaussPoint& point : gauss_points(bubbles + 6)) {
    const auto [bending, heavy] = law.at(from + h * (1.0L + point.s) / 2.0L);
    const ShapeFunctions f = shape_functions(point.s, h, bubbles);
    const Long weight = point.weight * h / 2.0L;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows.size(); ++j) {
        const std::pair place(rows[i], rows[j]);
        mass[place] += weight * heavy * f.w[i] * f.w[j];
        stiffness[place] += weight * (bending * f.w2[i] * f.w2[j] + tension * f.w1[i] * f.w1[j]);
      }
  }
}

inline void hold(Hold kind, double x, BeamMatrices& result) {
  if (kind == Hold::kPinned || kind == Hold::kClamped)
    result.held.push_back(result.displacement(x));
  if (kind == Hold::kSliding || kind == Hold::kClamped) result.held.push_back(result.slope(x));
}

}  // namespace beam_matrices

inline BeamMatrices beam_matrices_of(const Beam& beam, const BeamMesh& mesh) {
  using namespace beam_matrices;
  BeamMatrices result;
  result.nodes = mesh_nodes(beam, mesh);
  const int nodes = static_cast<int>(result.nodes.size());
  Entries mass, stiffness;
  for (int e = 0; e + 1 < nodes; ++e) {
    std::vector<int> rows{2 * e, 2 * e + 1, 2 * e + 2, 2 * e + 3};
    for (int k = 0; k < mesh.bubbles; ++k) rows.push_back(2 * nodes + mesh.bubbles * e + k);
    add_element(beam, result.nodes[e], result.nodes[e + 1], mesh.bubbles, rows, mass, stiffness);
  }
  const auto row = [](const DofLabel& label) {
    return 2 * static_cast<int>(label.node) - (label.direction == 2 ? 2 : 1);
  };
  for (const AttachedMass& attached : beam.masses) {
    const double x = attached.position.value_or(beam.length);
    const int w = row(result.displacement(x)), slope = row(result.slope(x));
    mass[{w, w}] += attached.mass;
    mass[{slope, slope}] += attached.inertia;
  }
  for (const Support& support : beam.supports) {
    const double x = support.position.value_or(beam.length);
    const int w = row(result.displacement(x)), slope = row(result.slope(x));
    stiffness[{w, w}] += support.translational;
    stiffness[{slope, slope}] += support.rotational;
    hold(support.kind, x, result);
  }
  hold(beam.ends[0], 0.0, result);
  hold(beam.ends[1], beam.length, result);
  std::vector<DofLabel> labels;
  for (int node = 1; node <= nodes; ++node) labels.insert(labels.end(), {{node, 2}, {node, 6}});
  for (int k = 1; k <= mesh.bubbles * (nodes - 1); ++k) labels.push_back({nodes + k, 4});
  result.mass = rounded(mass, labels, "mass");
  result.stiffness = rounded(stiffness, labels, "stiffness");
  return result;
}

// Matrix Market, the lower triangle, 17 digits.
inline void write_matrix_market(const SparseMatrix& matrix, const std::filesystem::path& file) {
  std::ofstream out(file);
  const SparseMatrix lower = matrix.triangularView<Eigen::Lower>();
  out << "%%MatrixMarket matrix coordinate real symmetric\n"
      << lower.rows() << " " << lower.cols() << " " << lower.nonZeros() << "\n";
  for (int j = 0; j < lower.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.16e", entry.value());
      out << entry.row() + 1 << " " << j + 1 << " " << digits << "\n";
    }
}

inline std::string quoted(const DofLabel& label) { return "\"" + label_text(label) + "\""; }

// Writes the files of a scene into a folder; the table [matrices] that names them, up to its modes.
inline std::string matrices_table(const BeamMatrices& beam, const ScratchFolder& folder) {
  write_matrix_market(beam.mass.matrix, folder / "mass.mtx");
  write_matrix_market(beam.stiffness.matrix, folder / "stiffness.mtx");
  std::ofstream names(folder / "names.dof");
  for (const DofLabel& label : beam.mass.labels) names << label_text(label) << "\n";
  std::string held;
  for (const DofLabel& label : beam.held) held += (held.empty() ? "" : ", ") + quoted(label);
  return "[matrices]\nmass = \"mass.mtx\"\nstiffness = \"stiffness.mtx\"\ndofs = \"names.dof\"\n"
         "constraints = [" +
         held + "]\ndirection = 2\nmodes = 8\n";
}

}  // namespace graze::support
