// The tables of tests/reference: 50-digit values computed without this library.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "graze/scene/reader.hpp"

namespace graze::support {

using TableRow = std::map<std::string, std::string>;  // column -> cell

inline std::vector<std::string> split_cells(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line + ",");
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

inline std::vector<TableRow> read_table(const std::string& name) {
  const std::string path = std::string(GRAZE_SOURCE_DIR) + "/tests/reference/" + name;
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> columns = split_cells(line);
  std::vector<TableRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = split_cells(line);
    TableRow row;
    for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = cells.at(i);
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("no rows in " + path);
  return rows;
}

inline double number(const TableRow& row, const std::string& column) {
  return std::stod(row.at(column));
}

// tests/reference/cases/<name>.toml; orbits as "orbits/<case>".
inline Scene reference_scene(const std::string& name,
                             const std::vector<std::string>& settings = {}) {
  return read_scene(std::string(GRAZE_SOURCE_DIR) + "/tests/reference/cases/" + name + ".toml",
                    settings);
}

// data/scenes/<name>.toml
inline Scene shipped_scene(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_scene(std::string(GRAZE_SOURCE_DIR) + "/data/scenes/" + name + ".toml", settings);
}

}  // namespace graze::support
