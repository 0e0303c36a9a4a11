#include "graze/record/stored/record_file.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "graze/assembly/assembly.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/file/checksum.hpp"
#include "graze/record/file/files.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

using Json = nlohmann::ordered_json;

// The file is an object of two lines and a bracket: the program and its call, and the values, which
// are the same however often the work was stopped and resumed.
constexpr std::string_view kBetween = ",\n\"values\": ", kRecordEnd = "\n}\n";
constexpr std::size_t kWhole = std::numeric_limits<std::size_t>::max() / 2;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw FileError(fmt::format("{}: {}; run the command that made it again", file.string(), what));
}

struct Head {
  std::string version, scene_sha256, checksum, document_checksum;
  std::vector<std::string> arguments, settings;
  std::size_t kind = 0;
};

Head head_of(std::string_view line, const std::filesystem::path& file) {
  const Json json = Json::parse(std::string(line) + "}", nullptr, false);
  Head head;
  try {
    head.version = json.at("graze");
    head.kind = json.at("kind");
    head.scene_sha256 = json.at("scene_sha256");
    head.document_checksum = json.at("document");
    head.checksum = json.at("checksum");
    head.arguments = json.at("arguments").get<std::vector<std::string>>();
    head.settings = json.at("settings").get<std::vector<std::string>>();
  } catch (const Json::exception&) {
    refuse(file, "it is damaged, or was not written by graze");
  }
  return head;
}

template <std::size_t kind = 0>
bool read_kind(std::size_t wanted, std::string_view values, AnyRecord& record) {
  if constexpr (kind < std::variant_size_v<AnyRecord>) {
    if (kind != wanted) return read_kind<kind + 1>(wanted, values, record);
    return read_record_text(values, record.emplace<kind>());
  } else {
    return false;
  }
}

// Fills in what follows from the scene.
template <class Record>
void complete(Record& record, const Scene& scene) {
  if constexpr (requires { record.system; }) record.system = assemble(scene);
}
void complete(DiagramRecord& record, const Scene& scene) { complete(record.branches, scene); }
void complete(ComparisonRecord& record, const Scene& scene) {
  const std::string& text = record.info.scene_text;
  for (std::size_t i = 0; i < record.runs.size(); ++i) {
    record.runs[i].system = i < record.settings.size() && !record.settings[i].empty()
                                ? assemble(parse_scene(text, "scene", record.settings[i]))
                                : assemble(scene);
  }
}

std::string text_in(const std::filesystem::path& file) { return read_file(file, kWhole); }

}  // namespace

std::string record_file_text(const RunInfo& info, std::size_t kind, const std::string& values,
                             const std::string& document_checksum) {
  const Json head = {{"graze", info.version},
                     {"command", info.command},
                     {"kind", kind},
                     {"scene_sha256", info.scene_sha256},
                     {"document", document_checksum},
                     {"checksum", checksum(values)},
                     {"arguments", info.arguments},
                     {"settings", info.settings}};
  std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.pop_back();
  text += kBetween;
  text += values;
  text += kRecordEnd;
  return text;
}

void StoredResult::read_document(const TextSink& sink) const {
  const std::filesystem::path file = folder / kDocumentFile;
  Checksum sum;
  read_pieces(file, [&](std::string_view piece) {
    sum.add(piece);
    return true;
  });
  if (sum.text() != document_checksum)
    refuse(file,
           fmt::format("it was changed or cut short, or is not of the run of {}", kRecordFile));
  read_pieces(file, [&](std::string_view piece) {
    sink(piece);
    return true;
  });
}

StoredResult read_result(const std::filesystem::path& place) {
  std::error_code no_matter;  // ignored: a file that cannot be inspected cannot be read either
  StoredResult result;
  result.folder = place;
  const bool names_file = place.filename() == kDocumentFile || place.filename() == kRecordFile;
  if (names_file && !std::filesystem::is_directory(place, no_matter))
    result.folder = place.has_parent_path() ? place.parent_path() : ".";
  const std::filesystem::path file = result.folder / kRecordFile;
  if (!std::filesystem::exists(result.folder, no_matter))
    throw FileError(
        fmt::format("{}: there is no such folder; give one that --out of a command has written",
                    result.folder.string()));
  if (!std::filesystem::exists(file, no_matter))
    throw FileError(fmt::format(
        "{}: it is missing, so there is no result to show; give a folder that --out of a command "
        "has written to its end (shares of a work are joined by graze merge)",
        file.string()));
  const std::string text = text_in(file);
  const std::string_view whole = text;
  const std::size_t between = whole.find(kBetween);
  if (between == std::string_view::npos) refuse(file, "it is damaged, or was not written by graze");
  const Head head = head_of(whole.substr(0, between), file);
  if (head.version != version())
    refuse(file,
           fmt::format("it was written by graze {}, and this is {}", head.version, version()));
  std::string_view values = whole.substr(between + kBetween.size());
  if (!values.ends_with(kRecordEnd)) refuse(file, "it was cut short");
  values.remove_suffix(kRecordEnd.size());
  if (checksum(values) != head.checksum) refuse(file, "it is damaged");
  const std::filesystem::path scene_file = result.folder / kSceneFile;
  const std::string scene_text = text_in(scene_file);
  if (sha256(scene_text) != head.scene_sha256)
    refuse(scene_file, fmt::format("it was changed, or is not of the run of {}", kRecordFile));
  result.scene = parse_scene(scene_text, scene_file.string());
  if (!read_kind(head.kind, values, result.record))
    refuse(file, "it was written by another build of this version of graze");
  result.document_checksum = head.document_checksum;
  std::visit(
      [&](auto& record) {
        RunInfo& info = info_of(record);
        info.scene_text = scene_text;
        info.arguments = head.arguments;
        info.settings = head.settings;
        info.folder = result.folder.string();
        complete(record, result.scene);
      },
      result.record);
  return result;
}

}  // namespace graze
