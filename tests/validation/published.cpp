#include "validation/published.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/program.hpp"
#include "graze/scene/detail/document.hpp"

namespace graze::support {
namespace {

// A number that is computed apart, to at least as many digits, is met to this, relative to it: what
// the shooting equations of an orbit are solved to, and a hundred times what times of impact are.
constexpr double kIndependent = 1e-10;
// A double that was printed with all its digits is met to this, relative to it: a few hundred
// roundings of a computation that is not Graze's.
constexpr double kAllDigits = 1e-13;

[[noreturn]] void refuse(const Node& node, const std::string& sentence) {
  throw InputError(node.place.location(), "published", sentence);
}

const NodeTable& table_of(const Node& node) {
  if (const NodeTable* table = node.as<NodeTable>()) return *table;
  refuse(node, "must be a table");
}

std::string text_of(const Node& table, const std::string& key) {
  const Node* node = find_member(table_of(table), key);
  if (!node) refuse(table, "needs the key " + key);
  const std::string* text = node->as<std::string>();
  if (!text || text->find('|') != std::string::npos)
    refuse(*node, key + " must be a string, without |, which divides the columns of the page");
  return *text;
}

std::string text_or(const Node& table, const std::string& key, std::string otherwise) {
  return find_member(table_of(table), key) ? text_of(table, key) : std::move(otherwise);
}

void allow_only(const Node& table, const std::vector<std::string>& keys) {
  for (const Member& member : table_of(table))
    if (std::find(keys.begin(), keys.end(), member.key) == keys.end())
      refuse(member.node, "has the key " + member.key + ", which means nothing here");
}

std::string number_of(const Node& table, const std::string& key) {
  const std::string text = text_of(table, key);
  std::size_t read = 0;
  try {
    std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  if (read == 0 || read != text.size())
    refuse(*find_member(table_of(table), key), key + " must be a number in quotes");
  return text;
}

PublishedValue value_of(const Node& node) {
  allow_only(node, {"what", "at", "published", "formula", "within", "absolute", "independent",
                    "script", "printed_as", "because"});
  PublishedValue value{text_of(node, "what"), text_of(node, "at")};
  if (find_member(table_of(node), "published"))
    value.published = number_of(node, "published");
  else if (!find_member(table_of(node), "independent"))
    refuse(node, "needs a number: published, independent or both");
  value.formula = text_or(node, "formula", "");
  value.because = text_or(node, "because", "");
  if (const Node* within = find_member(table_of(node), "within")) {
    if (!within->as<double>()) refuse(*within, "within must be a real number");
    value.within = *within->as<double>();
    if (value.because.empty()) refuse(*within, "a tolerance of its own needs a reason (because)");
  }
  if (const Node* absolute = find_member(table_of(node), "absolute")) {
    if (!absolute->as<bool>() || !value.within)
      refuse(*absolute, "absolute is true or false, of the tolerance within");
    value.absolute = *absolute->as<bool>();
  }
  if (find_member(table_of(node), "independent")) {
    value.independent = number_of(node, "independent");
    value.script = text_of(node, "script");
    value.printed_as = text_or(node, "printed_as", "");
  }
  return value;
}

PublishedCase case_of(const Node& node) {
  allow_only(node, {"name", "title", "source", "scene", "command", "value"});
  PublishedCase one{text_of(node, "name"),    text_of(node, "title"),
                    text_of(node, "source"),  "",
                    text_of(node, "command"), {}};
  one.scene = text_or(node, "scene", one.name + ".toml");
  const Node* values = find_member(table_of(node), "value");
  if (!values || !values->as<NodeList>()) refuse(node, "needs a list of values");
  for (const Node& value : *values->as<NodeList>()) one.values.push_back(value_of(value));
  return one;
}

}  // namespace

double PublishedValue::allowed() const {
  if (within) return absolute ? *within : *within * std::abs(expected());
  if (independent) return kIndependent * std::abs(expected());
  return std::max(last_digit(*published), kAllDigits * std::abs(expected()));
}

const PublishedSource& PublishedTable::source_of(const PublishedCase& one) const {
  return *std::find_if(sources.begin(), sources.end(),
                       [&](const PublishedSource& source) { return source.key == one.source; });
}

PublishedTable published_table(const std::filesystem::path& file) {
  const Node root = read_document(read_text(file), file.string());
  allow_only(root, {"source", "case"});
  PublishedTable table;
  if (const Node* sources = find_member(table_of(root), "source"))
    for (const Member& source : table_of(*sources)) {
      allow_only(source.node, {"title", "link"});
      table.sources.push_back(
          {source.key, text_of(source.node, "title"), text_or(source.node, "link", "")});
    }
  const Node* cases = find_member(table_of(root), "case");
  if (!cases || !cases->as<NodeList>()) refuse(root, "needs cases");
  for (const Node& node : *cases->as<NodeList>()) {
    table.cases.push_back(case_of(node));
    const auto is_its = [&](const PublishedSource& source) {
      return source.key == table.cases.back().source;
    };
    // Names are those of tests, titles the headings of the page.
    const PublishedCase& last = table.cases.back();
    for (const PublishedCase& before : table.cases)
      if (&before != &last && (before.name == last.name || before.title == last.title))
        refuse(node, "has the name or the title of another case");
    if (std::none_of(table.sources.begin(), table.sources.end(), is_its))
      refuse(node, "names a source that the table has not");
  }
  return table;
}

double last_digit(const std::string& number) {
  const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = std::min(number.find('.'), exponent);
  const auto decimals = point < exponent ? static_cast<int>(exponent - point) - 1 : 0;
  const int power = exponent < number.size() ? std::stoi(number.substr(exponent + 1)) : 0;
  return std::pow(10.0, power - decimals);
}

}  // namespace graze::support
