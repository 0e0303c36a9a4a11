// The keys that a scene file may hold, as the schema has them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "graze/scene/detail/table_paths.hpp"

namespace graze {

// One row of the reference in docs/scenes.md.
struct KeyRow {
  std::string name, unit, fallback, range, meaning;
};

struct TableKeys {
  std::string table;                 // "" for the root
  std::vector<std::string> allowed;  // keys and tables
  std::vector<KeyRow> rows;          // keys
};

// Every table, each before those within it.
const std::vector<TableKeys>& all_keys();

// The keys of the table at `path` ("stop.2" has those of "stop"), which must be a scene's table.
const TableKeys& keys_of(const std::string& path);

// The key of a number by its path, "stop.2.gap" or "modal.frequencies.3", or null.
const KeyRow* key_row(const std::string& path);

// Full paths of the keys called `name` anywhere in a scene.
std::vector<std::string> keys_named(const std::string& name);

}  // namespace graze
