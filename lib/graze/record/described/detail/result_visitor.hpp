// The contents of results, described once: describe() passes every number of a result with its
// name, its unit and its meaning to a visitor. Documents, tables, arrays and the reference in
// docs/results.md come from visitors that do not depend on any result.
#pragma once

#include <complex>
#include <concepts>
#include <cstddef>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace graze {

// A number, a word, a list or a part of a result.
struct Field {
  std::string_view name{};
  std::string_view unit{};    // SI; empty of a pure number, a word or a part
  std::string_view what{};    // it means, for the reference
  std::string_view column{};  // its name in tables, if different; for a pair both, "from,to"
  std::string_view tables{};  // tables whose rows repeat it, besides its own row: "orbits"
  enum class Use {
    kEverywhere,
    kDocument,  // and in no table
    kTables,    // and in no document
    kUnit       // only the unit in a document
  } use = Use::kEverywhere;

  constexpr Field as(std::string_view other) const { return with(&Field::column, other); }
  constexpr Field in(std::string_view names) const { return with(&Field::tables, names); }
  constexpr Field document() const { return with(&Field::use, Use::kDocument); }
  constexpr Field tabular() const { return with(&Field::use, Use::kTables); }

 private:
  template <class Part>
  constexpr Field with(Part Field::*part, Part value) const {
    Field changed = *this;
    changed.*part = value;
    return changed;
  }
};

// The type of a value that does not exist.
enum class Missing { kNumber, kWord, kTruth };
// Two numbers that belong together: a complex number, an interval.
using NumberPair = std::pair<double, double>;
// Numbers that are not finite do not exist. A word refers to the text.
using FieldValue = std::variant<Missing, bool, long long, double, std::string_view, NumberPair>;

template <class T>
FieldValue field_value(const T& value) {
  if constexpr (std::same_as<T, bool>)
    return value;
  else if constexpr (std::integral<T>)
    return static_cast<long long>(value);
  else if constexpr (std::floating_point<T>)
    return value;
  else if constexpr (std::same_as<T, std::complex<double>>)
    return NumberPair(value.real(), value.imag());
  else if constexpr (std::same_as<T, NumberPair>)
    return value;
  else
    return std::string_view(value);
}
template <class T>
FieldValue field_value(const std::optional<T>& value) {
  if (value) return field_value(*value);
  if constexpr (std::same_as<T, bool>)
    return Missing::kTruth;
  else if constexpr (std::constructible_from<std::string_view, T>)
    return Missing::kWord;
  else
    return Missing::kNumber;
}
// A name; one that is empty does not exist.
inline std::optional<std::string_view> named(std::string_view name) {
  return name.empty() ? std::nullopt : std::optional(name);
}
// The value of an optional, or a default-constructed one, for descriptions of absent parts.
template <class T>
const T& held(const std::optional<T>& value) {
  static const T none{};
  return value ? *value : none;
}

class ResultVisitor {
 public:
  virtual ~ResultVisitor() = default;

  template <class T>
  void field(const Field& field, const T& value) {
    take(field, field_value(value));
  }
  // The unit of numbers that have this name elsewhere, in tables or on axes.
  void unit(std::string_view name, std::string_view unit) {
    Field field{name, unit};
    field.use = Field::Use::kUnit;
    take(field, Missing::kNumber);
  }
  // A part with fields of its own, which `body` passes.
  template <class Body>
  void part(const Field& field, const Body& body) {
    if (!open(field, Shape::kPart)) return;
    body();
    close();
  }
  // The same, or null.
  template <class Body>
  void maybe_part(const Field& field, bool exists, const Body& body) {
    if (exists || sees_all())
      part(field, body);
    else
      take(field, Missing::kWord);
  }
  // A list of parts: `each(element, index)` passes the fields of one.
  template <class List, class Each>
  void list(const Field& field, const List& list, const Each& each) {
    if (open(field, Shape::kList)) parts(list, each);
  }
  // The same for very many parts, which a document holds as one list for each field.
  template <class List, class Each>
  void columns(const Field& field, const List& list, const Each& each) {
    if (!open(field, Shape::kColumns)) return;
    // Empty lists are described, too.
    if (list.empty() && !sees_all()) {
      static const std::ranges::range_value_t<List> any{};
      hear_names_only(true);
      part_of(any, 0, each);
      hear_names_only(false);
    }
    parts(list, each);
  }
  // The same for a few parts, the same number in every row of a table, which has columns for the
  // fields of each. If they do not all exist a document has an empty list.
  template <class List, class Each>
  void spread(const Field& field, const List& list, bool exist, const Each& each) {
    if (!open(field, Shape::kSpread)) return;
    if (exist || sees_all())
      for (std::size_t i = 0; i < list.size(); ++i) part_of(list[i], i, each);
    close();
  }
  // A list of values.
  template <class List, class Value>
  void values(const Field& field, const List& list, const Value& value) {
    if (!open(field, Shape::kValues)) return;
    for (const auto& element : list) take({}, field_value(value(element)));
    close();
  }
  template <class List>
  void values(const Field& field, const List& list) {
    values(
        field, list, [](const auto& value) -> const auto& { return value; });
  }

  // `count` lists of values.
  template <class Row>
  void lists(const Field& field, std::size_t count, const Row& row) {
    if (!open(field, Shape::kList)) return;
    for (std::size_t i = 0; i < count; ++i) values({}, row(i));
    close();
  }

  // A row of the table: the fields that `body` passes are in its columns.
  template <class Body>
  void row(std::string_view table, const Body& body) {
    if (!begin_row(table)) return;
    body();
    end_row(table);
  }
  // Whether the visitor needs rows that are computed for a table alone.
  virtual bool wants_rows(std::string_view) const { return false; }
  // Whether the visitor sees one representative element of each list, and all optional parts.
  virtual bool sees_all() const { return false; }
  // Fields for documents alone, or for tables alone.
  template <class Body>
  void only(Field::Use use, const Body& body) {
    if (wants(use)) body();
  }
  // A prefix of the column names of the fields that `body` passes.
  template <class Body>
  void prefix(std::string_view words, const Body& body) {
    const std::string before = set_prefix(words);
    body();
    set_prefix(before);
  }

  // During its lifetime, fields belong to some elements only, which `who` describes in the
  // reference. False where the present element is none of them.
  class Some {
   public:
    Some(ResultVisitor& visitor, bool exist, std::string_view who)
        : visitor_(visitor), exist_(exist || visitor.sees_all()) {
      visitor_.begin_some(who);
    }
    Some(const Some&) = delete;
    Some& operator=(const Some&) = delete;
    ~Some() { visitor_.end_some(); }
    explicit operator bool() const { return exist_; }

   private:
    ResultVisitor& visitor_;
    bool exist_;
  };
  [[nodiscard]] Some where(bool exist, std::string_view who) { return Some(*this, exist, who); }

 protected:
  enum class Shape { kPart, kValues, kList, kColumns, kSpread, kElement };
  // Whether the contents are wanted; close() follows then.
  virtual bool open(const Field& field, Shape shape) = 0;
  virtual void close() = 0;
  virtual bool wants(Field::Use) const { return true; }
  virtual void take(const Field& field, const FieldValue& value) = 0;
  virtual bool begin_row(std::string_view) { return true; }
  virtual void end_row(std::string_view) {}
  // Returns the previous prefix.
  virtual std::string set_prefix(std::string_view) { return {}; }
  // Whether the next elements only give the names of their fields.
  virtual void hear_names_only(bool) {}
  virtual void begin_some(std::string_view) {}
  virtual void end_some() {}

 private:
  template <class Element, class Each>
  void part_of(const Element& element, std::size_t i, const Each& each) {
    if (!open({}, Shape::kElement)) return;
    each(element, i);
    close();
  }
  template <class List, class Each>
  void parts(const List& list, const Each& each) {
    if (sees_all()) {
      static const std::ranges::range_value_t<List> any{};
      part_of(any, 0, each);
    } else {
      std::size_t i = 0;
      for (const auto& element : list) part_of(element, i++, each);
    }
    close();
  }
};

}  // namespace graze
