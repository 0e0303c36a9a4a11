#include "graze/record/file/journal_head.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <variant>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

using Json = nlohmann::ordered_json;

Json options_json(const RunInfo& info) {
  Json json = Json::object();
  for (const auto& [name, value] : info.options)
    std::visit([&, &key = name](const auto& v) { json[key] = v; }, value);
  return json;
}

}  // namespace

std::string head_text(const JournalHead& head) {
  const Json json = {{"graze", head.info.version},
                     {"command", head.info.command},
                     {"scene", head.info.scene_file},
                     {"scene_sha256", head.info.scene_sha256},
                     {"options", options_json(head.info)},
                     {"piece", head.piece},
                     {"pieces", head.pieces},
                     {"block", head.block},
                     {"share", {head.share.part, head.share.of}},
                     {"processor", head.processor},
                     {"arguments", head.info.arguments},
                     {"scene_text", head.info.scene_text}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool read_head(const std::string& text, JournalHead& head) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return false;
  try {
    head.info.version = json.at("graze");
    head.info.command = json.at("command");
    head.info.scene_file = json.at("scene");
    head.info.scene_sha256 = json.at("scene_sha256");
    head.info.scene_text = json.at("scene_text");
    head.info.arguments = json.at("arguments").get<std::vector<std::string>>();
    for (const auto& [name, value] : json.at("options").items()) {
      if (value.is_boolean())
        head.info.options.emplace_back(name, value.get<bool>());
      else if (value.is_number_integer())
        head.info.options.emplace_back(name, value.get<long long>());
      else if (value.is_number())
        head.info.options.emplace_back(name, value.get<double>());
      else
        head.info.options.emplace_back(name, value.get<std::string>());
    }
    head.piece = json.at("piece");
    head.pieces = json.at("pieces");
    head.block = json.at("block");
    head.share = {json.at("share").at(0), json.at("share").at(1)};
    head.processor = json.at("processor");
  } catch (const Json::exception&) {
    return false;
  }
  return head.block > 0 && head.share.of > 0;
}

void require_sound(const JournalHead& head, const std::string& file) {
  // As many values as an option allows, and the longest run of rows that go to one share.
  constexpr long long kMostValues = 1'000'000;
  long long told = 1;
  for (const auto& [name, value] : head.info.options)
    if (name == "points" || name == "second_points") {
      const auto* count = std::get_if<long long>(&value);
      told = count && *count > 0 && *count <= kMostValues ? told * *count : 0;
    }
  if (told <= 0 || head.pieces != static_cast<std::size_t>(told))
    throw InputError(
        fmt::format("{}: it is damaged: its first line tells of {} {}s, its options "
                    "of {}",
                    file, head.pieces, head.piece, told));
  if (head.share.part < 1 || head.share.part > head.share.of ||
      head.block > static_cast<std::size_t>(kMostValues))
    throw InputError(
        fmt::format("{}: it is damaged: its first line tells of share {}/{} in blocks "
                    "of {}",
                    file, head.share.part, head.share.of, head.block));
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t at = line.find_first_not_of(" \t", line.find(':') + 1);
    if (at != std::string::npos) return line.substr(at);
  }
  utsname machine{};
  return ::uname(&machine) == 0 ? machine.machine : "unknown";
}

void require_same_work(const JournalHead& there, const JournalHead& head, const std::string& file) {
  const auto refuse = [&](const std::string& what, const std::string& was, const std::string& is) {
    throw InputError(
        fmt::format("{}: it belongs to other work: {} was {} there and is {} here; "
                    "give another folder, or --restart-work to throw that work away",
                    file, what, was, is));
  };
  const RunInfo &a = there.info, &b = head.info;
  if (a.version != b.version) refuse("the version of graze", a.version, b.version);
  if (a.command != b.command) refuse("the command", a.command, b.command);
  const Json was = options_json(a), is = options_json(b);
  for (const Json* options : {&was, &is})
    for (const auto& [name, value] : options->items()) {
      const auto in = [&, &key = name](const Json& json) {
        return json.contains(key) ? json[key].dump() : std::string("not given");
      };
      if (in(was) != in(is)) refuse(name, in(was), in(is));
    }
  if (a.scene_sha256 != b.scene_sha256)
    refuse("the scene", a.scene_file + " as it then was", b.scene_file + " with other values");
}

}  // namespace graze
