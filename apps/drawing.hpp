// What is drawn of each result, and as what: by the command that made it, and later from its
// folder.
#pragma once

#include <string>

#include "command.hpp"
#include "graze/record/record_names.hpp"
#include "graze/record/run_picture.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Draws the picture or page that --plot names. `scene`: the one in force. Throws FileError.
void draw(const CommonOptions& command, const CheckRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const ModesRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const SimulationRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const OrbitRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const BranchRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const LociRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const DiagramRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const RunDiagramRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const MapRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const ComparisonRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const ComparisonMapRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const SensitivityRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const CostRecord& record, const Scene& scene);
void draw(const CommonOptions& command, const FitRecord& record, const Scene& scene);

// Why nothing is drawn of that record; empty where something is.
template <class Record>
std::string nothing_to_draw(const Record&) {
  return "";
}
std::string nothing_to_draw(const ComparisonRecord& record);
std::string nothing_to_draw(const SensitivityRecord& record);
std::string nothing_to_draw(const FitRecord& record);

// What the pictures of a result have that may be asked for, besides title and style.
struct PictureFeatures {
  bool ranges = false;       // of the axes
  bool scales = false;       // of the axes, logarithmic or in decibels
  bool labels = false;       // beside special points and curves
  bool multipliers = false;  // of branches
};
inline constexpr PictureFeatures kAllFeatures = {true, true, true, true};
template <class Record>
inline constexpr PictureFeatures kFeatures = {.ranges = true};
template <>
inline constexpr PictureFeatures kFeatures<CheckRecord> = {};
template <>
inline constexpr PictureFeatures kFeatures<ModesRecord> = {};
template <>
inline constexpr PictureFeatures kFeatures<OrbitRecord> = {};
template <>
inline constexpr PictureFeatures kFeatures<BranchRecord> = kAllFeatures;
template <>
inline constexpr PictureFeatures kFeatures<LociRecord> = {
    .ranges = true, .scales = true, .labels = true};
template <>
inline constexpr PictureFeatures kFeatures<DiagramRecord> = kAllFeatures;
template <>
inline constexpr PictureFeatures kFeatures<MapRecord> = {.ranges = true, .labels = true};

// Throws InputError where --plot is given and is no name of what is drawn of such records, or is to
// show what their pictures do not have.
void check_plot(const CommonOptions& command, const PictureFeatures& features);
template <class Record>
void check_plot(const CommonOptions& command) {
  check_plot(command, kFeatures<Record>);
}
// The same for a run, of whose Poincare section there is a picture alone.
void check_plot_of_run(const CommonOptions& command, bool has_section, RunPicture shown);

// Fills in where the beam's shape is shown, as far as a picture or page of the run shows it.
void place_beam(const CommonOptions& command, const Scene& scene, SimulationRecord& record);

}  // namespace graze
