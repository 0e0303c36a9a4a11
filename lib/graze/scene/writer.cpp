#include <fmt/format.h>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/node.hpp"
#include "graze/scene/detail/schema.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

std::string list_text(const std::vector<double>& values) {
  std::string entries;
  for (const double value : values) entries += (entries.empty() ? "" : ", ") + real_text(value);
  return "[" + entries + "]";
}

std::string rows_text(const MatrixEntries& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) text += (text.empty() ? "" : ", ") + list_text(row);
  return "[" + text + "]";
}

// Appends the contents of a table to a text: lines "key = value" or, inline, one after the other.
class Writer : public SchemaVisitor {
 public:
  Writer(const Scene& scene, std::string& text, std::string path, Form form)
      : scene_(scene), text_(text), path_(std::move(path)), form_(form) {}

  template <class Number>
  void number(const Key& key, const Number& value) {
    if constexpr (std::is_same_v<Number, double>)
      add(key, real_text(value));
    else if (value)
      add(key, real_text(*value));
  }
  void number_or(const Key& key, double value, bool is_word, const char* word) {
    add(key, is_word ? quoted(word) : real_text(value));
  }
  void list(const Key& key, const std::vector<double>& values) {
    if (key.is_required || !values.empty()) add(key, list_text(values));
  }
  void values(const Key& key, const std::vector<double>& values) { list(key, values); }
  void entries(const Key& key, const std::string& file, const MatrixEntries& rows) {
    if (rows.empty()) {
      path(key, file);
      return;
    }
    // A parameter moves what is above the diagonal.
    MatrixEntries whole = rows;
    for (std::size_t i = 0; key.is_symmetric && i < rows.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) whole[i][j] = rows[j][i];
    add(key, rows_text(whole));
  }
  void series(const Key& key, const std::vector<double>& values) {
    add(key, values.size() == 1 ? real_text(values.front()) : list_text(values));
  }
  void taper(const Key& key, const Taper& values) {
    if (!values.empty()) series(key, values);
  }
  void ends(const Key& key, const auto& held, const auto& choices, const auto& usual) {
    if (held != usual)
      add(key, fmt::format("[{}, {}]", quoted(name_among(choices, held[0])),
                           quoted(name_among(choices, held[1]))));
  }
  void bodies(const Key& key, const SpringGeometry& geometry, BodyNumbers which) {
    add(key, list_text(body_numbers(geometry, which)));
  }
  // What is not allowed stands for none.
  void count(const Key& key, int value) {
    if (key.is_required || key.range.holds(value)) add(key, std::to_string(value));
  }
  void flag(const Key& key, bool value) { add(key, value ? "true" : "false"); }
  void text(const Key& key, const std::string& value) {
    if (!value.empty()) add(key, quoted(value));
  }
  void path(const Key& key, const std::string& value) { text(key, value); }
  void label(const Key& key, const std::string& value) { text(key, value); }
  void labels(const Key& key, const std::vector<std::string>& values) {
    if (values.empty()) return;
    std::string entries;
    for (const std::string& value : values)
      entries += (entries.empty() ? "" : ", ") + quoted(value);
    add(key, "[" + entries + "]");
  }
  template <class Value>
  void choice(const Key& key, Value value, const auto& choices) {
    // What is asked for beyond the usual stands there only where it is.
    constexpr bool is_beyond = std::is_same_v<Value, bool> || std::is_same_v<Value, Units>;
    if (is_beyond && value == choices.front().value) return;
    add(key, quoted(name_among(choices, value)));
  }
  void table(const TableKey& key, const auto& value) {
    if (!value) return;
    const std::string path = joined_path(path_, key.name);
    if (key.form == Form::kHeader) {
      write("[" + path + "]", path, *value);
      return;
    }
    std::string text;
    Writer inner(scene_, text, path, Form::kInline);
    describe(inner, *value, scene_);
    add(Key{key.name}, "{ " + text + " }");
  }
  void tables(const TableKey& key, const auto& values) {
    const std::string path = joined_path(path_, key.name);
    for (const auto& value : values) write(fmt::format("[[{}]]", path), path, value);
  }
  void leading(const TableKey& key, const auto& first, const auto& others) {
    if (others.empty() || !first) return table(key, first);
    const std::string path = joined_path(path_, key.name);
    write(fmt::format("[[{}]]", path), path, *first);
    tables(key, others);
  }

 private:
  void add(const Key& key, const std::string& value) {
    if (!key.applies) return;
    if (form_ == Form::kInline && !text_.empty()) text_ += ", ";
    text_ += fmt::format("{} = {}{}", key.name, value, form_ == Form::kInline ? "" : "\n");
  }
  void write(const std::string& header, const std::string& path, const auto& value) {
    text_ += fmt::format("{}{}\n", text_.empty() ? "" : "\n", header);
    Writer inner(scene_, text_, path, Form::kHeader);
    describe(inner, value, scene_);
  }

  const Scene& scene_;
  std::string& text_;
  std::string path_;
  Form form_;
};

}  // namespace

// The numerics are no part of the structure, but another default would change results: they are
// written as well.
std::string write_scene(const Scene& scene) {
  std::string text;
  Writer writer(scene, text, "", Form::kHeader);
  describe(writer, scene);
  return text;
}

}  // namespace graze
