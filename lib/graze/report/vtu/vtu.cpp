#include "graze/report/vtu/vtu.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <vector>

#include "graze/scene/matrix_structure.hpp"

namespace graze {
namespace {

// More couplings per node than this are those of a solid, which lines would only hide.
constexpr std::size_t kMostLinesPerNode = 3;

// Cell types of VTK.
constexpr int kVertex = 1, kPolyVertex = 2, kVtuLine = 3;

// How ParaView draws an element, by what its type begins with and its nodes, which VTK has in the
// same order but for those of lines: solids, membranes and shells (also of plane and axisymmetric
// problems), beams and bars.
struct Drawn {
  std::vector<std::string_view> types;
  std::map<std::size_t, int> cells;
};
const Drawn kDrawn[] = {
    {{"C3D"}, {{4, 10}, {6, 13}, {8, 12}, {10, 24}, {15, 26}, {20, 25}}},
    {{"S", "M3D", "CPS", "CPE", "CAX"}, {{3, 5}, {4, 9}, {6, 22}, {8, 23}}},
    {{"B2", "B3", "T2", "T3"}, {{2, kVtuLine}, {3, 21}}},
};
constexpr int kQuadraticEdge = 21;

struct Cell {
  int type = kVertex;
  std::vector<std::size_t> places;
};

struct Grid {
  std::vector<long> nodes;
  std::vector<Cell> cells;
};

// Elements of unknown types are drawn by their nodes.
int cell_of(const MeshElement& element) {
  for (const auto& [types, cells] : kDrawn) {
    const auto cell = cells.find(element.nodes.size());
    for (const std::string_view type : types)
      if (cell != cells.end() && element.type.starts_with(type)) return cell->second;
  }
  return kPolyVertex;
}

std::vector<Cell> cells_of(const MatrixModes& found, const std::map<long, std::size_t>& places) {
  std::vector<Cell> cells;
  const auto add = [&](int type, const std::vector<long>& nodes) {
    Cell cell{type, {}};
    for (const long node : nodes)
      if (const auto place = places.find(node); place != places.end())
        cell.places.push_back(place->second);
    if (cell.places.size() != nodes.size()) return;
    if (type == kQuadraticEdge) std::swap(cell.places[1], cell.places[2]);
    cells.push_back(std::move(cell));
  };
  for (const MeshElement& element : found.elements) add(cell_of(element), element.nodes);
  if (cells.empty() && found.couplings.size() <= kMostLinesPerNode * places.size())
    for (const auto& [first, second] : found.couplings) add(kVtuLine, {first, second});
  if (cells.empty())
    for (const auto& [node, place] : places) cells.push_back({kVertex, {place}});
  return cells;
}

Grid grid_of(const MatrixModes& found) {
  Grid grid;
  std::map<long, std::size_t> places;
  for (const auto& [node, place] : found.coordinates) {
    places.emplace(node, grid.nodes.size());
    grid.nodes.push_back(node);
  }
  grid.cells = cells_of(found, places);
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
  std::string connectivity, offsets, types;
  std::size_t offset = 0;
  for (const Cell& cell : grid.cells) {
    connectivity += fmt::format("{}\n", fmt::join(cell.places, " "));
    offsets += fmt::format("{}\n", offset += cell.places.size());
    types += fmt::format("{}\n", cell.type);
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
  return fmt::format(
             "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\">\n"
             "  <UnstructuredGrid>\n"
             "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
             "      <PointData Vectors=\"displacement\">\n",
             grid.nodes.size(), grid.cells.size()) +
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
