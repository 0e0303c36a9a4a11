// The reference in docs/scenes.md tells every key as the schema has it, and no other key.
#include "graze/scene/detail/schema.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "graze/scene/detail/keys.hpp"

namespace graze {
namespace {

using Table = std::map<std::string, std::string>;  // rows by key
using Rows = std::map<std::string, Table>;         // by table

// The rows below each heading that begins with tables' names, "**`[beam.mass]`**, `[bar.mass]`:
// ..", which have the same keys; above the first stand the keys outside tables. A row below the
// heading of one table alone holds in place of one that it shares with others.
Rows rows_of_page() {
  Rows rows, shared;
  std::ifstream page(std::string(GRAZE_SOURCE_DIR) + "/docs/scenes.md");
  std::vector<std::string> tables{""};
  for (std::string line; std::getline(page, line) && line != "## Parameters and --set";) {
    if (line.starts_with("**`[")) {
      tables.clear();
      static const std::regex kTable(R"((?:^\*\*|, )`\[+([\w.]+)\]+`)");
      const std::string heading = line.substr(0, line.find(": "));
      for (std::sregex_iterator at(heading.begin(), heading.end(), kTable), end; at != end; ++at)
        tables.push_back((*at)[1]);
    }
    // The table of models has the name of a value, in quotes, where others have that of a key.
    if (!line.starts_with("|`") || line.starts_with("|`\"")) continue;
    const std::string key = line.substr(2, line.find('`', 2) - 2);
    for (const std::string& table : tables) {
      const bool is_new = (tables.size() == 1 ? rows : shared)[table].emplace(key, line).second;
      EXPECT_TRUE(is_new) << "docs/scenes.md has " << key << " of [" << table << "] twice";
    }
  }
  for (auto& [table, keys] : shared) rows[table].merge(keys);
  return rows;
}

std::string row_text(const std::string& name, const KeyRow& row) {
  std::string text = "|";
  for (const std::string& cell : {"`" + name + "`", row.unit, row.fallback, row.range, row.meaning})
    text += cell + "|";
  return text;
}

std::string text_of(const Table& table) {
  std::string text;
  for (const auto& [key, row] : table) text += row + "\n";
  return text;
}

// Tables that are written in line stand with the table that they are in: `friction.coulomb`.
Rows rows_of_schema(const Rows& page) {
  Rows rows;
  for (const TableKeys& keys : all_keys()) {
    std::string table = keys.table, within;
    while (!page.contains(table) && table.find('.') != std::string::npos) {
      const std::size_t dot = table.rfind('.');
      within = table.substr(dot + 1) + "." + within;
      table.resize(dot);
    }
    for (const KeyRow& row : keys.rows)
      rows[table].emplace(within + row.name, row_text(within + row.name, row));
  }
  return rows;
}

TEST(Schema, IsTheReference) {
  const Rows page = rows_of_page();
  const Rows schema = rows_of_schema(page);
  for (const auto& [table, rows] : schema)
    EXPECT_EQ(page.contains(table) ? text_of(page.at(table)) : "", text_of(rows))
        << "docs/scenes.md must have these rows for [" << table << "]:\n"
        << text_of(rows);
  for (const auto& [table, rows] : page)
    EXPECT_TRUE(schema.contains(table)) << "there is no table [" << table << "]";
}

TEST(Schema, EveryKeyHasANameOfItsOwnAndAMeaning) {
  for (const TableKeys& keys : all_keys()) {
    EXPECT_EQ(std::set<std::string>(keys.allowed.begin(), keys.allowed.end()).size(),
              keys.allowed.size())
        << keys.table;
    for (const KeyRow& row : keys.rows) EXPECT_FALSE(row.meaning.empty()) << row.name;
  }
}

}  // namespace
}  // namespace graze
