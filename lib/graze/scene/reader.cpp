#include "graze/scene/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/scene/check.hpp"
#include "graze/scene/detail/document.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/prepared_tables.hpp"
#include "graze/scene/detail/quantity_text.hpp"
#include "graze/scene/detail/schema.hpp"
#include "graze/scene/detail/settings.hpp"
#include "graze/scene/detail/table_reader.hpp"
#include "graze/scene/detail/signal_file.hpp"
#include "graze/scene/detail/text_file.hpp"
#include "graze/scene/detail/torque_table.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

// "a number greater than 0, in m"
std::string number_words(const Key& key) {
  if (key.what) return key.what;
  const std::string range = key.range.words, unit = key.unit;
  return "a number" + (range.empty() ? "" : " " + range) +
         (unit.empty() ? "" : (range.empty() ? " in " : ", in ") + unit);
}

std::string list_words(const Key& key) {
  if (key.what) return key.what;
  const std::string unit = key.unit;
  return fmt::format("a list of numbers{}, one per mode", unit.empty() ? "" : " in " + unit);
}

// Data shared by all tables of one scene.
struct Reading {
  Scene& scene;
  Origins& origins;
  std::filesystem::path folder;
  WrittenUnits written{};
};

// Choices, and which tables there are, come first, in all tables of the scene, since they decide
// which of the other keys apply.
enum class Pass { kChoices, kValues };

template <class Table>
void read_table(Reading& reading, const Node& node, const std::string& path, Table& value,
                Pass pass);

class KeyReader : public SchemaVisitor {
 public:
  KeyReader(Reading& reading, const TableReader& table, Pass pass)
      : reading_(reading), table_(table), pass_(pass) {}

  template <class Number>
  void number(const Key& key, Number& value) {
    constexpr bool is_optional = !std::is_same_v<Number, double>;
    if (!is_due(key, is_optional || !key.is_required)) return;
    value = table_.number(key.name, number_words(key), unit_of(key));
    note_unit(key);
  }
  // Whether the key holds the word decides which other keys apply.
  void number_or(const Key& key, double& value, bool& is_word, const char* word) {
    const Node* node = table_.find(key.name);
    if (pass_ == Pass::kChoices) {
      const auto* text = node == nullptr ? nullptr : node->as<std::string>();
      is_word = text != nullptr && !begins_with_number(*text);
    } else if (is_due(key, !key.is_required)) {
      const std::string what = fmt::format("{} or {}", number_words(key), quoted(word));
      table_.required(key.name, what);
      if (!is_word) {
        value = table_.number(key.name, what, unit_of(key));
        note_unit(key);
      } else if (*node->as<std::string>() != word) {
        table_.refuse(key.name, what);
      }
    }
  }
  // A torque may stand already, from a file.
  void list(const Key& key, std::vector<double>& values) {
    if (!is_due(key, !key.is_required || key.is_filled || !values.empty())) return;
    const std::string what = list_words(key);
    table_.required(key.name, what);
    values = table_.numbers(key.name, what, unit_of(key));
    if (!key.is_required && values.empty())
      table_.fail(key.name, fmt::format("the list is empty, it must have one number{} per mode",
                                        *key.unit ? fmt::format(" in {}", key.unit) : ""));
    const auto modes = static_cast<std::size_t>(reading_.scene.modes());
    if (key.is_filled && values.size() < modes) values.resize(modes, 0.0);
  }
  void values(const Key& key, std::vector<double>& values) {
    if (!is_due(key, !key.is_required)) return;
    const std::string what = list_words(key);
    table_.required(key.name, what);
    values = table_.numbers(key.name, what, unit_of(key));
    if (values.empty()) table_.fail(key.name, "the list is empty, it must have a number");
  }
  void entries(const Key& key, std::string& file, MatrixEntries& rows) {
    if (!is_due(key, !key.is_required)) return;
    const char* what = "the name of a file, or a list of rows like [[1.0, 0.0], [0.0, 2.0]]";
    if (table_.required(key.name, what).as<NodeList>() != nullptr)
      rows = symmetric_rows(key, table_.rows(key.name, what, unit_of(key)));
    else
      path(key, file);
  }
  // A number is the list of one entry.
  void series(const Key& key, std::vector<double>& values) {
    if (!is_due(key, false)) return;
    if (table_.required(key.name, key.what).as<NodeList>() != nullptr)
      values = table_.numbers(key.name, key.what, unit_of(key));
    else
      values = {table_.number(key.name, key.what, unit_of(key))};
  }
  void taper(const Key& key, Taper& values) {
    if (!is_due(key, false)) return;
    series(key, values);
    if (values.size() != 1 && values.size() != 2)
      table_.fail(key.name,
                  fmt::format("the list has {} entries, it must have two, of the left and "
                              "of the right end",
                              values.size()));
  }
  void ends(const Key& key, auto& held, const auto& choices, const auto&) {
    if (pass_ == Pass::kValues || !table_.has(key.name)) return;
    std::vector<std::string> words;
    for (const auto& choice : choices) words.push_back(choice.name);
    const std::vector<std::size_t> found = table_.words(key.name, words, held.size());
    for (std::size_t k = 0; k < held.size(); ++k) held[k] = choices[found[k]].value;
  }
  void bodies(const Key& key, SpringGeometry& geometry, BodyNumbers which) {
    if (!is_due(key, false)) return;
    table_.required(key.name, key.what);
    const std::vector<double> numbers = table_.numbers(key.name, key.what, unit_of(key));
    if (!set_body_numbers(geometry, which, numbers))
      table_.fail(key.name,
                  fmt::format("the list has {} entries, it must have two, {}", numbers.size(),
                              which == BodyNumbers::kRadii ? "of balls, or four" : "one per body"));
  }
  void count(const Key& key, int& value) {
    if (!is_due(key, !key.is_required)) return;
    const std::string what = fmt::format("an integer {}", key.range.words);
    const std::int64_t number = table_.integer(key.name, what);
    if (!key.range.holds(static_cast<double>(number))) table_.refuse(key.name, what);
    value = static_cast<int>(number);
  }
  void flag(const Key& key, bool& value) {
    if (is_due(key, true)) value = table_.flag_or(key.name, value);
  }
  void text(const Key& key, std::string& value) {
    if (is_due(key, true)) value = table_.text_or(key.name, value);
  }
  void path(const Key& key, std::string& value) {
    if (!is_due(key, !key.is_required)) return;
    table_.required(key.name, "the name of a file");
    const std::string name = table_.text_or(key.name, "");
    if (name.empty()) table_.fail(key.name, "the name is empty, it must be that of a file");
    value = std::filesystem::absolute(reading_.folder / name).lexically_normal().string();
  }
  void label(const Key& key, std::string& value) {
    if (is_due(key, !key.is_required)) value = table_.label(key.name, key.what);
  }
  void labels(const Key& key, std::vector<std::string>& values) {
    if (is_due(key, !key.is_required)) values = table_.labels(key.name, key.what);
  }
  // The points of a torque stand in the scene or in a file.
  void file(const Key& key, TorqueTable& points) {
    if (is_due(key, true)) {
      for (const char* other : {"times", "values"})
        if (table_.has(other)) table_.fail(other, "the table is in a file, it must be left out");
      const std::string name = table_.text_or(key.name, "");
      if (name.empty()) table_.fail(key.name, "the name is empty, it must be that of a CSV file");
      points = read_torque_file(reading_.folder / name);
    } else if (pass_ == Pass::kValues && key.applies && !table_.has("times") &&
               !table_.has("values")) {
      table_.fail(key.name,
                  "the key is missing, it must be the name of a CSV file with time (s) and torque "
                  "(N m), or times and values must be given");
    }
  }
  template <class Value>
  void choice(const Key& key, Value& value, const auto& choices) {
    if (pass_ == Pass::kValues) {
      is_due(key, true);
      return;
    }
    std::vector<std::pair<std::string, Value>> named;
    std::vector<std::string> words;
    for (const auto& choice : choices) {
      named.emplace_back(choice.name, choice.value);
      words.push_back(quoted(choice.name));
    }
    if (key.is_kept && !table_.has(key.name)) return;
    if (key.is_required) table_.required(key.name, key.what ? key.what : joined(words, "or"));
    value = table_.choice<Value>(key.name, named);
  }
  // An optional, made where the scene has it, or a pointer to what there must be.
  void table(const TableKey& key, auto&& value) {
    const Node* node = table_.find(key.name);
    if (node == nullptr) return;
    if constexpr (requires { value.emplace(); })
      if (pass_ == Pass::kChoices) value.emplace();
    if (value) read_table(reading_, *node, table_.path(key.name), *value, pass_);
  }
  // One table, or a list of them.
  template <class First, class Other>
  void leading(const TableKey& key, std::optional<First>& first, std::vector<Other>& others) {
    const Node* node = table_.find(key.name);
    if (node == nullptr || node->as<NodeList>() == nullptr) return table(key, first);
    const std::string path = table_.path(key.name);
    const NodeList& entries = *node->as<NodeList>();
    if (entries.empty()) return;
    if (pass_ == Pass::kChoices) first.emplace();
    others.resize(entries.size() - 1);
    read_table(reading_, entries[0], path, *first, pass_);
    for (std::size_t k = 1; k < entries.size(); ++k)
      read_table(reading_, entries[k], numbered_path(path, k + 1), others[k - 1], pass_);
  }
  // The tables are made before their keys are read.
  template <class Table>
  void tables(const TableKey& key, std::vector<Table>& values) {
    const Node* node = table_.find(key.name);
    if (node == nullptr) return;
    const std::string path = table_.path(key.name);
    if (may_be_list_of_tables(path) && node->as<NodeList>() == nullptr) {
      values.resize(1);
      return read_table(reading_, *node, path, values.front(), pass_);
    }
    const NodeList& entries = tables_of(*node, path);
    values.resize(entries.size());
    for (std::size_t k = 0; k < values.size(); ++k)
      read_table(reading_, entries[k], numbered_path(path, k + 1), values[k], pass_);
  }

 private:
  void note_unit(const Key& key) {
    if (const auto* text = table_.find(key.name)->as<std::string>())
      reading_.written[first_unnumbered(table_.path(key.name))] = unit_behind_number(*text);
  }
  // Throws where a matrix that must be symmetric is not.
  MatrixEntries symmetric_rows(const Key& key, MatrixEntries rows) const {
    for (std::size_t i = 0; key.is_symmetric && i < rows.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (rows[i][j] != rows[j][i])
          table_.fail(key.name,
                      fmt::format("the matrix is not symmetric: the entry ({}, {}) is {} and the "
                                  "entry ({}, {}) is {}",
                                  j + 1, i + 1, rows[j][i], i + 1, j + 1, rows[i][j]));
    return rows;
  }
  // The unit of its numbers where one is written with a unit of its own, which few are; nullopt
  // where none is, or none can be. That of some keys depends on other keys.
  std::optional<std::string> unit_of(const Key& key) const {
    const Node* node = table_.find(key.name);
    if (node == nullptr || !holds_text(*node) || reading_.scene.units == Units::kNone) return {};
    const std::string unit =
        is_unit(key.unit) ? key.unit : parameter_unit(reading_.scene, table_.path(key.name));
    return is_unit(unit) ? std::optional(unit) : std::nullopt;
  }
  static bool holds_text(const Node& node) {
    const auto* list = node.as<NodeList>();
    return list != nullptr ? std::any_of(list->begin(), list->end(), holds_text)
                           : node.as<std::string>() != nullptr;
  }

  // Whether the key is to be read now; refuses one that does not apply.
  bool is_due(const Key& key, bool may_lack) const {
    if (pass_ == Pass::kChoices) return false;
    if (!key.applies && key.refusal && table_.has(key.name)) table_.fail(key.name, key.refusal);
    return key.applies && (!may_lack || table_.has(key.name));
  }

  Reading& reading_;
  const TableReader& table_;
  Pass pass_;
};

template <class Table>
void read_table(Reading& reading, const Node& node, const std::string& path, Table& value,
                Pass last) {
  const TableReader table(node, path, reading.origins);
  prepare(table, node, value, reading.scene);
  const auto read = [&](Pass pass) {
    KeyReader reader(reading, table, pass);
    if constexpr (std::is_same_v<Table, Scene>)
      describe(reader, value);
    else
      describe(reader, value, reading.scene);
  };
  read(Pass::kChoices);
  if (last == Pass::kValues) read(Pass::kValues);
}

}  // namespace

namespace {

// A structure without a stop or a probe is looked at where forces act on it.
void probe_loads(Scene& scene) {
  if (!scene.stops.empty() || !scene.probes.empty()) return;
  std::vector<StructurePoint> loaded(scene.loads.begin(), scene.loads.end());
  std::vector<StructurePoint> forced;
  for (const HarmonicLoad* load : scene.harmonic_loads())
    // What holds matrices is no place of the structure.
    if (load->has_place() && !(load->kind == ForcingKind::kSupport && scene.matrices()))
      forced.push_back(load->at);
  loaded.insert(loaded.begin(), forced.begin(), forced.end());
  loaded.insert(loaded.end(), scene.frictions.begin(), scene.frictions.end());
  for (const StructurePoint& at : loaded) {
    const auto is_there = [&](const Probe& probe) {
      return probe.position == at.position && probe.shape == at.shape && probe.node == at.node &&
             probe.against == at.against;
    };
    if (scene.frictions.empty() || std::none_of(scene.probes.begin(), scene.probes.end(), is_there))
      scene.probes.push_back({at.position, at.shape, at.node, at.against});
  }
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& name,
                  const std::vector<std::string>& settings) {
  Node root = read_document(text, name);
  for (const std::string& setting : settings) apply_setting(root, setting);
  Scene scene;
  const auto origins = std::make_shared<Origins>();
  Reading reading{scene, *origins, std::filesystem::path(name).parent_path()};
  read_table(reading, root, "", scene, Pass::kValues);
  scene.origins = origins;
  if (!reading.written.empty())
    scene.written = std::make_shared<WrittenUnits>(std::move(reading.written));
  probe_loads(scene);
  read_signals(scene);
  if (scene.discrete()) solve_matrices(scene);
  check_scene(scene);
  return scene;
}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings) {
  return parse_scene(read_text_file(file, "a scene"), file.string(), settings);
}

}  // namespace graze
