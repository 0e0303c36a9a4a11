#include "graze.h"

#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "command.hpp"
#include "found_result.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/scene/reader.hpp"
#include "program.hpp"
#include "work_thread.hpp"

namespace {

using namespace graze;

constexpr const char* kSceneName = "scene.toml";

struct Column {
  std::vector<double> owned;     // or
  const double* seen = nullptr;  // in the memory of rows
  std::size_t count = 0, stride = 1;
  std::vector<std::string> words;

  const double* data() const { return seen ? seen : owned.data(); }
};

struct NamedColumn {
  std::string name;
  Column column;
};

using Columns = std::vector<NamedColumn>;

Column numbers(std::vector<double> list) {
  Column column;
  column.count = list.size();
  column.owned = std::move(list);
  // An empty column is a column too, and null is none.
  if (column.owned.empty()) column.owned.reserve(1);
  return column;
}

Column column_of(WordColumn&& of) {
  std::vector<double> list;
  for (const std::int32_t code : of.codes) list.push_back(code < 0 ? NAN : code);
  Column column = numbers(std::move(list));
  column.words = std::move(of.words);
  return column;
}
Column column_of(TruthColumn&& of) {
  std::vector<double> list;
  for (const std::int8_t code : of.codes) list.push_back(code < 0 ? NAN : code);
  return numbers(std::move(list));
}
Column column_of(std::vector<double>&& of) { return numbers(std::move(of)); }
Column column_of(std::vector<std::int64_t>&& of) { return numbers({of.begin(), of.end()}); }

void add_rows(const Rows& rows, Columns& columns) {
  for (std::size_t i = 0; i < rows.columns().size(); ++i)
    columns.push_back(
        {rows.columns()[i], {{}, rows.data() + i, rows.count(), rows.columns().size(), {}}});
}

// One reader reads one command at a time.
class SharedReader {
 public:
  SharedReader() {
    for (const CommandDescription& command : reader_.descriptions())
      for (const OptionDescription& file : command.files)
        if (file.name == "SCENE") of_scenes_.insert(command.name);
  }

  Command read(const std::vector<std::string>& words) {
    const std::lock_guard lock(mutex_);
    return reader_.read(words);
  }
  bool takes_scene(const std::string& command) const { return of_scenes_.contains(command); }

 private:
  std::mutex mutex_;
  CommandReader reader_;
  std::set<std::string> of_scenes_;
};

// The scene stands behind the command's name, as in the program.
Command command_of(const char* scene, std::vector<std::string> words) {
  static SharedReader reader;
  if (scene && !words.empty() && reader.takes_scene(words.front()))
    words.insert(words.begin() + 1, kSceneName);
  Command command = reader.read(words);
  std::visit(
      [&](auto& given) {
        using Given = std::decay_t<decltype(given)>;
        if constexpr (std::is_same_v<Given, InitCommand>)
          throw InputError("init: it only prints a scene, which the program does");
        if constexpr (std::is_same_v<Given, CheckCommand>)
          if (given.parameters) throw InputError("--parameters: the program alone lists them");
        if constexpr (requires { given.given; }) {
          if (scene)
            given.given =
                std::make_shared<const Scene>(parse_scene(scene, kSceneName, given.settings));
        } else if (scene) {
          throw InputError(given.name + ": it takes no scene");
        }
      },
      command);
  return command;
}

}  // namespace

struct graze_result {
  FoundResult found;
  int status = 0;
  std::string message, json;
  std::vector<std::string> tables;
  std::map<std::string, Columns> columns;  // of the tables asked for

  bool has_record() const { return found.record().has_value(); }

  // Null where there is no such table. Throws where memory is out.
  const Columns* table(const std::string& name) {
    if (!has_record()) return nullptr;
    if (const auto known = columns.find(name); known != columns.end()) return &known->second;
    Columns made;
    if (name == "samples" && found.samples()) {
      add_rows(*found.samples(), made);
    } else {
      std::optional<ResultTable> of = table_of(found, name);
      if (!of) return nullptr;
      for (ResultColumn& column : of->take_columns())
        made.push_back(
            {column.name, std::visit([](auto&& values) { return column_of(std::move(values)); },
                                     std::move(column.values))});
    }
    return &columns.emplace(name, std::move(made)).first->second;
  }

  const Column* column(const char* of, const char* name) {
    const Columns* const known = of && name ? table(of) : nullptr;
    if (!known) return nullptr;
    for (const NamedColumn& each : *known)
      if (each.name == name) return &each.column;
    return nullptr;
  }
};

namespace {

// What `work` returns, or null where it throws: nothing is thrown into C.
template <class Work>
auto safely(graze_result* result, const Work& work) noexcept -> decltype(work(*result)) {
  try {
    return result ? work(*result) : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::vector<std::string> words_of(const char* const* words, std::size_t count) {
  std::vector<std::string> list;
  for (std::size_t i = 0; words && i < count; ++i) list.emplace_back(words[i] ? words[i] : "");
  return list;
}

// Runs the command; errors are reported in the result.
void run_into(graze_result& result, const char* scene, const std::vector<std::string>& words) {
  result.status = caught(
      [&] {
        Command command = command_of(scene, words);
        std::visit([&](CommonOptions& common) { common.caller = &result.found; }, command);
        const int code = run_command(command);
        if (result.has_record()) {
          result.message = outcome_of(result.found).message;
          result.tables = table_names(result.found);
        }
        return code;
      },
      [&](const std::string& sentence, int code) {
        result.message = sentence;
        return code;
      });
}

// A result once `work` has filled it; null where memory is out.
template <class Work>
graze_result* made(const Work& work) noexcept {
  try {
    auto result = std::make_unique<graze_result>();
    work(*result);
    return result.release();
  } catch (const std::exception&) {
    return nullptr;
  }
}

}  // namespace

extern "C" {

const char* graze_version(void) {
  static const std::string text = version();
  return text.c_str();
}

graze_result* graze_run(const char* scene, const char* const* words, size_t count) {
  return made([&](graze_result& result) { run_into(result, scene, words_of(words, count)); });
}

graze_result* graze_run_watched(const char* scene, const char* const* words, size_t count,
                                graze_watch watch, void* data) {
  return made([&](graze_result& result) {
    do_beside([&, list = words_of(words, count)] { run_into(result, scene, list); },
              [&] {
                if (watch && watch(result.found.progress(), data) != 0) result.found.stop();
              });
  });
}

int graze_status(const graze_result* result) { return result ? result->status : 4; }

const char* graze_message(const graze_result* result) {
  return result ? result->message.c_str() : "out of memory";
}

const char* graze_json(graze_result* result) {
  const char* const text = safely(result, [](graze_result& of) {
    if (of.json.empty() && of.has_record()) of.json = document_of(of.found);
    return of.json.c_str();
  });
  return text ? text : "";
}

const char* graze_table_name(graze_result* result, size_t table) {
  return safely(result, [&](graze_result& of) {
    return table < of.tables.size() ? of.tables[table].c_str() : nullptr;
  });
}

const char* graze_column_name(graze_result* result, const char* table, size_t column) {
  return safely(result, [&](graze_result& of) -> const char* {
    const Columns* const known = table ? of.table(table) : nullptr;
    return known && column < known->size() ? (*known)[column].name.c_str() : nullptr;
  });
}

const double* graze_column(graze_result* result, const char* table, const char* column,
                           size_t* count, size_t* stride) {
  const Column* const known =
      safely(result, [&](graze_result& of) -> const Column* { return of.column(table, column); });
  if (count) *count = known ? known->count : 0;
  if (stride) *stride = known ? known->stride : 0;
  return known ? known->data() : nullptr;
}

const char* graze_word(graze_result* result, const char* table, const char* column, size_t number) {
  return safely(result, [&](graze_result& of) -> const char* {
    const Column* const known = of.column(table, column);
    return known && number < known->words.size() ? known->words[number].c_str() : nullptr;
  });
}

void graze_free(graze_result* result) { delete result; }

}  // extern "C"
