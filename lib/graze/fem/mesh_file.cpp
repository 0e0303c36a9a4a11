#include "graze/fem/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "graze/fem/detail/text_lines.hpp"

namespace graze {
namespace {

// What a line adds to a set: the nodes from the first to the last, or those of another set.
struct Member {
  long first, last, step;
  std::string set;
  int line;
};

class MeshReader {
 public:
  explicit MeshReader(TextLines& lines) : lines_(lines) {}

  Mesh read() {
    take_ = &MeshReader::take_node;
    while (lines_.next_text()) {
      const std::string_view text = trimmed(lines_.line());
      if (text.starts_with("**") || text.front() == '#') continue;
      if (text.front() == '*')
        take_keyword();
      else if (take_)
        (this->*take_)();
    }
    finish_element();
    if (mesh_.nodes.empty()) lines_.fail_at(0, "the file has no nodes");
    fill_sets();
    return std::move(mesh_);
  }

 private:
  using Taker = void (MeshReader::*)();

  // "*NSET, NSET=TIP, GENERATE"
  void take_keyword() {
    finish_element();
    std::string keyword;
    parameters_.clear();
    for (std::string_view rest = trimmed(lines_.line()); !rest.empty();) {
      const std::size_t end = std::min(rest.find(','), rest.size());
      const std::string_view part = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      const std::size_t equals = part.find('=');
      const std::string name = in_capitals(trimmed(part.substr(0, equals)));
      if (keyword.empty())
        keyword = name;
      else
        parameters_[name] =
            equals == part.npos ? "" : in_capitals(trimmed(part.substr(equals + 1)));
    }
    take_ = keyword == "*NODE"      ? &MeshReader::take_node
            : keyword == "*ELEMENT" ? &MeshReader::take_element
            : keyword == "*NSET"    ? &MeshReader::take_set
                                    : nullptr;
    if (take_ == &MeshReader::take_set && parameters_["NSET"].empty())
      lines_.fail("the set has no name, the keyword must be *NSET, NSET=NAME");
  }

  void take_node() {
    const auto& parts = lines_.parts();
    if (parts.size() != 3 && parts.size() != 4)
      lines_.fail(fmt::format("the line has {} entries, it must have a node and its x, y and z",
                              parts.size()));
    std::array<double, 3> place{};
    for (std::size_t i = 1; i < parts.size(); ++i) place[i - 1] = lines_.real(parts[i]);
    const long node = lines_.integer(parts[0]);
    if (!mesh_.nodes.emplace(node, place).second)
      lines_.fail(fmt::format("the node {} stands twice", parts[0]));
    if (const auto set = parameters_.find("NSET"); set != parameters_.end())
      members_[set->second].push_back({node, node, 1, {}, 0});
  }

  // A line that ends with a comma continues in the next.
  void take_element() {
    for (const std::string_view part : lines_.parts()) numbers_.push_back(lines_.integer(part));
    if (trimmed(lines_.line()).back() != ',') finish_element();
  }
  void finish_element() {
    if (numbers_.size() > 1)
      mesh_.elements.push_back({parameters_["TYPE"], {numbers_.begin() + 1, numbers_.end()}});
    numbers_.clear();
  }

  // Takes numbers of nodes and names of sets, or first, last and step.
  void take_set() {
    std::vector<Member>& members = members_[parameters_["NSET"]];
    const auto& parts = lines_.parts();
    if (parameters_.contains("GENERATE")) {
      if (parts.size() != 2 && parts.size() != 3)
        lines_.fail("the line must have the first node, the last and, if it is not 1, the step");
      const long step = parts.size() == 3 ? lines_.integer(parts[2]) : 1;
      if (step < 1) lines_.fail(fmt::format("the step {} must be at least 1", step));
      members.push_back({lines_.integer(parts[0]), lines_.integer(parts[1]), step, {}, 0});
      return;
    }
    for (const std::string_view part : parts) {
      const bool is_name = part.find_first_not_of("+-0123456789") != part.npos;
      const long node = is_name ? 0 : lines_.integer(part);
      members.push_back(
          {node, node, 1, is_name ? std::string(part) : std::string(), lines_.number()});
    }
  }

  // Once all is read: nodes and sets may stand below the sets that name them.
  void fill_sets() {
    for (const auto& [name, members] : members_) {
      std::set<std::string> seen;
      std::set<long> nodes;
      add_members(name, seen, nodes);
      mesh_.sets[name].assign(nodes.begin(), nodes.end());
    }
  }

  void add_members(const std::string& name, std::set<std::string>& seen, std::set<long>& nodes) {
    if (!seen.insert(name).second) return;  // of sets that name each other
    for (const Member& member : members_.at(name)) {
      if (member.set.empty()) {
        add_range(member, nodes);
      } else if (const std::string other = in_capitals(member.set); members_.contains(other)) {
        add_members(other, seen, nodes);
      } else {
        lines_.fail_at(member.line,
                       fmt::format("\"{}\" is neither a node's number nor a set", member.set));
      }
    }
  }

  // A node that is named alone need not have a place.
  void add_range(const Member& range, std::set<long>& nodes) const {
    if (range.first == range.last) nodes.insert(range.first);
    for (auto node = mesh_.nodes.lower_bound(range.first);
         node != mesh_.nodes.end() && node->first <= range.last; ++node)
      if ((node->first - range.first) % range.step == 0) nodes.insert(node->first);
  }

  TextLines& lines_;
  Mesh mesh_;
  Taker take_ = nullptr;  // of lines below the present keyword; null: they are skipped
  std::map<std::string, std::string> parameters_;       // of the keyword, in capitals
  std::map<std::string, std::vector<Member>> members_;  // of each set
  std::vector<long> numbers_;                           // of the element that is being read
};

}  // namespace

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return capitals;
}

Mesh read_mesh(const std::filesystem::path& file) {
  TextLines lines(file.string(), read_bytes(file));
  return MeshReader(lines).read();
}

}  // namespace graze
