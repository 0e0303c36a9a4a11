// What all commands share: the scene, warnings, progress, the end.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "caller.hpp"
#include "command.hpp"
#include "drawing.hpp"
#include "graze/record/file/files.hpp"
#include "graze/record/file/spool.hpp"
#include "graze/record/records.hpp"
#include "graze/record/stored/record_file.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// The command's scene with its settings, and further ones.
Scene scene_of(const SceneOptions& command, const std::vector<std::string>& further = {});

// Set by Ctrl-C; long work polls it and keeps what it finished.
extern std::atomic<bool> interrupted;
// Set once there may be something to keep; before, Ctrl-C ends the program at once.
extern std::atomic<bool> has_begun;

// Of a command on `scene`, the one in force: with how the program was called, for whoever wants the
// result again; options still empty.
RunInfo info_of_call(const SceneOptions& command, const Scene& scene);

// Ctrl-C, and --max-seconds from when the command was given.
StopSignal stop_signal(const CommonOptions& command);

// Once the command is known to be sound and before its work begins: makes the output folder and
// checks the picture's, so that hours of work do not end at a folder that cannot be written.
void prepare_output(const CommonOptions& command);

// Prints warnings on stderr unless quiet.
void warn(const CommonOptions& command, const std::vector<std::string>& warnings);

// A progress line on stderr, or nothing when stderr is no terminal or the user wants quiet. With a
// number of `things` also how many of them are done in a second, and the time that is left.
std::function<void(double)> progress_line(const CommonOptions& command, int count = 0,
                                          const char* things = "");

// Names in the output folder, and contents.
using NamedFiles = std::vector<std::pair<std::string, std::string>>;

// What a command ends with, each made only where it is wanted.
struct Result {
  std::function<Document()> json;
  std::function<std::string(const TextOptions&)> text;
  std::function<NamedFiles()> files{};  // beside the document; empty: none
  std::function<void()> draw{};
  std::vector<PendingFile> tables{};                         // files that have grown on the way
  std::function<std::vector<NamedTable>()> record_tables{};  // those that the record makes
  // The record as a file, for graze view, from the checksum of the document; empty: none.
  std::function<std::string(const std::string& document_checksum)> record{};
};

// The document and the text of a record, which has to outlive them.
template <class Record>
std::function<Document()> json_of(const Record&& record) = delete;
template <class Record>
std::function<std::string(const TextOptions&)> text_of(const Record&& record) = delete;
template <class Record>
std::function<Document()> json_of(const Record& record) {
  return [&record] { return Document(to_json(record)); };
}
template <class Record>
std::function<std::string(const TextOptions&)> text_of(const Record& record) {
  return [&record](const TextOptions& options) { return to_text(record, options); };
}

// Writes the result's files, prints it, draws it; returns the exit code of the outcome.
int conclude(const CommonOptions& command, const RunInfo& info, const Outcome& outcome,
             Result result);

// The same for a record of a motion in `scene`, with its tables and further files. `result`: what
// is printed of it otherwise than of other records. A caller takes the record.
template <class Record>
int conclude(const CommonOptions& command, Record& record, const Scene& scene,
             std::function<NamedFiles()> files = {}, Result result = {}) {
  if constexpr (requires { to_json(record); })
    if (!result.json) result.json = json_of(record);
  result.text = text_of(record);
  result.files = std::move(files);
  result.record_tables = [&record] { return tables_of(record); };
  if constexpr (requires { draw(command, record, scene); })
    result.draw = [&] {
      if (nothing_to_draw(record).empty()) draw(command, record, scene);
    };
  result.record = [&](const std::string& document_checksum) {
    return record_file_text(info_of(record), record_kind<Record>(), record_text(record),
                            document_checksum);
  };
  const int code = conclude(command, info_of(record), outcome_of(record), std::move(result));
  if (command.caller) command.caller->take(std::move(record), scene, {});
  return code;
}

// A result's text as it is printed.
std::string printed_text(const CommonOptions& command, const std::string& text);
// Prints on stdout what `read` hands out. Throws FileError.
void print(const std::function<void(const TextSink&)>& read);

// What each command does; the exit code.
int run(const InitCommand& command);
int run(const CheckCommand& command);
int run(const ModesCommand& command);
int run(const SimulateCommand& command);
int run(const OrbitCommand& command);
int run(const ContinueCommand& command);
int run(const DiagramCommand& command);
int run(const MapCommand& command);
int run(const MergeCommand& command);
int run(const CostCommand& command);
int run(const FitCommand& command);
int run(const CompareCommand& command);
int run(const ViewCommand& command);
// Parts of them.
int run_loci(const ContinueCommand& command);                                // --locus
int run_diagram_of_runs(const DiagramCommand& command, const Scene& scene);  // without forcing
int run_sensitivity(const CompareCommand& command);                          // --sensitivity

}  // namespace graze
