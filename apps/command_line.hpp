// Options as a command line has them.
#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "command_description.hpp"
#include "options/option.hpp"

namespace graze {

// A visitor of descriptions: adds what they say to the options of a command, which reads into the
// values that are described.
class CommandLine {
 public:
  explicit CommandLine(CLI::App& program) : program_(program) {}

  void command(const char* name, const char* what, const std::string& example);
  void heading(const char* heading) { heading_ = heading; }

  void option(const std::string& name, auto& value, const char* placeholder,
              const std::string& what, const auto&... parts) {
    const OptionParts said(parts...);
    CLI::Option& added = *app_->add_option(written(name, said), value);
    keep_default(added, value, said);
    add(name, added, placeholder, what, said).kind = kind_of(value);
  }
  // A word that the command takes beside its options, as "SCENE".
  void file(const std::string& name, auto& value, const std::string& what, const auto&... parts) {
    const OptionParts said(parts...);
    CLI::Option& added = *app_->add_option(name, value);
    keep_default(added, value, said);
    add_file(name, added, what, said);
  }
  // Sets a value to true, or calls a function.
  void flag(const std::string& name, bool& value, const std::string& what, const auto&... parts) {
    const OptionParts said(parts...);
    add_flag(name, *app_->add_flag(written(name, said), value), what, said);
  }
  void flag(const std::string& name, const std::function<void()>& set, const std::string& what,
            const auto&... parts) {
    const OptionParts said(parts...);
    add_flag(name, *app_->add_flag_callback(written(name, said), set), what, said);
  }
  // One of `things`, by its name.
  void choice(const std::string& name, auto& value, const auto& things, const char* placeholder,
              const std::string& what, const auto&... parts) {
    OptionParts said(parts...);
    said.choices = names_of(things);
    if constexpr (requires { name_of(value); }) said.default_word = name_of(value);
    const auto read = [&](const std::string& word) { set_by_name(value, things, word); };
    add_text(name, read, placeholder, what, said);
  }
  // What a function reads, which throws InputError.
  void text(const std::string& name, const TextReader& read, const char* placeholder,
            const std::string& what, const auto&... parts) {
    add_text(name, read, placeholder, what, OptionParts(parts...));
  }

  // Once all are described: which go together, and what help says of each.
  void conclude();
  CLI::App& app() { return *app_; }
  CommandDescription& description() { return command_; }

 private:
  template <class Value>
  static void keep_default(CLI::Option& added, const Value&, const OptionParts& said) {
    if (said.is(kMandatory) || said.is(kNoDefault)) return;
    if (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string>)
      added.capture_default_str();
  }
  static OptionKind kind_of(double) { return OptionKind::kNumber; }
  static OptionKind kind_of(std::integral auto) { return OptionKind::kWhole; }
  static OptionKind kind_of(const std::string&) { return OptionKind::kWord; }
  template <class Value>
  static OptionKind kind_of(const std::optional<Value>&) {
    return kind_of(Value());
  }
  template <class Value>
  static OptionKind kind_of(const std::vector<Value>&) {
    return kind_of(Value());
  }
  void add_flag(const std::string& name, CLI::Option& added, const std::string& what,
                const OptionParts& said) {
    add(name, added, "", what, said).kind = OptionKind::kFlag;
  }
  static std::string written(const std::string& name,
                             const OptionParts& said);  // "-s,--set"
  OptionDescription& add(const std::string& name, CLI::Option& added, const char* placeholder,
                         const std::string& what, const OptionParts& said);
  void add_text(const std::string& name, const TextReader& read, const char* placeholder,
                const std::string& what, const OptionParts& said);
  void add_file(const std::string& name, CLI::Option& added, const std::string& what,
                const OptionParts& said);

  CLI::App& program_;
  CLI::App* app_ = nullptr;  // of the command
  CommandDescription command_{};
  std::string heading_ = "Options";
};

}  // namespace graze
