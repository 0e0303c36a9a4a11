// graze modes: the natural modes of a scene's structure.
#include <filesystem>

#include "graze/assembly/mode_table.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/vtu/vtu.hpp"
#include "graze/scene/reader.hpp"
#include "session.hpp"

namespace graze {
namespace {

ModalAssurance compared(const Scene& scene, const std::string& file) {
  const std::optional<NamedShapes> own = named_shapes(scene);
  const bool is_scene = std::filesystem::path(file).extension() == ".toml";
  const std::optional<NamedShapes> other =
      is_scene ? named_shapes(read_scene(file)) : std::optional(read_shapes(file));
  if (!own || !other)
    throw InputError(
        "--mac: modes that are given have no shapes to compare, nor has what turns with a hub");
  return modal_assurance(*own, *other);
}

}  // namespace

int run(const ModesCommand& command) {
  check_plot<ModesRecord>(command);
  const Scene scene = scene_of(command);
  ModesRecord record{info_of_call(command, scene), mode_table(scene), {}, {}, {}, {"found", ""}};
  if (!command.mac.empty()) {
    record.mac_file = command.mac;
    record.mac = compared(scene, command.mac);
  }
  prepare_output(command);
  return conclude(command, record, scene, [&] { return mode_shape_files(scene); });
}

}  // namespace graze
