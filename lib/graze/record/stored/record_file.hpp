// The result of a command as a file of its folder, from which it is printed and drawn again:
// record.json, beside scene.toml, which its systems follow from, and result.json, its document.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "graze/record/file/spool.hpp"
#include "graze/record/records.hpp"
#include "graze/record/stored/record_text.hpp"
#include "graze/record/study_records.hpp"

namespace graze {

// Names in an output folder.
inline constexpr const char* kRecordFile = "record.json";
inline constexpr const char* kSceneFile = "scene.toml";
inline constexpr const char* kDocumentFile = "result.json";

// All results from which a picture can be drawn.
using AnyRecord =
    std::variant<CheckRecord, SimulationRecord, OrbitRecord, BranchRecord, LociRecord,
                 DiagramRecord, RunDiagramRecord, MapRecord, ComparisonRecord, ComparisonMapRecord,
                 SensitivityRecord, CostRecord, FitRecord, ModesRecord>;

template <class Record>
auto& info_of(Record& record) {
  if constexpr (requires { record.info; })
    return record.info;
  else
    return record.branches.info;
}
template <class Record>
requires(
    requires(Record& any) { any.outcome; } ||
    requires(Record & any) { any.branches.outcome; }) auto& outcome_of(Record& record) {
  if constexpr (requires { record.outcome; })
    return record.outcome;
  else
    return record.branches.outcome;
}

// The text of the file. `kind`: index in AnyRecord; `values`: output of record_text;
// `document_checksum`: of the document beside it.
std::string record_file_text(const RunInfo& info, std::size_t kind, const std::string& values,
                             const std::string& document_checksum);

// The index of a type in AnyRecord.
template <class Record>
std::size_t record_kind() {
  return AnyRecord(Record{}).index();
}

struct StoredResult {
  std::filesystem::path folder;
  Scene scene;  // the one in force
  AnyRecord record;
  std::string document_checksum;

  // Passes the document on, piece by piece, after checking that it belongs to the record. Throws
  // FileError.
  void read_document(const TextSink& sink) const;
};

// Reads a folder that --out wrote, given as the folder or as the result.json or record.json in it.
// Throws FileError with a sentence that names the file and what to do: when one is missing, was cut
// short or changed, or was written by another version of the program; when the folder holds only a
// share of a work.
StoredResult read_result(const std::filesystem::path& place);

}  // namespace graze
