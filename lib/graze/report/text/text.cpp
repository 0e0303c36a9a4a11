#include "graze/report/text/text.hpp"

#include "graze/report/text/detail/line_breaks.hpp"

namespace graze {

std::string fitted_lines(const std::string& text, const TextOptions& options) {
  return wrapped_text(text, options.width);
}

}  // namespace graze
