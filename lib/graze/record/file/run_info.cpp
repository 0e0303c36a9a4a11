#include "graze/record/file/run_info.hpp"

#include "graze/scene/reader.hpp"

namespace graze {

std::string version() { return GRAZE_VERSION; }

RunInfo run_info(const std::string& command, const std::string& scene_file, const Scene& scene) {
  RunInfo info;
  info.version = version();
  info.command = command;
  info.scene_file = scene_file;
  info.scene_title = scene.title;
  info.units = scene.units;
  info.scene_text = write_scene(scene);
  info.scene_sha256 = sha256(info.scene_text);
  return info;
}

}  // namespace graze
