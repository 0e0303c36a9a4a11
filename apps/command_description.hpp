// What the program says of its commands and their options, for help, manual pages, completions and
// callers from other languages.
#pragma once

#include <string>
#include <vector>

namespace graze {

enum class OptionKind { kFlag, kWord, kWhole, kNumber };

// An option, or a file among the words of a command.
struct OptionDescription {
  std::string name;  // without its dashes, "max-seconds"
  OptionKind kind = OptionKind::kWord;
  std::string what;                          // what it says of itself
  std::string default_value;                 // that it prints, if any
  bool takes_several = false;                // as words or between commas
  bool is_repeated = false;                  // each of its values is given by itself
  std::string short_name;                    // one letter; empty: none
  std::string placeholder;                   // "DIR", of what has a value
  std::vector<std::string> choices;          // empty: any value
  std::vector<std::string> needs, excludes;  // other options, by their names
  std::string heading;                       // of --help
  std::string help;                          // what --help prints of it, in one line
  bool is_required = false;

  bool is_flag() const { return kind == OptionKind::kFlag; }
  // "--points N"
  std::string as_given() const {
    return "--" + name + (placeholder.empty() ? "" : " " + placeholder);
  }
};

struct CommandDescription {
  std::string name, what, example;
  std::vector<OptionDescription> files, options;
};

// Headings of a command's own come first, then those that commands share, in their order.
void order_headings(std::vector<std::string>& headings);

}  // namespace graze
