// Paths of tables and keys: "stop.2.gap", "beam.piece.section".
#pragma once

#include <cstddef>
#include <string>

namespace graze {

// The path of a key in the table at path `table`, "" for the root.
std::string joined_path(const std::string& table, const std::string& key);

// Whether the path is that of a list of tables, "stop" or "beam.piece".
bool is_list_of_tables(const std::string& path);
// Whether it may be: [forcing] or [[forcing]].
bool may_be_list_of_tables(const std::string& path);

// "stop.2.spring" is a "stop.spring", "probe.2" a "probe", "beam.piece.2.to" a "beam.piece.to".
std::string without_number(const std::string& path);

// "stop.1.gap" is "stop.gap": the first table of a list has no number.
std::string first_unnumbered(const std::string& path);

// Table `number`, from 1, of the list `name`: "stop", "stop.2", "stop.3", ..
std::string numbered_path(const std::string& name, std::size_t number);

}  // namespace graze
