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

// What a command can end with and be drawn from.
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

// What the file holds. `kind`: which of AnyRecord; `values`: what record_text made of it;
// `document_checksum`: of the document beside it.
std::string record_file_text(const RunInfo& info, std::size_t kind, const std::string& values,
                             const std::string& document_checksum);

// The place of a type in AnyRecord.
template <class Record>
std::size_t record_kind() {
  return AnyRecord(Record{}).index();
}

struct StoredResult {
  std::filesystem::path folder;
  Scene scene;  // the one in force
  AnyRecord record;
  std::string document_checksum;

  // The document, piece by piece, after it was found to be that of the record. Throws FileError.
  void read_document(const TextSink& sink) const;
};

// Reads a folder that --out wrote, given as that or as the result.json or record.json in it. Throws
// FileError with a sentence that names the file and what to do: where one is missing, was cut short
// or changed, or was written by another version of the program; where the folder holds a share of a
// work only.
StoredResult read_result(const std::filesystem::path& place);

}  // namespace graze
