// DMIG entries of the bulk data of Nastran (MSC Nastran Quick Reference Guide, "Direct Matrix Input
// at Points"), in small fields (8 columns), large ones (16 columns, names with *) or free ones
// (separated by commas or tabs):
//
//   DMIG, name, 0, IFO, TIN, ..                      IFO 1 square, 6 symmetric; TIN 1, 2 real
//   DMIG, name, GJ, CJ, , G1, C1, A1, , G2, C2, A2   column (GJ, CJ), rows (G, C) with A
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "graze/fem/detail/label_index.hpp"
#include "graze/fem/detail/matrix_formats.hpp"

namespace graze {
namespace {

struct Field {
  std::string text;
  int line = 0;
};

// The fields of one line, without the first (the name of the entry) and the last (continuation).
void add_fields(const TextLines& lines, std::string_view line, std::vector<Field>& fields) {
  const auto add = [&](std::string_view text) {
    fields.push_back({std::string(trimmed(text)), lines.number()});
  };
  line = line.substr(0, line.find_last_not_of(" \t") + 1);
  const char parting = line.find(',') != std::string_view::npos ? ',' : '\t';
  if (line.find(parting) != std::string_view::npos) {
    const std::size_t wanted = line.find('*') != std::string_view::npos ? 4 : 8;
    std::size_t at = 0, count = 0;
    const auto next = [&] {
      const std::size_t end = std::min(line.find(parting, at), line.size());
      const std::string_view field = trimmed(line.substr(at, end - at));
      if (field.find_first_of(" \t") != std::string_view::npos)
        lines.fail(
            fmt::format("the field \"{}\" has blanks or tabs within, fields must be separated "
                        "in one way: by columns of blanks, by commas or by tabs",
                        field));
      at = end + 1;
      return field;
    };
    next();
    for (; count < wanted && at <= line.size(); ++count) add(next());
    for (; count < wanted; ++count) add("");
    return;
  }
  const bool large = line.substr(0, 8).find('*') != std::string_view::npos;
  const std::size_t width = large ? 16 : 8, wanted = large ? 4 : 8;
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t at = 8 + i * width;
    add(at < line.size() ? line.substr(at, width) : std::string_view());
  }
}

struct DmigMatrix {
  int header = 0;  // line
  bool is_symmetric = false;
  std::vector<LabelledEntry> entries;
};

class DmigReader {
 public:
  explicit DmigReader(TextLines& lines) : lines_(lines) {}

  std::map<std::string, DmigMatrix> read() {
    std::vector<Field> fields;
    bool inside = false;
    const auto finish = [&] {
      if (inside) take(fields);
      fields.clear();
      inside = false;
    };
    while (lines_.next()) {
      const std::string_view line = lines_.line().substr(0, lines_.line().find('$'));
      if (trimmed(line).empty()) continue;
      const char first = line.front();
      const bool goes_on = std::string_view(" \t+*,").find(first) != std::string_view::npos;
      if (!goes_on) {
        finish();
        inside = starts_without_case(line, "DMIG") &&
                 (line.size() == 4 || std::string_view(" \t*,").find(line[4]) != line.npos);
      }
      if (inside) add_fields(lines_, line, fields);
    }
    finish();
    return std::move(matrices_);
  }

 private:
  long integer(const Field& field) const {
    const char* begin = field.text.c_str();
    char* end = nullptr;
    const long value = std::strtol(begin, &end, 10);
    if (end == begin || *end != '\0')
      lines_.fail_at(field.line,
                     fmt::format("\"{}\" is not allowed, it must be an integer", field.text));
    return value;
  }
  double real(const Field& field) const {
    try {
      return lines_.real(field.text);
    } catch (const InputError&) {
      lines_.fail_at(field.line,
                     fmt::format("\"{}\" is not allowed, it must be a finite number", field.text));
    }
  }
  static const Field& at(const std::vector<Field>& fields, std::size_t i) {
    static const Field none{};
    return i < fields.size() ? fields[i] : none;
  }
  DofLabel label(const Field& node, const Field& direction) const {
    return {integer(node), direction.text.empty() ? 0 : static_cast<int>(integer(direction))};
  }

  void take(const std::vector<Field>& fields) {
    const std::string& name = fields.front().text;
    if (at(fields, 1).text == "0") {
      take_header(name, fields);
      return;
    }
    const auto found = matrices_.find(name);
    if (found == matrices_.end())
      lines_.fail_at(fields.front().line,
                     fmt::format("the matrix {} has no header, DMIG, {}, 0, ..", name, name));
    const DofLabel column = label(at(fields, 1), at(fields, 2));
    for (std::size_t i = 4; i < fields.size(); i += 4) {
      if (fields[i].text.empty()) continue;
      if (!at(fields, i + 3).text.empty() && real(at(fields, i + 3)) != 0.0)
        lines_.fail_at(fields[i].line, "the entry has an imaginary part, the matrix must be real");
      found->second.entries.push_back(
          {label(fields[i], at(fields, i + 1)), column, fields[i].line, real(at(fields, i + 2))});
    }
  }
  void take_header(const std::string& name, const std::vector<Field>& fields) {
    const long form = integer(at(fields, 2)), type = integer(at(fields, 3));
    const int line = fields.front().line;
    if (form != 1 && form != 6)
      lines_.fail_at(line, fmt::format("the matrix {} has the form {}, it must be 1 (square) or 6 "
                                       "(symmetric)",
                                       name, form));
    if (type != 1 && type != 2)
      lines_.fail_at(
          line, fmt::format("the matrix {} has the type {}, it must be 1 or 2 (real)", name, type));
    if (!matrices_.emplace(name, DmigMatrix{line, form == 6, {}}).second)
      lines_.fail_at(line, fmt::format("the matrix {} has a header already", name));
  }

  TextLines& lines_;
  std::map<std::string, DmigMatrix> matrices_;
};

std::string names_of(const std::map<std::string, DmigMatrix>& matrices) {
  std::string text;
  for (const auto& [name, matrix] : matrices) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

LabelledMatrix read_dmig(TextLines& lines, const std::string& wanted) {
  const std::map<std::string, DmigMatrix> matrices = DmigReader(lines).read();
  if (matrices.empty()) lines.fail_at(0, "the file has no DMIG entry");
  if (wanted.empty() && matrices.size() > 1)
    lines.fail_at(0, fmt::format("the file has the matrices {}, one of them must be named like "
                                 "\"{}#{}\"",
                                 names_of(matrices), lines.name(), matrices.begin()->first));
  const auto found = wanted.empty() ? matrices.begin() : matrices.find(wanted);
  if (found == matrices.end())
    lines.fail_at(0,
                  fmt::format("the file has no matrix {}, it has {}", wanted, names_of(matrices)));
  LabelledMatrix result{lines.name(), {}, {}, true, {}};
  std::vector<MatrixEntry> entries = indexed(found->second.entries, result.labels);
  set_entries(result, static_cast<int>(result.labels.size()), std::move(entries),
              found->second.is_symmetric ? EntryStorage::kOneTriangle : EntryStorage::kFull);
  return result;
}

}  // namespace graze
