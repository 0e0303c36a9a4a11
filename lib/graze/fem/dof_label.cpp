#include "graze/fem/dof_label.hpp"

#include <charconv>

namespace graze {

std::string label_text(const DofLabel& label) {
  const std::string node = std::to_string(label.node);
  if (label.direction == 0) return node;
  const std::string text = node + "." + std::to_string(label.direction);
  return label.row == 0 ? text : text + "." + std::to_string(label.row);
}

std::optional<DofLabel> label_from_text(const std::string& text) {
  DofLabel label;
  const char* const end = text.data() + text.size();
  auto [at, error] = std::from_chars(text.data(), end, label.node);
  if (error != std::errc{}) return {};
  if (at == end) return label;
  if (*at != '.') return {};
  const auto direction = std::from_chars(at + 1, end, label.direction);
  if (direction.ec != std::errc{} || label.direction < 0) return {};
  if (direction.ptr == end) return label;
  if (*direction.ptr != '.' || label.direction == 0) return {};
  const auto row = std::from_chars(direction.ptr + 1, end, label.row);
  if (row.ec != std::errc{} || row.ptr != end || label.row < 1) return {};
  return label;
}

}  // namespace graze
