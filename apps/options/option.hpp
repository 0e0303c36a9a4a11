// How options are described: beside the struct that holds them a function
//   void describe(auto& v, Group& o)
// says of each its name as results have it ("closure_speed", which is --closure-speed), its value,
// what stands for that in help ("V"; a flag has none), what it means, and parts, in any order, of
// what else there is to say. Visitors know no option: CommandLine reads them, OptionNotes
// records them in results.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/record/file/run_info.hpp"

namespace graze {

// Headings that options of several groups and commands stand below.
inline constexpr const char* kSceneGroup = "Scene";
inline constexpr const char* kNumericsGroup = "Numerics and limits";
inline constexpr const char* kLongWorkGroup = "Long work";
inline constexpr const char* kOutputGroup = "Output";
inline constexpr const char* kPicturesGroup = "Pictures";

// Why a value is refused, in a sentence; empty where it is allowed, and then perhaps written out.
using ValueCheck = std::function<std::string(std::string& text)>;
// Sets what a value says, or throws InputError.
using TextReader = std::function<void(const std::string&)>;

// Whether a result records the option among those that it depends on. An absent or empty value is
// never recorded.
struct Recorded {
  enum class In { kNothing, kPieces, kResult };
  In in = In::kNothing;
  std::optional<OptionValue> value{};  // where it is not recorded as given
  std::string name{};                  // where results have another one

  Recorded where(bool holds) const { return holds ? *this : Recorded{}; }
  Recorded as(OptionValue recorded) const { return {in, std::move(recorded), name}; }
  Recorded named(std::string other) const { return {in, value, std::move(other)}; }
};
// What each piece of long work depends on: a journal goes on only where it is the same.
inline const Recorded kOfPieces{Recorded::In::kPieces};
// What only the whole depends on.
inline const Recorded kOfResult{Recorded::In::kResult};

struct Letter {
  char letter;  // 's': -s too
};
// Names of other options.
struct Needs {
  std::vector<std::string> names;
};
struct Excludes {
  std::vector<std::string> names;
};
struct Choices {
  std::vector<std::string> words;
};
struct Default {
  std::string word;  // of an option that is read by a function
};
struct Given {
  bool& given;  // becomes true where the option is
};
enum class Trait {
  kMandatory,
  kWithCommas,  // takes several values
  kRepeated,    // may be given several times
  kNoDefault    // what the value is at first is none
};
inline constexpr Trait kMandatory = Trait::kMandatory, kWithCommas = Trait::kWithCommas,
                       kRepeated = Trait::kRepeated, kNoDefault = Trait::kNoDefault;

// The parts of one option.
class OptionParts {
 public:
  template <class... Parts>
  explicit OptionParts(const Parts&... parts) {
    (add(parts), ...);
  }

  bool is(Trait trait) const { return (traits_ & bit(trait)) != 0; }
  ValueCheck check{};
  Recorded recorded{};
  char letter = 0;  // 0: none
  std::vector<std::string> needs{}, excludes{}, choices{};
  std::string default_word{};
  bool* given = nullptr;

 private:
  static unsigned bit(Trait trait) { return 1U << static_cast<unsigned>(trait); }
  void add(const ValueCheck& part) { check = part; }
  void add(const Recorded& part) { recorded = part; }
  void add(const Letter& part) { letter = part.letter; }
  void add(const Needs& part) { needs = part.names; }
  void add(const Excludes& part) { excludes = part.names; }
  void add(const Choices& part) { choices = part.words; }
  void add(const Default& part) { default_word = part.word; }
  void add(const Given& part) { given = &part.given; }
  void add(Trait part) { traits_ |= bit(part); }

  unsigned traits_ = 0;
};

// The words of things that have a name_of.
template <class List>
std::vector<std::string> names_of(const List& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.emplace_back(name_of(thing));
  return names;
}
// Sets the one that the word names, if any does.
template <class Value, class List>
void set_by_name(Value& value, const List& things, const std::string& word) {
  for (const auto& thing : things)
    if (name_of(thing) == word) value = thing;
}

}  // namespace graze
