// Measurements of one of three kinds, which the names of the columns distinguish:
//
//   restitution    speed, restitution: the approach speed v, m/s, and the coefficient at that speed
//   impact times   time, and stop where there are several: the instants of impacts, s
//   response       time, and columns of a motion: q1 .., qdot1 .. (modal coordinates and rates),
//                  gap1 .., force1 .., displacement1 .., velocity1 .., penetration1 .. at the
//                  stops, probe_1 .. (probe1 ..) of the scene's probes
//
// A column `sigma` gives each value its standard uncertainty, `sigma_force1` that of one of several
// columns. A table with a column `kind`, as `graze simulate --out` writes its events, holds impact
// times: rows of other kinds than impact and contact are skipped.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/data_table.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

enum class MeasurementKind { kRestitution, kImpactTimes, kResponse };

// The quantity in a column of a response.
enum class Quantity {
  kCoordinate,    // q_j, kg^1/2 m
  kRate,          // q_j', kg^1/2 m/s
  kGap,           // gap - row.q of a stop, m
  kForce,         // of a stop on the structure, N, >= 0
  kDisplacement,  // u at a stop, m
  kVelocity,      // u' at a stop, m/s
  kPenetration,   // depth beyond the surface of a compliant stop, m, >= 0
  kProbe          // the value of a probe of the scene, in its unit
};

// One measured column.
struct MeasuredSeries {
  std::string name;  // as the file names it
  std::string unit;  // SI
  Quantity quantity = Quantity::kCoordinate;
  int index = 0;       // of the mode, stop or probe, from 0
  Vector values;       // one per row
  Vector uncertainty;  // standard uncertainties, one per row, > 0; empty where they are not known
};

struct Measurements {
  std::string file;
  MeasurementKind kind = MeasurementKind::kResponse;
  // One per row: time, s (response), approach speed, m/s (restitution), or the number of the impact
  // at its stop, from 1.
  Vector at;
  std::vector<int> stops;  // for impact times: index from 0; -1: any
  std::vector<MeasuredSeries> series;
  std::vector<SourceLocation> places;  // of the first series' value in each row
  std::vector<std::string> unused;     // columns that no parameter is fitted to

  std::size_t rows() const { return places.size(); }
  // Number of values in all series.
  Eigen::Index values() const { return static_cast<Eigen::Index>(rows() * series.size()); }
  bool knows_uncertainty() const { return !series.empty() && series[0].uncertainty.size() > 0; }
};

struct MeasurementOptions {
  std::vector<std::string> columns;  // for a response, those that are fitted; empty: all
  // Standard uncertainty by column, which replaces that of the file; name "" for every column.
  std::vector<std::pair<std::string, double>> uncertainties;
};

// Reads the table; throws InputError with file:line:column, what is wrong and what is allowed.
Measurements read_measurements(const DataTable& table, const Scene& scene,
                               const MeasurementOptions& options);

}  // namespace graze
