#include "graze/fem/dof_label.hpp"

#include <charconv>

namespace graze {

std::string label_text(const DofLabel& label) {
  const std::string node = std::to_string(label.node);
  return label.direction == 0 ? node : node + "." + std::to_string(label.direction);
}

std::optional<DofLabel> label_from_text(const std::string& text) {
  DofLabel label;
  const char* const end = text.data() + text.size();
  auto [at, error] = std::from_chars(text.data(), end, label.node);
  if (error != std::errc{}) return {};
  if (at == end) return label;
  if (*at != '.') return {};
  const auto direction = std::from_chars(at + 1, end, label.direction);
  if (direction.ec != std::errc{} || direction.ptr != end || label.direction < 0) return {};
  return label;
}

}  // namespace graze
