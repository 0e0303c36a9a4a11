#include "graze/scene/detail/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "graze/scene/detail/document.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/text_check.hpp"

namespace graze {
namespace {

// stop.2.spring.damping.coefficient is the deepest name.
constexpr std::size_t kMostParts = 5;

// A number or a sign begins no word: such a value is a slip.
bool is_word(std::string_view text) {
  return is_bare_key(text) && !(text[0] >= '0' && text[0] <= '9') && text[0] != '-';
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
}

// The setting as the "file" of its messages, on one line whatever it holds.
std::string shown(const std::string& setting) {
  std::string text = "--set " + setting;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
  return text;
}

// NAME=VALUE taken apart.
struct Setting {
  std::string file;  // for messages
  std::string name;
  std::vector<std::string> parts;  // of the name
  std::string value;

  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(SourceLocation{file}, name.empty() ? "set" : name, sentence);
  }
};

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Setting taken_apart(const std::string& text) {
  Setting setting;
  setting.file = shown(text);
  const std::size_t equals = text.find('=');
  const std::string name(trimmed(std::string_view(text).substr(0, equals)));
  setting.parts = parts_of(name);
  const bool well_formed = std::all_of(setting.parts.begin(), setting.parts.end(), is_bare_key);
  if (equals == std::string::npos || !well_formed) {
    setting.fail("the setting is malformed, it must read NAME=VALUE like stop.gap=1e-3");
  }
  setting.name = name;
  if (setting.parts.size() > kMostParts) {
    setting.fail("there is no such key, at most five names can be joined by dots");
  }
  const std::string_view value = trimmed(std::string_view(text).substr(equals + 1));
  if (value.empty()) {
    setting.fail("the value is missing, the setting must read NAME=VALUE");
  }
  setting.value = value;
  return setting;
}

constexpr std::string_view kAllowedValues =
    "a number without a unit, a list in [ ], a string in quotes or one bare word";

// A setting is short and is shown as a whole: its lines and columns would not help.
void place_in_setting(Node& node, const Place& place) {
  node.place = place;
  if (auto* list = node.as<NodeList>()) {
    for (Node& entry : *list) {
      place_in_setting(entry, place);
    }
  } else if (auto* table = node.as<NodeTable>()) {
    for (Member& member : *table) {
      place_in_setting(member.node, place);
    }
  }
}

Node value_of(const Setting& setting) {
  const bool one_line = setting.value.find_first_of("\n\r") == std::string::npos;
  if (setting.value.size() > kLargestText) {
    setting.fail("the value is larger than 16 MiB, it must be smaller");
  }
  const Place place{std::make_shared<const std::string>(setting.file)};
  try {
    Node root = read_document("v=" + setting.value, setting.file);
    NodeTable& table = *root.as<NodeTable>();
    if (one_line && table.size() == 1) {
      Node node = std::move(table.front().node);
      place_in_setting(node, place);
      return node;
    }
  } catch (const InputError&) {
    if (is_word(setting.value)) {
      return Node{setting.value, place};
    }
  }
  setting.fail(fmt::format("the value is not TOML, it must be {}", kAllowedValues));
}

// The number that `part` writes, or 0 when it is none.
std::size_t index_of(const std::string& part) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
  return error == std::errc() && end == part.data() + part.size() ? index : 0;
}

// Entry number `part` of the list that `path` names.
Node& entry_of(NodeList& list, const std::string& part, const std::string& path,
               const Setting& setting) {
  const std::size_t index = index_of(part);
  if (index == 0 || index > list.size()) {
    const std::size_t most = is_list_of_tables(path) ? list.size() + 1 : list.size();
    const std::string allowed = most == 1 ? "1" : fmt::format("from 1 to {}", most);
    setting.fail(most == 0 ? fmt::format("{} is an empty list, it has no entry to change", path)
                           : fmt::format("there is no entry {} in {}, the number must be {}", part,
                                         path, allowed));
  }
  return list[index - 1];
}

// Where a number can be written in two ways, the setting's replaces the scene's.
void remove_other_way(NodeTable& table, const std::string& path, const std::string& key) {
  if (path != "forcing" || (key != "frequency" && key != "frequency_hz")) return;
  const std::string other = key == "frequency" ? "frequency_hz" : "frequency";
  std::erase_if(table, [&](const Member& member) { return member.key == other; });
}

// A number makes the one table that is there the first of a list.
void make_list(NodeTable& table, const std::string& key, std::size_t number) {
  Node* one = find_member(table, key);
  if (number == 0 || one == nullptr || one->as<NodeTable>() == nullptr) return;
  const Place place = one->place;
  *one = Node{NodeList{std::move(*one)}, place};
}

// The member, made as `made` where it is missing.
Node& member_of(NodeTable& table, const std::string& key, Node made) {
  if (Node* member = find_member(table, key)) {
    return *member;
  }
  table.push_back({key, std::move(made)});
  return table.back().node;
}

void set_value(Node& root, const Setting& setting, Node value) {
  const Place place = value.place;
  const std::vector<std::string>& parts = setting.parts;

  Node* at = &root;
  std::string path;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (auto* table = at->as<NodeTable>()) {
      const bool last = k + 1 == parts.size();
      // A name without a number means the first of the tables, and the one after the last is made.
      const std::string here = joined_path(path, parts[k]);
      if (!last && may_be_list_of_tables(here)) make_list(*table, parts[k], index_of(parts[k + 1]));
      const Node* present = find_member(*table, parts[k]);
      const bool tables = !last && (is_list_of_tables(here) ||
                                    (may_be_list_of_tables(here) && present != nullptr &&
                                     present->as<NodeList>() != nullptr));
      Node made{NodeTable(), place};
      if (tables) {
        made = Node{NodeList(), place};
      }
      remove_other_way(*table, path, parts[k]);
      at = &member_of(*table, parts[k], std::move(made));
      if (auto* list = at->as<NodeList>(); list != nullptr && tables) {
        const std::size_t number = index_of(parts[k + 1]);
        const bool numbered = number > 0 || parts[k + 1] == "0";
        if ((numbered ? number : 1) == list->size() + 1) {
          list->push_back(Node{NodeTable(), place});
        }
        if (!numbered) {
          at = &list->front();
        }
      }
    } else if (auto* list = at->as<NodeList>()) {
      at = &entry_of(*list, parts[k], path, setting);
    } else {
      setting.fail(fmt::format("{} is {}, it must be a table or a list to hold {}", path,
                               node_description(*at), parts[k]));
    }
    path += (path.empty() ? "" : ".") + parts[k];
  }
  *at = std::move(value);
}

// Whether a setting names an entry beside the diagonal of a symmetric matrix.
bool is_mirrored(const std::vector<std::string>& parts) {
  return parts.size() == 4 && parts[0] == "matrices" &&
         (parts[1] == "mass" || parts[1] == "stiffness") && parts[2] != parts[3];
}

}  // namespace

void apply_setting(Node& root, const std::string& text) {
  Setting setting = taken_apart(text);
  const Node value = value_of(setting);
  set_value(root, setting, value);
  if (!is_mirrored(setting.parts)) return;
  std::swap(setting.parts[2], setting.parts[3]);
  set_value(root, setting, value);
}

}  // namespace graze
