#include "graze/report/text/detail/sentences.hpp"

#include <fmt/format.h>

namespace graze {

std::string ending(const Outcome& outcome) {
  return outcome.message.empty() ? "" : fmt::format("{}: {}\n", outcome.name, outcome.message);
}

std::string notes_text(const std::vector<std::string>& notes,
                       const std::vector<std::string>& details, const TextOptions& options) {
  std::string text;
  for (const std::string& note : notes) text += fmt::format("note: {}\n", note);
  if (options.verbose)
    for (const std::string& detail : details) text += fmt::format("note: {}\n", detail);
  return text;
}

}  // namespace graze
