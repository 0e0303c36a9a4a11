#include "graze/base/errors.hpp"

#include <fmt/format.h>

namespace graze {

std::string SourceLocation::text() const {
  return line == 0 ? file : fmt::format("{}:{}:{}", file, line, column);
}

InputError::InputError(const SourceLocation& where, const std::string& key,
                       const std::string& sentence)
    : std::runtime_error(fmt::format("{}: {}: {}", where.text(), key, sentence)) {}

}  // namespace graze
