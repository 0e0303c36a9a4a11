// From TOML text to a checked scene and back.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// Reads and checks a scene file. Each of `settings` is "NAME=VALUE" with a dotted parameter path
// and a TOML value; it replaces or adds that key before the whole scene is checked.
// Throws FileError when the file, or one it names, cannot be read, InputError (file:line:column:
// key: sentence) when it is no usable scene.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings = {});

// The same for text already in memory; `name` stands for the file in messages and as the place from
// which the scene's names of other files start.
Scene parse_scene(const std::string& text, const std::string& name,
                  const std::vector<std::string>& settings = {});

// The scene as TOML that reads back to the same values; only what is present is written.
std::string write_scene(const Scene& scene);

}  // namespace graze
