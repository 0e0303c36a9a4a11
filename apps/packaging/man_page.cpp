#include "man_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "command_description.hpp"

namespace graze {
namespace {

// As groff prints it unchanged: backslashes and dashes are its own, and so are dots at a line's
// begin.
std::string plain(const std::string& text) {
  std::string escaped;
  bool at_begin = true;
  for (const char c : text) {
    if (at_begin && (c == '.' || c == '\'')) escaped += "\\&";
    at_begin = c == '\n';
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  return escaped;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string title(const std::string& name, const std::string& version) {
  return fmt::format(".TH {} 1 \"\" \"Graze {}\" \"Graze\"\n", plain(upper(name)), version);
}

std::string name_section(const std::string& name, const std::string& what) {
  return fmt::format(".SH NAME\n{} \\- {}\n", plain(name), plain(what));
}

std::string files_in_synopsis(const CommandDescription& command) {
  std::string text;
  for (const OptionDescription& file : command.files) {
    const std::string name =
        fmt::format("\\fI{}\\fR{}", plain(file.name), file.takes_several ? " .." : "");
    text += file.is_required ? " " + name : " [" + name + "]";
  }
  return text;
}

// "-o DIR, --out DIR" in bold, the values in italics.
std::string option_head(const OptionDescription& option) {
  const std::string value =
      option.placeholder.empty() ? "" : fmt::format(" \\fI{}\\fR", plain(option.placeholder));
  std::string head;
  if (!option.short_name.empty()) head = fmt::format("\\fB\\-{}\\fR{}, ", option.short_name, value);
  return head + fmt::format("\\fB{}\\fR{}", plain("--" + option.name), value);
}

std::string options_section(const CommandDescription& command) {
  std::string text = ".SH OPTIONS\n";
  std::vector<std::string> headings;
  for (const OptionDescription& option : command.options)
    if (std::find(headings.begin(), headings.end(), option.heading) == headings.end())
      headings.push_back(option.heading);
  order_headings(headings);
  for (const std::string& heading : headings) {
    text += fmt::format(".SS {}\n", plain(heading));
    for (const OptionDescription& option : command.options)
      if (option.heading == heading)
        text += fmt::format(".TP\n{}\n{}\n", option_head(option), plain(option.help));
  }
  return text;
}

std::string example_section(const std::string& example) {
  std::string text = ".SH EXAMPLES\n.nf\n";
  std::istringstream lines("graze " + example);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    const bool goes_on = begin != std::string::npos && line.compare(begin, 6, "graze ") != 0;
    text += (goes_on ? "    " : "") + plain(line.substr(begin)) + "\n";
  }
  return text + ".fi\n";
}

std::string command_entry(const CommandDescription& command) {
  return fmt::format(".TP\n\\fB{}\\fR\n{}.\n", plain(command.name), plain(command.what));
}

constexpr const char* kExitStatus = R"(.SH EXIT STATUS
.TP
0
Done.
.TP
2
The command line or the scene cannot be used.
.TP
3
The computation ended early or failed; the result so far is printed.
.TP
4
A file or the system failed.
.TP
130
Interrupted; what was finished is kept.
)";

}  // namespace

std::string man_page(const std::vector<CommandDescription>& commands, const std::string& version) {
  std::string text =
      title("graze", version) + name_section("graze",
                                             "motion, periodic orbits and branches of impacting "
                                             "flexible structures");
  text += ".SH SYNOPSIS\n\\fBgraze\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fISCENE\\fR ..]\n";
  text +=
      ".SH DESCRIPTION\n"
      "A scene is a TOML file that describes a structure, how it is driven and what it meets; "
      "what\n"
      "it does not name is not simulated. \\fBgraze init\\fR writes one to begin with.\n"
      ".SH COMMANDS\n";
  std::string others;
  for (const CommandDescription& command : commands) {
    text += command_entry(command);
    others +=
        fmt::format("{}.BR {} (1)", others.empty() ? "" : " ,\n", plain("graze-" + command.name));
  }
  return text + kExitStatus + ".SH SEE ALSO\n" + others + "\n";
}

std::string man_page_of_ranks(const std::vector<CommandDescription>& commands,
                              const std::string& version) {
  std::string text = title("graze-mpi", version) +
                     name_section("graze-mpi", "graze as the ranks of an MPI job") + R"(.SH SYNOPSIS
\fBmpirun\fR [\fIOPTIONS OF MPIRUN\fR] \fBgraze\-mpi\fR \fICOMMAND\fR [\fIOPTIONS\fR] \fISCENE\fR
.SH DESCRIPTION
The program
.BR graze (1)
as one rank of an MPI job: the ranks share the blocks of one command, with the options that it has
there. The first rank keeps the journal, prints and writes the results, which are those of graze to
the last byte; all read the scene, which must be the same for each. A rank uses one thread unless
\fB\-\-threads\fR says otherwise. If a rank dies the job ends, and the same command with
\fB\-\-resume\fR, here or of graze, goes on from the journal.
.SH COMMANDS
Those that have blocks; any other runs with one rank only, and of compare only maps have them.
)";
  std::string others;
  for (const CommandDescription& command : commands) {
    const auto is_shared = [](const OptionDescription& option) { return option.name == "shard"; };
    if (std::none_of(command.options.begin(), command.options.end(), is_shared)) continue;
    text += command_entry(command);
    others += fmt::format(",\n.BR {} (1)", plain("graze-" + command.name));
  }
  return text + kExitStatus +
         ".SH EXAMPLES\n.nf\nmpirun \\-n 4 graze\\-mpi map scene.toml \\-\\-parameter "
         "forcing.frequency \\-\\-from 15 \\-\\-to 120 \\e\n"
         "    \\-\\-second stop.gap \\-\\-second\\-from 0.5e\\-3 \\-\\-second\\-to 2e\\-3 "
         "\\-\\-out runs/map \\-\\-resume\n.fi\n.SH SEE ALSO\n.BR graze (1)" +
         others + ",\n.BR mpirun (1)\n";
}

std::string man_page(const CommandDescription& command, const std::string& version) {
  const std::string name = "graze-" + command.name;
  std::string text = title(name, version) + name_section(name, command.what);
  text +=
      fmt::format(".SH SYNOPSIS\n\\fBgraze {}\\fR{}{}\n", plain(command.name),
                  files_in_synopsis(command), command.options.empty() ? "" : " [\\fIOPTIONS\\fR]");
  text += fmt::format(".SH DESCRIPTION\n{}.\n", plain(command.what));
  for (const OptionDescription& file : command.files)
    text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", plain(file.name), plain(file.help));
  if (!command.options.empty()) text += options_section(command);
  text += kExitStatus;
  if (!command.example.empty()) text += example_section(command.example);
  return text + ".SH SEE ALSO\n.BR graze (1)\n";
}

}  // namespace graze
