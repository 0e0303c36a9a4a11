// How --help lists the options of a command.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace graze {

// What --help says of an option, in one line.
std::string help_line(const CLI::Option& option);

// What a command alone has comes first, what all have last. Lines of at most 100 characters; behind
// what an option does stand the words that it takes, its default and the options that it does not
// go with, where its description does not tell them.
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
