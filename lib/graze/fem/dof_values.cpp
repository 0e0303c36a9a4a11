#include "graze/fem/dof_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "graze/base/errors.hpp"
#include "graze/fem/detail/matrix_formats.hpp"
#include "graze/fem/detail/text_lines.hpp"

namespace graze {
namespace {

void check_size(const std::string& file, Eigen::Index values, std::size_t labels) {
  if (values != static_cast<Eigen::Index>(labels))
    throw InputError(fmt::format("{}: it has {} values, the structure has {} degrees of freedom",
                                 file, values, labels));
}

}  // namespace

Vector read_dof_values(const std::filesystem::path& file, const std::vector<DofLabel>& labels,
                       const std::vector<DofLabel>& others) {
  const std::string name = file.string();
  if (file.extension() == ".npy") {
    const Vector values = read_npy_vector(name, read_bytes(file));
    check_size(name, values.size(), labels.size());
    return values;
  }
  std::map<DofLabel, Eigen::Index> places;
  for (std::size_t i = 0; i < labels.size(); ++i)
    places.emplace(labels[i], static_cast<Eigen::Index>(i));
  for (const DofLabel& label : others) places.emplace(label, -1);
  TextLines lines(name, read_bytes(file));
  Vector values = Vector::Zero(static_cast<Eigen::Index>(labels.size()));
  std::vector<double> single;
  std::set<DofLabel> seen;
  while (lines.next()) {
    const std::string_view text = trimmed(lines.line());
    if (text.empty() || text.front() == '#') continue;
    const auto& parts = lines.parts();
    if (parts.size() == 1 && seen.empty()) {
      single.push_back(lines.real(parts[0]));
      continue;
    }
    if (parts.size() != 2 || !single.empty())
      lines.fail("the line must hold a degree of freedom and a value, or all lines one value");
    const std::optional<DofLabel> label = label_from_text(std::string(parts[0]));
    const auto found = label ? places.find(*label) : places.end();
    if (found == places.end())
      lines.fail(fmt::format("the structure has no degree of freedom \"{}\"", parts[0]));
    if (!seen.insert(*label).second)
      lines.fail(fmt::format("the degree of freedom {} stands twice", parts[0]));
    const double value = lines.real(parts[1]);
    if (found->second >= 0) values[found->second] = value;
  }
  if (single.empty()) return values;
  check_size(name, static_cast<Eigen::Index>(single.size()), labels.size());
  return Eigen::Map<const Vector>(single.data(), static_cast<Eigen::Index>(single.size()));
}

}  // namespace graze
