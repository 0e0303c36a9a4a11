#include "graze/scene/detail/signal_file.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/base/units.hpp"
#include "graze/scene/data_table.hpp"
#include "graze/scene/detail/node.hpp"
#include "graze/scene/detail/random_course.hpp"
#include "graze/scene/detail/table_paths.hpp"
#include "graze/scene/detail/text_file.hpp"
#include "graze/scene/ground_motion.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

bool is_displacement(const HarmonicLoad& load) {
  return load.signal->quantity == BaseRecord::kDisplacement;
}

const char* unit_of(const HarmonicLoad& load) {
  switch (load.kind) {
    case ForcingKind::kBase:
      return is_displacement(load) ? "m" : "m/s^2";
    case ForcingKind::kDistributed:
      return "N/m";
    case ForcingKind::kPoint:
      return "N";
    case ForcingKind::kSupport:
      return "m";
    default:
      return "";
  }
}

// The column of that name, or without one that at `place`.
std::size_t column_of(const DataTable& table, const std::string& name, std::size_t place) {
  if (name.empty()) return place;
  if (const std::optional<std::size_t> found = table.find(name)) return *found;
  std::vector<std::string> has;
  for (std::size_t k = 0; k < table.columns(); ++k) has.push_back(quoted(table.column_name(k)));
  throw table.error(
      fmt::format("there is no column {}, it must be {}", quoted(name), joined(has, "or")));
}

// Two columns of a table, the first one rising.
struct Points {
  std::vector<double> at, of;
};

// `columns`: their names, or ""; `units`: those they are read in, "" for as they are.
Points read_points(const std::string& file, const char* kind,
                   const std::array<std::string, 2>& columns,
                   const std::array<std::string, 2>& units) {
  const DataTable table(read_text_file(file, kind), file);
  if (table.columns() < 2) throw table.error("the table has one column, it must have two");
  if (table.rows() < 2) throw table.error("the table has 1 row, it must have at least two");
  const std::size_t at = column_of(table, columns[0], 0);
  const std::size_t of = column_of(table, columns[1], at == 1 ? 0 : 1);
  const auto number = [&](std::size_t row, std::size_t column, const std::string& unit) {
    return unit.empty() ? table.number(row, column) : table.number(row, column, unit);
  };
  Points points;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double next = number(row, at, units[0]);
    if (row > 0 && !(next > points.at.back()))
      throw table.cell_error(
          row, at,
          fmt::format("{}: {} is not allowed, it must be greater than the number "
                      "before it, {}",
                      table.column_name(at), next, points.at.back()));
    points.at.push_back(next);
    points.of.push_back(number(row, of, units[1]));
  }
  return points;
}

std::shared_ptr<const TimeCourse> read_course(const HarmonicLoad& load, const std::string& path,
                                              const Scene& scene) {
  const SignalSource& source = *load.signal;
  const bool has_units = scene.units != Units::kNone;
  Points points = read_points(
      source.file, "a signal", {source.time, source.column},
      has_units ? std::array<std::string, 2>{"s", unit_of(load)} : std::array<std::string, 2>{});
  if (is_displacement(load)) {
    if (load.kind != ForcingKind::kBase)
      throw scene_error(scene, path + ".quantity",
                        "it is that of a moving base, the load must be of the kind \"base\"");
    if (source.repeats && points.of.front() != points.of.back())
      throw scene_error(
          scene, path + ".repeat",
          fmt::format("the displacement begins at {:g} and ends at {:g}, to repeat it "
                      "must come back",
                      points.of.front(), points.of.back()));
    points.of = spline_accelerations(points.at, points.of, source.repeats);
  }
  return std::make_shared<TimeCourse>(std::move(points.at), std::move(points.of), source.repeats);
}

// Instants must resolve the highest frequency that has a density.
std::shared_ptr<const TimeCourse> draw_course(const SignalSource& source, const std::string& path,
                                              const Scene& scene) {
  Points points = read_points(source.spectrum, "a spectral density", {"", source.column}, {});
  for (std::size_t k = 0; k < points.of.size(); ++k)
    if (points.of[k] < 0.0 || points.at[k] < 0.0)
      throw scene_error(scene, path + ".spectrum",
                        fmt::format("{} at {} Hz is not allowed, frequencies and densities must be "
                                    "at least 0",
                                    points.of[k], points.at[k]));
  if (source.sides == SpectrumSides::kTwo)
    for (double& density : points.of) density *= 2.0;
  constexpr double kMostInstants = 1e8;
  if (!(source.duration >= 2.0 * source.step && source.duration <= kMostInstants * source.step))
    throw scene_error(scene, path + ".step",
                      fmt::format("{} is not allowed, the duration must have 2 to {:g} steps",
                                  source.step, kMostInstants));
  if (2.0 * points.at.back() * source.step > 1.0)
    throw scene_error(
        scene, path + ".step",
        fmt::format("{} is not allowed, it must be at most {:g}, half of the period of "
                    "the highest frequency that has a density, {:g} Hz",
                    source.step, 0.5 / points.at.back(), points.at.back()));
  return drawn_course({std::move(points.at), std::move(points.of)}, source.duration, source.step,
                      static_cast<unsigned>(source.seed), source.repeats);
}

}  // namespace

void read_signals(Scene& scene) {
  if (!scene.forcing) return;
  std::size_t number = 0;
  const auto read = [&](HarmonicLoad& load) {
    const std::string path = numbered_path("forcing", ++number) + ".signal";
    if (!load.signal) return;
    SignalSource& source = *load.signal;
    source.course =
        source.spectrum.empty() ? read_course(load, path, scene) : draw_course(source, path, scene);
  };
  read(*scene.forcing);
  for (HarmonicLoad& load : scene.further) read(load);
  if (!scene.forcing->signal || !scene.forcing->signal->repeats) return;
  const TimeCourse& first = *scene.forcing->signal->course;
  scene.forcing->frequency = kTurn / (first.times.back() - first.times.front());
}

}  // namespace graze
