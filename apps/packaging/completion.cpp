#include "completion.hpp"

#include <algorithm>

namespace graze {

ValueKind value_kind(const OptionDescription& option) {
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
  // "With --show: the place, e.g. probe.1" is about the place.
  const std::size_t condition = what.rfind("With --", 0) == 0 ? what.find(": ") : std::string::npos;
  const std::string text = condition == std::string::npos ? what : what.substr(condition + 2);
  std::size_t end = text.size();
  for (const char* stop : {"; ", ": ", ". ", ", e.g. ", " ("}) end = std::min(end, text.find(stop));
  if (end <= kMost) return text.substr(0, end);
  return text.substr(0, text.rfind(' ', kMost)) + " ..";
}

}  // namespace graze
