#include "help_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "graze/report/text/text.hpp"
#include "option_groups.hpp"
#include "usage_errors.hpp"

namespace graze {
namespace {

// As lines that are at most so wide; what goes on is not indented, which is done where it is shown.
std::string lines_of(const std::string& text, std::size_t width) {
  std::string lines = fitted_lines(text, {width, false});
  for (std::size_t at = 0; (at = lines.find("\n ", at)) != std::string::npos;)
    lines.erase(at + 1, lines.find_first_not_of(' ', at + 1) - at - 1);
  return lines;
}

}  // namespace

std::string help_line(const CLI::Option& option) {
  std::string text = option.get_description();
  const std::vector<std::string> choices = choices_of(option);
  const bool told = std::all_of(choices.begin(), choices.end(), [&](const std::string& choice) {
    return text.find(choice) != std::string::npos;
  });
  if (!told) text += fmt::format(" (one of {})", fmt::join(choices, ", "));
  const std::string standard = option.get_default_str();
  if (!standard.empty() && text.find("default") == std::string::npos)
    text += fmt::format(" (default: {})", standard);
  if (option.get_required()) text += " (required)";
  if (!option.get_excludes().empty()) {
    std::vector<std::string> others;
    for (const CLI::Option* other : option.get_excludes()) others.push_back(other->get_name());
    std::sort(others.begin(), others.end());
    text += fmt::format("; not with {}", fmt::join(others, ", "));
  }
  return text;
}

std::string HelpFormat::make_description(const CLI::App* app) const {
  return fitted_lines(app->get_description(), {}) + "\n";
}

std::string HelpFormat::ordered_groups(const CLI::App* app) const {
  std::vector<std::string> headings = app->get_groups();
  order_headings(headings);
  std::string text;
  for (const std::string& heading : headings) {
    const std::vector<const CLI::Option*> below = app->get_options([&](const CLI::Option* option) {
      return option->get_group() == heading && option->nonpositional();
    });
    if (!below.empty()) text += make_group(heading, false, below) + "\n";
  }
  return text;
}

// One empty line between groups.
std::string HelpFormat::make_help(const CLI::App* app, std::string name,
                                  CLI::AppFormatMode mode) const {
  if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
  const std::string text = make_description(app) + make_usage(app, std::move(name)) +
                           make_positionals(app) + ordered_groups(app) +
                           make_subcommands(app, mode) + "\n" + make_footer(app);
  return CLI::detail::find_and_replace(text, "\n\n\n", "\n\n");
}

std::string HelpFormat::make_subcommand(const CLI::App* app) const {
  std::ostringstream out;
  CLI::detail::format_help(out, app->get_name(),
                           lines_of(app->get_description(), TextOptions{}.width - column_width_),
                           column_width_);
  return out.str();
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  return with_placeholder(*option).substr(option->get_name().size());
}

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  return lines_of(help_line(*option), TextOptions{}.width - column_width_);
}

}  // namespace graze
