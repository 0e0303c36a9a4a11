#include "graze/fem/matrix_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "graze/fem/detail/matrix_formats.hpp"
#include "graze/fem/detail/text_lines.hpp"

namespace graze {
namespace {

std::string lower_extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// "model.pch#KAAX" names the file and the matrix in it, unless there is a file of that name.
std::string cut_name(std::filesystem::path& file) {
  const std::string text = file.string();
  const std::size_t at = text.rfind('#');
  std::error_code no_matter;
  if (at == std::string::npos || std::filesystem::exists(file, no_matter)) return "";
  file = text.substr(0, at);
  return text.substr(at + 1);
}

// Calls `take` for each name, with its line.
std::vector<DofLabel> names_in(const std::filesystem::path& file,
                               const std::function<void(const TextLines&, const DofLabel&)>& take) {
  TextLines lines(file.string(), read_bytes(file));
  std::vector<DofLabel> names;
  while (lines.next()) {
    const std::string_view text = trimmed(lines.line().substr(0, lines.line().find('#')));
    if (text.empty()) continue;
    const std::optional<DofLabel> label = label_from_text(std::string(text));
    if (!label)
      lines.fail(fmt::format(
          "\"{}\" is not allowed, it must be a degree of freedom, node.direction or a number",
          text));
    take(lines, *label);
    names.push_back(*label);
  }
  if (names.empty()) lines.fail_at(0, "the file names no degree of freedom");
  return names;
}

}  // namespace

LabelledMatrix read_matrix(const std::filesystem::path& file) {
  LabelledMatrix matrix = read_general_matrix(file);
  if (!matrix.asymmetry.empty()) throw InputError(matrix.asymmetry);
  return matrix;
}

LabelledMatrix read_general_matrix(const std::filesystem::path& given) {
  std::filesystem::path file = given;
  const std::string wanted = cut_name(file);
  const std::string kind = lower_extension(file), name = file.string();
  const auto any_of = [&](std::initializer_list<const char*> kinds) {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  };
  const bool is_dmig = any_of({".bdf", ".dat", ".nas", ".pch"});
  if (!wanted.empty() && !is_dmig)
    throw InputError(fmt::format(
        "{}: only a Nastran file has matrices with names, \"#{}\" must be left out", name, wanted));
  if (kind == ".npz") return read_npz(file);
  if (kind == ".npy") return read_npy(name, read_bytes(file));
  if (!is_dmig && !any_of({".mtx", ".sti", ".mas", ".dam"}))
    throw InputError(fmt::format(
        "{}: \"{}\" is no format of matrices, it must be .mtx (Matrix Market, Abaqus), .sti, .mas "
        "or .dam (CalculiX), .npy or .npz (NumPy), .bdf, .dat, .nas or .pch (Nastran)",
        name, kind));
  TextLines lines(name, read_bytes(file));
  if (is_dmig) return read_dmig(lines, wanted);
  if (kind != ".mtx") return read_calculix(lines);
  TextLines ahead = lines;
  return ahead.next_text() && starts_without_case(ahead.line(), "%%MatrixMarket")
             ? read_matrix_market(lines)
             : read_abaqus(lines);
}

std::vector<DofLabel> read_dof_names(const std::filesystem::path& file) {
  std::set<DofLabel> seen;
  return names_in(file, [&](const TextLines& lines, const DofLabel& label) {
    if (!seen.insert(label).second)
      lines.fail(fmt::format("the degree of freedom {} stands twice", label_text(label)));
  });
}

std::vector<DofLabel> read_row_names(const std::filesystem::path& file) {
  std::vector<DofLabel> names = names_in(file, [](const TextLines&, const DofLabel&) {});
  std::map<DofLabel, int> rows;
  for (const DofLabel& name : names) ++rows[name];
  std::erase_if(rows, [](const auto& name) { return name.second == 1; });
  for (auto name = names.rbegin(); name != names.rend(); ++name)
    if (const auto found = rows.find(*name); found != rows.end()) name->row = found->second--;
  return names;
}

}  // namespace graze
