// The reference of results in docs/results.md tells what is described, and nothing else.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/result_visitor.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/share_record.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/csv/csv.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Of each list and part what is in it: "`speed` (m/s, of approach)".
class Reference : public ResultVisitor {
 public:
  struct Row {
    std::string path, what, some, entries;
  };
  const std::vector<Row>& rows() const { return rows_; }
  // The list whose elements are rows of the table; empty: none of the document.
  std::string rows_of(const std::string& table) const {
    const auto known = tables_.find(table);
    return known == tables_.end() ? "" : known->second;
  }
  bool sees_all() const override { return true; }

 protected:
  bool open(const Field& field, Shape shape) override {
    if (field.use == Field::Use::kTables) return false;
    if (shape == Shape::kValues && !field.name.empty()) add(field, "[]");
    const bool has_row = shape != Shape::kElement && shape != Shape::kValues && !field.name.empty();
    levels_.push_back(
        {levels_.back().row, levels_.back().in_columns || shape == Shape::kColumns, some_.size()});
    if (!has_row) return true;
    const std::string& above = rows_[levels_.back().row].path;
    const bool is_list = shape == Shape::kList || shape == Shape::kSpread;
    levels_.back().row = rows_.size();
    rows_.push_back(
        {fmt::format("{}{}{}{}", above, above.empty() ? "" : ".", field.name, is_list ? "[]" : ""),
         std::string(field.what), some_.empty() ? "" : some_.back(), ""});
    return true;
  }
  void close() override { levels_.pop_back(); }
  bool wants(Field::Use use) const override { return use != Field::Use::kTables; }
  void take(const Field& field, const FieldValue&) override {
    if (field.name.empty() || field.use == Field::Use::kTables || field.use == Field::Use::kUnit)
      return;
    add(field, levels_.back().in_columns ? "[]" : "");
  }
  bool begin_row(std::string_view table) override {
    tables_.emplace(table, rows_[levels_.back().row].path);
    return true;
  }
  void begin_some(std::string_view who) override {
    some_.emplace_back(who);
    turns_ = true;
  }
  void end_some() override {
    some_.pop_back();
    turns_ = true;
  }

 private:
  struct Level {
    std::size_t row;
    bool in_columns;
    std::size_t some;  // conditions that hold for all that is in it
  };

  void add(const Field& field, const char* brackets) {
    std::string& entries = rows_[levels_.back().row].entries;
    const char* between = field.unit.empty() || field.what.empty() ? "" : ", ";
    const std::string inside = fmt::format("{}{}{}", field.unit, between, field.what);
    if (!entries.empty()) entries += turns_ ? "; " : ", ";
    if (turns_ && some_.size() > levels_.back().some) entries += some_.back() + " ";
    turns_ = false;
    entries +=
        fmt::format("`{}{}`{}", field.name, brackets, inside.empty() ? "" : " (" + inside + ")");
  }

  std::vector<Row> rows_ = {{"", "", "", ""}};
  std::vector<Level> levels_ = {{0, false, 0}};
  std::vector<std::string> some_;  // who has what is handed over
  std::map<std::string, std::string, std::less<>> tables_;
  bool turns_ = false;  // what comes is of others than what came
};

// The rows of the page.
class Page {
 public:
  // What begins every document.
  Page() {
    Reference head;
    describe_head(head, {}, {}, {});
    for (const Reference::Row& row : head.rows()) tell_row("all", row);
    head_ = head.rows().front().entries;
  }

  template <class Record>
  void tell(const std::string& command, const Record& record) {
    Reference reference;
    describe(reference, record);
    for (Reference::Row row : reference.rows()) {
      if (row.path.empty()) row.entries.erase(0, std::min(head_.size() + 2, row.entries.size()));
      tell_row("`" + command + "`", row);
    }
    for (const NamedTable& table : tables_of(record))
      tell_table(table.name, table.make(), reference.rows_of(table.name));
  }
  void tell_table(const std::string& name, const ResultTable& table, const std::string& rows) {
    std::string columns;
    for (const ColumnBuilder& column : table.columns()) {
      const ResultColumn& told = column.column();
      columns += fmt::format("{}`{}`{}", columns.empty() ? "" : ", ", told.name,
                             told.unit.empty() ? "" : " (" + told.unit + ")");
    }
    if (is_new(name + "|" + columns, name))
      lines_.push_back(
          fmt::format("|`{}.csv`|{}|{}|", name, rows.empty() ? "" : "`" + rows + "`", columns));
  }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  bool is_new(const std::string& what, const std::string& where) {
    return told_.emplace(what, where).second;
  }
  // What several results have in common is told once.
  void tell_row(const std::string& command, const Reference::Row& row) {
    if (row.what.empty() && row.entries.empty()) return;
    const std::string leaf = row.path.substr(row.path.rfind('.') + 1);
    if (!is_new(leaf + "|" + row.what + row.entries, row.path)) return;
    std::string text = row.what;
    if (!row.some.empty()) text += (text.empty() ? "" : "; ") + row.some;
    if (!row.entries.empty()) text += (text.empty() ? "" : ": ") + row.entries;
    lines_.push_back(
        fmt::format("|{}|{}|{}|", command, row.path.empty() ? "" : "`" + row.path + "`", text));
  }

  std::map<std::string, std::string> told_;
  std::string head_;
  std::vector<std::string> lines_;
};

MeasuredPlace tip() { return {{}, 0, "m", {Vector::Ones(1), false}}; }

SimulationRecord full_run(const System& system) {
  SimulationRecord run;
  run.system = system;
  run.places = {tip()};
  run.run.energy.emplace();
  run.run.amplitudes.emplace();
  run.run.amplitudes->stops.resize(1);
  run.run.amplitudes->forces.emplace();
  run.run.amplitudes->forces->means.resize(1);
  run.statistics.emplace();
  run.section.emplace(DiagramSection::kImpact, 0.0);
  return run;
}

void tell_branches(Page& page, const System& system) {
  OrbitRecord orbits;
  orbits.system = system;
  orbits.places = {tip()};
  page.tell("orbit", orbits);
  BranchRecord branches;
  branches.system = system;
  branches.system.stops.push_back({Vector::Ones(1), 1.0, ContactForce{}});
  branches.amplitudes.places = {tip()};
  branches.traced.levels = {"speed=1"};
  branches.traced.has_normal_forms = true;
  page.tell("continue", branches);
  LociRecord loci;
  loci.regions.emplace();
  loci.traced.levels = {"speed=1"};
  loci.regions->places.resize(1);
  page.tell("continue --locus", loci);
  DiagramRecord diagram;
  diagram.branches = branches;
  diagram.swept.options.exponent_periods = 1;
  page.tell("diagram", diagram);
}

// Whatever may be in it is.
std::vector<std::string> described_lines() {
  Page page;
  const System system = support::forced_oscillator(1.0, 0.1, 1.0, 0.8, 1.0, 1.0);
  page.tell("check", CheckRecord{});
  page.tell("modes", ModesRecord{});
  page.tell("simulate", full_run(system));
  page.tell_table("events", events_table({}), "events[]");
  tell_branches(page, system);
  RunDiagramRecord runs;
  runs.probes.resize(1);
  page.tell("diagram --duration", runs);
  MapRecord map;
  map.places = {tip()};
  map.map.options.exponent_periods = 1;
  page.tell("map", map);
  page.tell("compare", ComparisonRecord{});
  page.tell("compare --second", ComparisonMapRecord{});
  SensitivityRecord sensitivity;
  sensitivity.probes.resize(1);
  page.tell("compare --sensitivity", sensitivity);
  CostRecord cost;
  cost.costs.impacts = 1;
  page.tell("cost", cost);
  page.tell("fit", FitRecord{});
  return page.lines();
}

std::vector<std::string> lines_of_page() {
  std::vector<std::string> lines;
  std::ifstream page(std::string(GRAZE_SOURCE_DIR) + "/docs/results.md");
  std::string line;
  while (std::getline(page, line) && line != "## JSON") continue;
  while (std::getline(page, line) && line != "### Other files")
    if (line.starts_with("|`") || line.starts_with("|all")) lines.push_back(line);
  return lines;
}

// Documents first, then tables, each in the order of the commands.
std::string sorted(std::vector<std::string> lines) {
  std::stable_partition(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find(".csv`|") == std::string::npos;
  });
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

TEST(ResultsReference, TellsWhatIsDescribed) {
  EXPECT_EQ(sorted(lines_of_page()), sorted(described_lines()));
  if (const char* file = std::getenv("GRAZE_RESULTS"))
    std::ofstream(file) << sorted(described_lines());
}

}  // namespace
}  // namespace graze
