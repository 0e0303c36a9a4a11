// What a scene gives acts on what is simulated, or is refused: nothing is passed over in silence.
// To every shipped scene each key of the schema is given values of every kind; where some are
// accepted and none of them changes a number of the system, the key is one that does nothing there.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/mode_table.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/file/detail/fields.hpp"
#include "graze/record/file/detail/value_text.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Keys that change no number of the system, and what they do.
const std::map<std::string, std::string> kOtherwise = {
    {"title", "heads the output"},
    {"units", "tells results without units"},
    {"beam.points",
     "of a collocation; docs/scenes.md says that other choices ignore it, so that "
     "compare --against can make them"},
    {"beam.thickness", "of strains"},
    {"matrices.checksum", "is compared with the files"},
    {"matrices.coordinates", "of pictures; sets of nodes in it are looked up by name"},
    {"matrices.direction",
     "of base forcing and gravity, which a scene need not have to show modes"},
    {"initial.at", "is where it starts anyway without a constant load"},
    {"stop.spring.damping.inversion", "where formulas are published that are not exact"},
    {"solver.flow", "how the motion is found"},
    {"solver.tolerance", "how the motion is found"},
    {"solver.step", "how the motion is found"},
};

// Of the loads over time, and of stops that move.
std::string loads_of(const System& system) {
  if (!system.forcing()) return "";
  const HarmonicForcing& forcing = *system.forcing();
  std::string text = value_text(forcing.frequency) + value_text(forcing.phase) +
                     value_text(forcing.amplitude) + value_text(forcing.repeats);
  std::vector<Harmonic> all = forcing.harmonics;
  all.insert(all.end(), system.modal().carried.begin(), system.modal().carried.end());
  for (const Harmonic& one : all) {
    text += value_text(one.order) + value_text(one.cosine) + value_text(one.sine);
    if (one.timed)
      text += value_text(one.timed->course->times) + value_text(one.timed->course->values) +
              value_text(one.timed->course->repeats);
  }
  return text;
}

// All numbers that a scene makes.
std::string numbers_of(const Scene& scene) {
  const System system = assemble(scene);
  std::string text = value_text(system.omega);
  if (const Rotation* turning = system.rotation())
    text += value_text(turning->angle) + value_text(turning->beam) + value_text(turning->damping) +
            value_text(turning->stretch) + value_text(turning->consistent) +
            value_text(turning->weight) + value_text(turning->torque) +
            value_text(turning->friction);
  else
    text += value_text(system.modal().delta) + value_text(system.modal().load) + loads_of(system);
  for (const Stop& stop : system.stops) {
    text += value_text(stop.row) + value_text(stop.gap);
    text += stop.is_compliant()
                ? value_text(stop.force())
                : value_text(stop.direction()) + value_text(stop.restitution().coefficients());
  }
  const State start = initial_state(scene, system);
  text += value_text(start.q) + value_text(start.qdot);
  for (const DirectionShare& share : mode_table(scene).directions)
    text += value_text(share.inertia);
  for (const Probe& probe : scene.probes)
    text += value_text(probe.position) + value_text(probe.shape) + value_text(probe.quantity);
  return text;
}

// "stop.spring" -> "stop.1.spring"
std::string first_of_lists(const std::string& table) {
  std::string path, name;
  for (std::size_t at = 0; at < table.size();) {
    const std::size_t end = std::min(table.find('.', at), table.size());
    name += (name.empty() ? "" : ".") + table.substr(at, end - at);
    path += (path.empty() ? "" : ".") + table.substr(at, end - at);
    if (is_list_of_tables(name)) path += ".1";
    at = end + 1;
  }
  return path;
}

// Values of every kind, and the words that the reference names.
std::vector<std::string> values_for(const KeyRow& row, int modes) {
  std::vector<std::string> values = {"0.37",  "1.7",      "3",       "true",       "false",
                                     "\"1\"", "\"21.1\"", "[\"1\"]", "[\"21.1\"]", "[0.37, 0.31]"};
  std::string list;
  for (int k = 0; k < modes; ++k) list += (k == 0 ? "" : ", ") + std::to_string(0.3 + 0.1 * k);
  values.push_back("[" + list + "]");
  const std::string words = row.fallback + row.range;
  for (std::size_t at = 0; (at = words.find('"', at)) != std::string::npos;) {
    const std::size_t end = words.find('"', at + 1);
    if (end == std::string::npos) break;
    const std::string word = words.substr(at, end - at + 1);
    values.push_back(word);
    values.push_back("[" + word + ", " + word + "]");
    at = end + 1;
  }
  return values;
}

struct GivenScene {
  const char* file;
  std::vector<std::string> settings{};  // made before
  const char* table = nullptr;          // where one alone is looked at
};

const std::vector<GivenScene> kScenes = {
    {"01_wagg_2004.toml"},
    {"01_wagg_2004.toml", {"beam.discretisation=galerkin", "stop.1.impulse=momentum"}},
    {"04_impact_oscillator.toml"},
    {"12_spring_dashpot_oscillator.toml"},
    {"17_yigit_lee_wang_1.toml"},
    {"24_frame_from_matrices.toml", {}, "matrices"},
    {"25_impact_absorber.toml"},
};

TEST(KeysOfScenes, ActOrAreRefused) {
  const std::filesystem::path folder = std::filesystem::path(GRAZE_SOURCE_DIR) / "data" / "scenes";
  for (const GivenScene& given : kScenes) {
    SCOPED_TRACE(given.file);
    const std::filesystem::path file = folder / given.file;
    const Scene scene = read_scene(file, given.settings);
    const std::string before = numbers_of(scene), written = write_scene(scene);
    int acting = 0;
    const auto acts = [&](const std::string& path, const KeyRow& row) {
      bool is_accepted = false;
      for (const std::string& value : values_for(row, scene.modes())) {
        std::vector<std::string> settings = given.settings;
        settings.push_back(path + "=" + value);
        try {
          const Scene changed = read_scene(file, settings);
          if (numbers_of(changed) != before) return ++acting > 0;
          is_accepted = is_accepted || write_scene(changed) != written;
        } catch (const InputError&) {
        } catch (const FileError&) {
        }
      }
      return !is_accepted;
    };
    for (const TableKeys& table : all_keys()) {
      if (given.table && table.table != given.table) continue;
      for (const KeyRow& row : table.rows) {
        const std::string within = table.table.empty() ? "" : table.table + ".";
        const std::string place = within.empty() ? "" : first_of_lists(table.table) + ".";
        if (!kOtherwise.contains(within + row.name)) {
          EXPECT_TRUE(acts(place + row.name, row)) << place + row.name;
        }
      }
    }
    EXPECT_GE(acting, 1);
  }
}

}  // namespace
}  // namespace graze
