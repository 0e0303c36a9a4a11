#include "graze/record/file/run_info.hpp"

#include <fmt/format.h>
#include <nettle/sha2.h>

#include <array>

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

std::string sha256(const std::string& text) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string hex;
  for (const std::uint8_t byte : digest) hex += fmt::format("{:02x}", byte);
  return hex;
}

}  // namespace graze
