// The keys that a scene file may hold: the one list of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace graze {

struct TableKeys {
  std::string table;                 // "" for the root
  std::vector<std::string> allowed;  // keys and tables
};

// The keys of the table at `path` ("stop.2" has those of "stop"), which must be a scene's table.
const TableKeys& keys_of(const std::string& path);

// Table `number`, from 1, of the list `name`: "stop", "stop.2", "stop.3", ..
std::string numbered_path(const std::string& name, std::size_t number);

// Full paths of the keys called `name` anywhere in a scene.
std::vector<std::string> keys_named(const std::string& name);

}  // namespace graze
