// What the schema says about one key of a scene.
#pragma once

#include <limits>
#include <type_traits>

namespace graze {

// Which numbers are allowed. Infinite ones never are, unless a rule of its own says so.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool has_low = false, has_high = false;  // whether the ends belong to it
  const char* words = "";                  // "greater than 0", behind "a number"
  const char* in_table = "any";            // "> 0", in the reference
  bool is_checked = true;                  // false: a rule of its own (check.cpp) decides

  constexpr bool holds(double value) const {
    return (has_low ? value >= low : value > low) && (has_high ? value <= high : value < high);
  }
  constexpr bool is_bounded() const { return high < std::numeric_limits<double>::infinity(); }
  // The same range, described by another text in the reference.
  constexpr Range told(const char* text) const {
    Range range = *this;
    range.in_table = text;
    return range;
  }
};

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();
inline constexpr Range kAny{};
inline constexpr Range kPositive{0.0, kUnbounded, false, false, "greater than 0", "> 0"};
inline constexpr Range kNotNegative{0.0, kUnbounded, true, false, "of at least 0", ">= 0"};
inline constexpr Range kAtLeastOne{1.0, kUnbounded, true, false, "of at least 1", "at least 1"};
inline constexpr Range kUpToOne{0.0, 1.0, false, true, "greater than 0 and at most 1", "in (0, 1]"};
inline constexpr Range kFraction{0.0, 1.0, true, true, "from 0 to 1", "0 to 1"};
inline constexpr Range kWithinOne{
    0.0, 1.0, false, false, "between 0 and 1, both excluded", "between 0 and 1"};
inline constexpr Range kPoissonRatio{
    -1.0, 0.5, false, true, "greater than -1 and at most 0.5", "in (-1, 0.5]"};

inline constexpr Range kDirection{0.0, 3.0, true, true, "from 0 to 3", "1, 2, 3; 0"};
inline constexpr Range kSeed{
    0.0, 2147483647.0, true, true, "from 0 to 2147483647", "integer >= 0"};
inline constexpr Range kModeCount{1.0, 2000.0, true, true, "from 1 to 2000", "integer, 1 to 2000"};

// The range of a key that check.cpp has a rule for.
constexpr Range own_rule(const char* in_table) {
  Range range;
  range.in_table = in_table;
  range.is_checked = false;
  return range;
}

struct Key {
  const char* name;
  const char* unit = "";  // as the reference has it; "" of a pure number
  Range range{};
  const char* meaning = "";
  const char* fallback = "required";  // what holds where it is not given; null: the member's value
  const char* what = nullptr;         // what it must be, where unit and range do not say all
  const char* refusal = nullptr;      // the sentence where it is given and does not apply
  bool is_required = true;
  bool is_filled = false;    // a list: with zeros, where the scene does not give it
  bool applies = true;       // beside the other keys that this scene has
  bool is_parameter = true;  // of a number: may be varied
  bool may_stand = false;    // in a scene made in code, where it does not apply
  bool is_symmetric = true;  // a matrix
  bool is_kept = false;      // a choice: what stands there, where the scene does not give it

  constexpr Key or_else(const char* text = nullptr) const {
    Key key = *this;
    key.fallback = text;
    key.is_required = false;
    return key;
  }
  constexpr Key needed(const char* text) const {
    Key key = *this;
    key.fallback = text;
    return key;
  }
  constexpr Key or_zeros() const {
    Key key = *this;
    key.fallback = "zeros";
    key.is_filled = true;
    return key;
  }
  constexpr Key where(bool condition, const char* sentence = nullptr) const {
    Key key = *this;
    key.applies = condition;
    key.refusal = sentence;
    return key;
  }
  constexpr Key of_any_matrix() const {
    Key key = *this;
    key.is_symmetric = false;
    return key;
  }
  constexpr Key or_kept() const {
    Key key = *this;
    key.is_kept = true;
    return key;
  }
  constexpr Key or_ignored() const {
    Key key = *this;
    key.may_stand = true;
    return key;
  }
  constexpr Key as(const char* text) const {
    Key key = *this;
    key.what = text;
    return key;
  }
  constexpr Key fixed() const {
    Key key = *this;
    key.is_parameter = false;
    return key;
  }
};

// Numbers of the two bodies at a contact.
enum class BodyNumbers { kRadii, kModuli, kPoissonRatios };

enum class Form { kHeader, kInline };

// A table within a table. Its numbers are parameters unless the motion does not depend on them.
struct TableKey {
  const char* name;
  Form form = Form::kHeader;
  bool is_varied = true;
};

// An optional part of a scene, for keys that are described in either case: where it is absent, a
// default-constructed stand-in takes its place.
template <class Value>
class MayHold {
 public:
  explicit MayHold(Value* held) : held_(held) {}
  explicit operator bool() const { return held_ != nullptr; }
  Value& operator*() { return held_ != nullptr ? *held_ : spare_; }
  Value* operator->() { return &**this; }

 private:
  Value* held_;
  std::remove_const_t<Value> spare_{};
};

// A table of type Value, const or not.
template <class Table, class Value>
concept Of = std::is_same_v<std::remove_const_t<Table>, Value>;

// A visitor that ignores every key; visitors override what they need.
struct SchemaVisitor {
  void number(const Key&, const auto&) const {}
  // A number, or the one word that stands for what makes it; third: whether the word stands.
  void number_or(const Key&, const auto&, const auto&, const char*) const {}
  void list(const Key&, const auto&) const {}    // of numbers, one per mode but in a torque's table
  void values(const Key&, const auto&) const {}  // the same, as many as there are
  // A matrix in the scene, or the name of the file that holds it.
  void entries(const Key&, const auto&, const auto&) const {}
  void series(const Key&, const auto&) const {}  // a list of numbers, or one where it has one entry
  void taper(const Key&, const auto&) const {}   // one length of a section, or two
  // The two ends of a span, words of choices; last: what they are where none are given.
  void ends(const Key&, const auto&, const auto&, const auto&) const {}
  void bodies(const Key&, const auto&, BodyNumbers) const {}
  void count(const Key&, const auto&) const {}
  void flag(const Key&, const auto&) const {}
  void text(const Key&, const auto&) const {}
  void path(const Key&, const auto&) const {}    // of a file, from the folder of the scene
  void label(const Key&, const auto&) const {}   // of a degree of freedom
  void labels(const Key&, const auto&) const {}  // a list of these
  void choice(const Key&, const auto&, const auto&) const {}
  void file(const Key&, const auto&) const {}  // that holds what other keys would
  // An optional or a pointer; a list of tables.
  void table(const TableKey&, const auto&) const {}
  void tables(const TableKey&, const auto&) const {}
  // A table that may be the first of a list.
  void leading(const TableKey&, const auto&, const auto&) const {}
};

}  // namespace graze
