#include "completion.hpp"

#include <algorithm>

namespace graze {

ValueKind value_kind(const CommandReader::Option& option) {
  const auto begins = [&](const char* with) { return option.placeholder.rfind(with, 0) == 0; };
  if (!option.choices.empty()) return ValueKind::kChoice;
  if (option.name == "COMMAND") return ValueKind::kCommand;
  if (option.name == "SCENE") return ValueKind::kScene;
  if (option.name == "RESULT" || option.name == "FOLDER" || option.placeholder == "DIR")
    return ValueKind::kFolder;
  if (option.name == "DATA" || option.name == "FILE" || begins("FILE")) return ValueKind::kFile;
  if (option.name == "set" || option.name == "against" || begins("NAME=LOW"))
    return ValueKind::kSetting;
  if (option.name == "parameter" || option.name == "second") return ValueKind::kParameter;
  return ValueKind::kAny;
}

std::string in_brief(const std::string& what) {
  constexpr std::size_t kMost = 70;
  std::size_t end = what.size();
  for (const char* stop : {"; ", ": ", ". ", " ("}) end = std::min(end, what.find(stop));
  if (end <= kMost) return what.substr(0, end);
  return what.substr(0, what.rfind(' ', kMost)) + " ..";
}

}  // namespace graze
