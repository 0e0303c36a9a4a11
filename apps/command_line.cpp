#include "command_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/scene/suggestion.hpp"
#include "help_format.hpp"

namespace graze {
namespace {

std::string with_dashes(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::vector<std::string> with_dashes(std::vector<std::string> names) {
  for (std::string& name : names) name = with_dashes(name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The sentence behind the name of the option.
ValueCheck one_of(const std::vector<std::string>& choices) {
  return [choices](std::string& text) {
    return contains(choices, text)
               ? std::string()
               : fmt::format("'{}' is not allowed; give {}", text, joined(choices, "or"));
  };
}

void set_checks(CLI::Option& added, const OptionParts& said) {
  if (said.check) added.transform(CLI::Validator(said.check, ""));
  if (!said.choices.empty()) added.check(CLI::Validator(one_of(said.choices), ""));
}

}  // namespace

void CommandLine::command(const char* name, const char* what, const std::string& example) {
  app_ = program_.add_subcommand(name, what);
  app_->get_help_ptr()->group(kOutputGroup);
  app_->footer(footer(example));
  command_ = {name, what, example, {}, {}};
}

std::string CommandLine::written(const std::string& name, const OptionParts& said) {
  return (said.letter == 0 ? "" : std::string("-") + said.letter + ",") + "--" + with_dashes(name);
}

OptionDescription& CommandLine::add(const std::string& name, CLI::Option& added,
                                    const char* placeholder, const std::string& what,
                                    const OptionParts& said) {
  set_checks(added, said);
  added.group(heading_);
  added.required(said.is(kMandatory));
  if (*placeholder != 0) added.type_name(placeholder);
  if (said.is(kWithCommas)) added.delimiter(',')->allow_extra_args(false);
  if (said.is(kRepeated)) added.allow_extra_args(false)->take_all();
  if (said.given) added.each([given = said.given](const std::string&) { *given = true; });
  OptionDescription made;
  made.name = with_dashes(name);
  made.what = what;
  made.default_value = added.get_default_str();
  made.takes_several = added.get_expected_max() > 1;
  made.is_repeated = said.is(kRepeated);
  if (said.letter != 0) made.short_name = said.letter;
  made.placeholder = placeholder;
  made.choices = said.choices;
  made.needs = with_dashes(said.needs);
  made.excludes = with_dashes(said.excludes);
  made.heading = heading_;
  made.is_required = said.is(kMandatory);
  command_.options.push_back(std::move(made));
  return command_.options.back();
}

void CommandLine::add_text(const std::string& name, const TextReader& read, const char* placeholder,
                           const std::string& what, const OptionParts& said) {
  CLI::Option* added = app_->add_option_function<std::string>(written(name, said), read);
  added->default_str(said.default_word);
  add(name, *added, placeholder, what, said);
}

void CommandLine::add_file(const std::string& name, CLI::Option& added, const std::string& what,
                           const OptionParts& said) {
  add(name, added, "", what, said);
  command_.files.push_back(std::move(command_.options.back()));
  command_.files.back().name = name;
  command_.options.pop_back();
}

void CommandLine::conclude() {
  const auto option = [&](const std::string& name) { return app_->get_option("--" + name); };
  for (const OptionDescription& one : command_.options)
    for (const std::string& other : one.needs) option(one.name)->needs(option(other));
  // Two options exclude each other, whichever of them is described so.
  for (OptionDescription& one : command_.options) {
    for (const OptionDescription& other : command_.options)
      if (contains(other.excludes, one.name) && !contains(one.excludes, other.name))
        one.excludes.push_back(other.name);
    std::sort(one.excludes.begin(), one.excludes.end());
  }
  const auto tell = [](CLI::Option* of, OptionDescription& one) {
    one.help = help_line(one);
    of->description(one.help);
  };
  for (OptionDescription& one : command_.files) tell(app_->get_option(one.name), one);
  for (OptionDescription& one : command_.options) {
    for (const std::string& other : one.excludes) option(one.name)->excludes(option(other));
    tell(option(one.name), one);
  }
}

}  // namespace graze
