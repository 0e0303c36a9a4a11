#include "graze/scene/detail/hub_reader.hpp"

#include <initializer_list>
#include <string>

#include "graze/scene/detail/table_reader.hpp"
#include "graze/scene/detail/torque_table.hpp"

namespace graze {
namespace {

const std::string kNotNegative = "a number of at least 0";

void refuse_keys(const TableReader& table, std::initializer_list<const char*> keys,
                 const std::string& sentence) {
  for (const char* key : keys)
    if (table.has(key)) table.fail(key, sentence);
}

TorqueTable read_table(const TableReader& table, const std::filesystem::path& folder) {
  if (table.has("file")) {
    refuse_keys(table, {"times", "values"}, "the table is in a file, it must be left out");
    const std::string name = table.text_or("file", "");
    if (name.empty()) table.fail("file", "the name is empty, it must be that of a CSV file");
    return read_torque_file(folder / name);
  }
  if (!table.has("times") && !table.has("values"))
    table.fail("file",
               "the key is missing, it must be the name of a CSV file with time (s) and torque "
               "(N m), or times and values must be given");
  TorqueTable result;
  const auto list = [&](const char* key, const char* what) {
    table.required(key, what);
    return table.numbers(key, what);
  };
  result.times = list("times", "a list of numbers in s");
  result.values = list("values", "a list of numbers in N m, one per time");
  return result;
}

Torque read_torque(const Node& node, const std::filesystem::path& folder, Origins& origins) {
  const TableReader table(node, "hub.torque", origins);
  enum class Kind { kPulse, kTable };
  table.required("kind", "\"pulse\" or \"table\"");
  const Kind kind = table.choice<Kind>("kind", {{"pulse", Kind::kPulse}, {"table", Kind::kTable}});
  if (kind == Kind::kTable) {
    refuse_keys(table, {"amplitude", "duration"},
                "a torque of the kind \"table\" has none, it must be left out");
    return read_table(table, folder);
  }
  refuse_keys(table, {"file", "times", "values"},
              "a torque of the kind \"pulse\" has none, it must be left out");
  return TorquePulse{table.number("amplitude", "a number in N m"),
                     table.number("duration", "a number greater than 0, in s")};
}

}  // namespace

Hub read_hub(const Node& node, const std::filesystem::path& folder, Origins& origins) {
  const TableReader table(node, "hub", origins);
  Hub hub;
  hub.radius = table.number("radius", kNotNegative + ", in m");
  hub.inertia = table.number("inertia", kNotNegative + ", in kg m^2");
  if (const Node* torque = table.find("torque")) hub.torque = read_torque(*torque, folder, origins);
  hub.equations = table.choice<HubEquations>(
      "equations", {{"consistent", HubEquations::kConsistent}, {"paper", HubEquations::kPaper}});
  hub.centrifugal = table.flag_or("centrifugal", true);
  if (const Node* friction = table.find("friction"))
    hub.friction = TableReader(*friction, "hub.friction", origins)
                       .number("coulomb", kNotNegative + ", in N m");
  return hub;
}

}  // namespace graze
