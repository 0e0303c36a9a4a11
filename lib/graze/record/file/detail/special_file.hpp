// The special points of a run with their full orbits, as a file to go on from: TOML, all numbers
// with all their digits.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graze/bifurcation/problem/special_orbit.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct SpecialPoints {
  std::string version;                  // of the program
  std::string scene_sha256;             // of the scene in force, as RunInfo has it
  std::vector<std::string> parameters;  // one of a branch, two of a locus
  std::vector<SpecialOrbit> points;
};

// The name of such a file in an output folder.
inline constexpr const char* kSpecialFile = "special.toml";

std::string write_special_points(const SpecialPoints& special);

// Reads back what write_special_points wrote about `scene`, the one that its run left beside it.
// Throws FileError when the file cannot be read; InputError (file:line:column: key: sentence) when
// it holds no special points, in another format, of another scene or of other sizes.
SpecialPoints read_special_points(const std::filesystem::path& file, const Scene& scene);

// The same for text already in memory; `name` stands for the file in messages.
SpecialPoints parse_special_points(const std::string& text, const std::string& name,
                                   const Scene& scene);

}  // namespace graze
