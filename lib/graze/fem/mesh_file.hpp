// Nodes, elements and sets of nodes of a mesh: from lines of a node and its x, y, z (m; z may be
// missing), separated by blanks or commas, or from an input file of CalculiX or Abaqus (*NODE,
// *ELEMENT, *NSET; other keywords are skipped). Lines that begin with ** or # are comments.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace graze {

struct MeshElement {
  std::string type;         // "C3D20R", in capitals
  std::vector<long> nodes;  // in the order of the file
};

struct Mesh {
  std::map<long, std::array<double, 3>> nodes;  // m
  std::vector<MeshElement> elements;
  std::map<std::string, std::vector<long>> sets;  // of nodes, by their names in capitals
};

// Throws FileError where the file cannot be read, and InputError with file:line.
Mesh read_mesh(const std::filesystem::path& file);

// The text in capitals: names of sets and types are compared without regard to case.
std::string in_capitals(std::string_view text);

}  // namespace graze
