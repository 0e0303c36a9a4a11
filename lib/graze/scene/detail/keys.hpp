// The keys that a scene file may hold, as the schema has them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace graze {

// A key as the reference tells it (docs/scenes.md).
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

// The path of a key in the table at path `table`, "" for the root.
std::string joined_path(const std::string& table, const std::string& key);

// Whether the path is that of a list of tables, "stop" or "beam.piece".
bool is_list_of_tables(const std::string& path);

// "stop.2.spring" is a "stop.spring", "probe.2" a "probe", "beam.piece.2.to" a "beam.piece.to".
std::string without_number(const std::string& path);

// "stop.1.gap" is "stop.gap": the first table of a list has no number.
std::string first_unnumbered(const std::string& path);

// Table `number`, from 1, of the list `name`: "stop", "stop.2", "stop.3", ..
std::string numbered_path(const std::string& name, std::size_t number);

// Full paths of the keys called `name` anywhere in a scene.
std::vector<std::string> keys_named(const std::string& name);

}  // namespace graze
