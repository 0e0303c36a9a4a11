#include "docs/command_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <regex>
#include <sstream>

namespace graze::support {
namespace {

constexpr std::size_t kIndent = 4;

struct Block {
  int line = 0;
  std::vector<std::string> lines;  // without their common indentation
};

std::vector<std::string> lines_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t") == std::string::npos;
}

std::size_t indent_of(const std::string& line) { return line.find_first_not_of(' '); }

bool begins(const std::string& line, const std::string& with) { return line.rfind(with, 0) == 0; }

// The indented block that begins at `at`, which is set behind it.
Block indented_block(const std::vector<std::string>& lines, std::size_t& at) {
  Block block{static_cast<int>(at) + 1, {}};
  const std::size_t first = at;
  std::size_t end = at;
  for (; at < lines.size(); ++at) {
    if (is_blank(lines[at])) continue;
    if (indent_of(lines[at]) < kIndent) break;
    end = at + 1;
  }
  at = end;
  std::size_t indent = std::string::npos;
  for (std::size_t i = first; i < end; ++i)
    if (!is_blank(lines[i])) indent = std::min(indent, indent_of(lines[i]));
  for (std::size_t i = first; i < end; ++i)
    block.lines.push_back(is_blank(lines[i]) ? "" : lines[i].substr(indent));
  return block;
}

// What stands between two lines of three backticks.
Block fenced_block(const std::vector<std::string>& lines, std::size_t& at) {
  Block block{static_cast<int>(at) + 1, {}};
  for (++at; at < lines.size() && !begins(lines[at], "```"); ++at) block.lines.push_back(lines[at]);
  if (at < lines.size()) ++at;
  return block;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

class Reader {
 public:
  std::vector<PageCommand> read(const std::string& page) {
    const std::vector<std::string> lines = lines_in(page);
    for (std::size_t at = 0; at < lines.size();) {
      if (begins(lines[at], "```"))
        take(fenced_block(lines, at));
      else if (!is_blank(lines[at]) && indent_of(lines[at]) >= kIndent)
        take(indented_block(lines, at));
      else
        take_prose(lines[at++]);
    }
    return commands_;
  }

 private:
  void take_prose(const std::string& line) {
    static const std::regex numbers("<!-- prints ([^>]*) -->");
    std::smatch match;
    if (line == "<!-- printed -->") {
      part_follows_ = true;
    } else if (!commands_.empty() && std::regex_search(line, match, numbers)) {
      std::istringstream list(match[1]);
      for (std::string number; list >> number;) commands_.back().numbers.push_back(number);
    }
  }

  void take(const Block& block) {
    const auto has = [&](const char* start) {
      return std::any_of(block.lines.begin(), block.lines.end(), [&](const std::string& line) {
        return begins(line, start) || begins(line, std::string("  ") + start);
      });
    };
    if (part_follows_ && !commands_.empty())
      commands_.back().parts.push_back(block.lines);
    else if (has("$ "))
      take_dialogue(block);
    else if (has("build/"))
      commands_.push_back({block.line, joined(block.lines), false, {}, {}, {}, data_});
    else
      data_ = joined(block.lines);
    part_follows_ = false;
  }

  void take_dialogue(const Block& block) {
    bool goes_on = false;
    for (std::size_t i = 0; i < block.lines.size(); ++i) {
      const std::string& line = block.lines[i];
      if (begins(line, "$ ")) {
        commands_.push_back(
            {block.line + static_cast<int>(i), line.substr(2) + "\n", false, {}, {}, {}, data_});
        goes_on = line.back() == '\\';
      } else if (goes_on) {
        commands_.back().text += line + "\n";
        goes_on = !line.empty() && line.back() == '\\';
      } else if (!commands_.empty() && !line.empty()) {
        commands_.back().shows = true;
        commands_.back().output.push_back(line);
      }
    }
  }

  std::vector<PageCommand> commands_;
  std::string data_;
  bool part_follows_ = false;
};

}  // namespace

std::vector<PageCommand> commands_of(const std::string& page) { return Reader().read(page); }

std::string visible_text(const std::string& page) {
  return std::regex_replace(page, std::regex("<!--[^>]*-->"), "");
}

}  // namespace graze::support
