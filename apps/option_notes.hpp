// The options that a result depends on, as the result records them.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "graze/record/file/run_info.hpp"
#include "options/option.hpp"

namespace graze {

// A visitor of descriptions: adds the values that are to be recorded in `in` to the options of a
// result.
class OptionNotes {
 public:
  OptionNotes(RunInfo& info, Recorded::In in) : info_(info), in_(in) {}

  void command(const char*, const char*, const std::string&) {}
  void heading(const char*) {}

  void option(const std::string& name, const auto& value, const char*, const std::string&,
              const auto&... parts) {
    const OptionParts said(parts...);
    note(name, said.recorded, as_recorded(value, said.is(kRepeated) ? " " : ","));
  }
  void file(const std::string& name, const auto& value, const std::string&, const auto&... parts) {
    note(name, OptionParts(parts...).recorded, as_recorded(value, " "));
  }
  template <class Set>
  void flag(const std::string& name, const Set& set, const std::string&, const auto&... parts) {
    if constexpr (std::same_as<Set, bool>) note(name, OptionParts(parts...).recorded, set);
  }
  void choice(const std::string& name, const auto& value, const auto&, const char*,
              const std::string&, const auto&... parts) {
    note(name, OptionParts(parts...).recorded, word_of(value));
  }
  // What a function reads is recorded in the words of its description.
  void text(const std::string& name, const auto&, const char*, const std::string&,
            const auto&... parts) {
    note(name, OptionParts(parts...).recorded, {});
  }

 private:
  static std::optional<OptionValue> word_of(const auto& thing) {
    return std::string(name_of(thing));
  }
  template <class Thing>
  static std::optional<OptionValue> word_of(const std::optional<Thing>& thing) {
    return thing ? word_of(*thing) : std::nullopt;
  }
  static std::optional<OptionValue> as_recorded(const std::string& word, const char*) {
    return word.empty() ? std::nullopt : std::optional<OptionValue>(word);
  }
  static std::optional<OptionValue> as_recorded(double number, const char*) { return number; }
  static std::optional<OptionValue> as_recorded(std::integral auto number, const char*) {
    return static_cast<long long>(number);
  }
  template <class Value>
  static std::optional<OptionValue> as_recorded(const std::optional<Value>& value,
                                                const char* between) {
    return value ? as_recorded(*value, between) : std::nullopt;
  }
  template <class Value>
  static std::optional<OptionValue> as_recorded(const std::vector<Value>& list,
                                                const char* between) {
    return as_recorded(fmt::format("{}", fmt::join(list, between)), between);
  }

  void note(const std::string& name, const Recorded& how, const std::optional<OptionValue>& value) {
    const std::optional<OptionValue>& noted = how.value ? how.value : value;
    if (how.in == in_ && noted)
      info_.options.emplace_back(how.name.empty() ? name : how.name, *noted);
  }

  RunInfo& info_;
  Recorded::In in_;
};

// Those of a command whose defaults are filled in: of its pieces, of the whole, or of both.
template <class Command>
void note_options(Command command, Recorded::In in, RunInfo& info) {
  OptionNotes notes(info, in);
  describe(notes, command);
}
template <class Command>
void note_options(const Command& command, RunInfo& info) {
  note_options(command, Recorded::In::kPieces, info);
  note_options(command, Recorded::In::kResult, info);
}

}  // namespace graze
