// How --help lists the options of a command.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "command_description.hpp"

namespace graze {

// What --help says of an option, in one line: what it does, then the words that it takes, its
// default and the options that it does not go with, where that does not name them.
std::string help_line(const OptionDescription& option);

// What stands below the options of a command.
std::string footer(const std::string& example);

// What a command alone has comes first, what all have last. Lines of at most 100 characters.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_description(const CLI::App* app) const override;
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_subcommand(const CLI::App* app) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;

 private:
  std::string ordered_groups(const CLI::App* app) const;
};

}  // namespace graze
