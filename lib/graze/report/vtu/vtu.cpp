#include "graze/report/vtu/vtu.hpp"

#include <fmt/format.h>

#include <map>

#include "graze/scene/matrix_structure.hpp"

namespace graze {
namespace {

// More couplings than so many a node are those of a solid, which lines would only hide.
constexpr std::size_t kMostLinesPerNode = 3;

struct Grid {
  std::vector<long> nodes;
  std::vector<std::pair<std::size_t, std::size_t>> lines;
};

Grid grid_of(const MatrixModes& found) {
  Grid grid;
  std::map<long, std::size_t> places;
  for (const auto& [node, place] : found.coordinates) {
    places.emplace(node, grid.nodes.size());
    grid.nodes.push_back(node);
  }
  if (found.couplings.size() > kMostLinesPerNode * grid.nodes.size()) return grid;
  for (const auto& [first, second] : found.couplings) {
    const auto a = places.find(first), b = places.find(second);
    if (a != places.end() && b != places.end()) grid.lines.emplace_back(a->second, b->second);
  }
  return grid;
}

std::string array(const char* type, const std::string& name, int components,
                  const std::string& values) {
  return fmt::format(
      "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}"
      "        </DataArray>\n",
      type, name, components, values);
}

std::string cells_text(const Grid& grid) {
  constexpr int kVertex = 1, kLine = 3;  // of VTK
  const bool has_lines = !grid.lines.empty();
  const std::size_t count = has_lines ? grid.lines.size() : grid.nodes.size();
  std::string connectivity, offsets, types;
  for (std::size_t i = 0; i < count; ++i) {
    connectivity += has_lines ? fmt::format("{} {}\n", grid.lines[i].first, grid.lines[i].second)
                              : fmt::format("{}\n", i);
    offsets += fmt::format("{}\n", (i + 1) * (has_lines ? 2 : 1));
    types += fmt::format("{}\n", has_lines ? kLine : kVertex);
  }
  return "      <Cells>\n" + array("Int64", "connectivity", 1, connectivity) +
         array("Int64", "offsets", 1, offsets) + array("UInt8", "types", 1, types) +
         "      </Cells>\n";
}

std::string grid_text(const MatrixModes& found, const Grid& grid, Eigen::Index mode) {
  std::string points, moved, names;
  for (const long node : grid.nodes) {
    const auto& place = found.coordinates.at(node);
    points += fmt::format("{} {} {}\n", place[0], place[1], place[2]);
    const auto u = found.displacement(node, mode);
    moved += fmt::format("{} {} {}\n", u[0], u[1], u[2]);
    names += fmt::format("{}\n", node);
  }
  const std::size_t cells = grid.lines.empty() ? grid.nodes.size() : grid.lines.size();
  return fmt::format(
             "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\">\n"
             "  <UnstructuredGrid>\n"
             "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
             "      <PointData Vectors=\"displacement\">\n",
             grid.nodes.size(), cells) +
         array("Float64", "displacement", 3, moved) + array("Int64", "node", 1, names) +
         "      </PointData>\n      <Points>\n" + array("Float64", "points", 3, points) +
         "      </Points>\n" + cells_text(grid) +
         "    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> mode_shape_files(const Scene& scene) {
  const MatrixStructure* matrices = scene.matrices();
  if (!matrices || matrices->solved->coordinates.empty()) return {};
  const MatrixModes& found = *matrices->solved;
  const Grid grid = grid_of(found);
  std::vector<std::pair<std::string, std::string>> files;
  std::string list =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (int j = 0; j < found.modes.count(); ++j) {
    const std::string name = fmt::format("mode_{}.vtu", j + 1);
    list += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n",
                        found.modes.omega[j], name);
    files.emplace_back(name, grid_text(found, grid, j));
  }
  files.emplace_back("modes.pvd", list + "  </Collection>\n</VTKFile>\n");
  return files;
}

}  // namespace graze
