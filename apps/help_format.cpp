#include "help_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "graze/report/text/text.hpp"
#include "options/option.hpp"

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

void order_headings(std::vector<std::string>& headings) {
  const auto rank = [](const std::string& heading) {
    const auto shared = {kSceneGroup, kNumericsGroup, kLongWorkGroup, kOutputGroup, kPicturesGroup};
    const auto at = std::find(shared.begin(), shared.end(), heading);
    return at == shared.end() ? -1 : static_cast<int>(at - shared.begin());
  };
  std::stable_sort(headings.begin(), headings.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

std::string help_line(const OptionDescription& option) {
  std::string text = option.what;
  const std::vector<std::string>& choices = option.choices;
  const bool told = std::all_of(choices.begin(), choices.end(), [&](const std::string& choice) {
    return text.find(choice) != std::string::npos;
  });
  if (!told) text += fmt::format(" (one of {})", fmt::join(choices, ", "));
  if (!option.default_value.empty() && text.find("default") == std::string::npos)
    text += fmt::format(" (default: {})", option.default_value);
  if (option.is_required) text += " (required)";
  if (!option.excludes.empty())
    text += fmt::format("; not with --{}", fmt::join(option.excludes, ", --"));
  return text;
}

std::string footer(const std::string& example) {
  return "Example: graze " + example +
         "\nExit codes: 0 done; 2 usage or scene error; 3 the computation ended early or\n"
         "failed, and the result so far is printed; 4 file or system error; 130 interrupted.";
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
  return option->get_positional() || option->get_type_size() == 0 ? ""
                                                                  : " " + option->get_type_name();
}

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  return lines_of(option->get_description(), TextOptions{}.width - column_width_);
}

}  // namespace graze
