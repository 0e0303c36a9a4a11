#include "graze/scene/detail/document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

#include "graze/scene/detail/text_check.hpp"

namespace graze {
namespace {

using File = std::shared_ptr<const std::string>;

Place place_of(const File& file, const toml::source_position& position) {
  return {file, static_cast<int>(position.line), static_cast<int>(position.column)};
}

bool stands_before(const toml::source_position& a, const toml::source_position& b) {
  return std::tie(a.line, a.column) < std::tie(b.line, b.column);
}

Node converted(const toml::node& source, const File& file);

NodeTable converted_table(const toml::table& source, const File& file) {
  NodeTable table;
  table.reserve(source.size());
  for (const auto& [key, child] : source) {
    Node node = converted(child, file);
    // A value is reported at its key, a table with a header at its bracket, which comes first.
    if (stands_before(key.source().begin, child.source().begin)) {
      node.place = place_of(file, key.source().begin);
    }
    table.push_back({std::string(key.str()), std::move(node)});
  }
  // toml++ sorts by name; messages name the first mistake in the text.
  std::stable_sort(table.begin(), table.end(), [](const Member& a, const Member& b) {
    return std::tie(a.node.place.line, a.node.place.column) <
           std::tie(b.node.place.line, b.node.place.column);
  });
  return table;
}

Node converted(const toml::node& source, const File& file) {
  Node node;
  node.place = place_of(file, source.source().begin);
  if (const auto* table = source.as_table()) {
    node.value = converted_table(*table, file);
  } else if (const auto* list = source.as_array()) {
    NodeList entries;
    entries.reserve(list->size());
    for (const toml::node& entry : *list) {
      entries.push_back(converted(entry, file));
    }
    node.value = std::move(entries);
  } else if (const auto* text = source.as_string()) {
    node.value = text->get();
  } else if (const auto* integer = source.as_integer()) {
    node.value = integer->get();
  } else if (const auto* real = source.as_floating_point()) {
    node.value = real->get();
  } else if (const auto* flag = source.as_boolean()) {
    node.value = flag->get();
  } else {
    node.value = UnusedValue{source.is_time() ? "a time" : "a date"};
  }
  return node;
}

std::string replaced(std::string text, std::string_view old, std::string_view by) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at)) {
    text.replace(at, old.size(), by);
    at += by.size();
  }
  return text;
}

// toml++ says "Error while parsing <what>: <reason>"; the sentences that users meet most are put
// into plain words.
std::string syntax_sentence(std::string_view description) {
  constexpr std::string_view kOpening = "Error while parsing ";
  std::string_view what = "text";
  std::string_view reason = description;
  if (description.substr(0, kOpening.size()) == kOpening) {
    const std::size_t colon = description.find(": ");
    if (colon != std::string_view::npos) {
      what = description.substr(kOpening.size(), colon - kOpening.size());
      reason = description.substr(colon + 2);
    }
  }
  if (reason == "encountered end-of-file") {
    const bool vowel = std::string_view("aeiou").find(what.front()) != std::string_view::npos;
    return fmt::format("the text ends inside {} {}, it must be complete", vowel ? "an" : "a", what);
  }
  if (reason == "could not determine value type") {
    return "this is not a TOML value, strings need quotes";
  }
  if (reason == "expected a comment or whitespace, saw ','") {
    return "a comma follows the value, decimals need a point and lists need brackets";
  }
  constexpr std::string_view kTwice = "cannot redefine existing ";
  if (reason.substr(0, kTwice.size()) == kTwice) {
    return fmt::format("the {} is there already, each key and table may be written once",
                       reason.substr(kTwice.size()));
  }
  std::string sentence = fmt::format("this {} is not valid TOML, {}", what, reason);
  sentence = replaced(std::move(sentence), "expected value", "expected a value");
  return replaced(std::move(sentence), "'\\n'", "the end of the line");
}

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

}  // namespace

Node read_document(const std::string& text, const std::string& name) {
  check_text(text, name);
  const auto file = std::make_shared<const std::string>(name);
  try {
    const toml::table root = toml::parse(std::string_view(text));
    Node node;
    node.value = converted_table(root, file);
    node.place = {file, 1, 1};
    return node;
  } catch (const toml::parse_error& error) {
    throw InputError(
        place_of(file, error.source().begin).location(), "toml",
        on_one_line(replaced(syntax_sentence(error.description()), "floating-point", "number")));
  }
}

}  // namespace graze
