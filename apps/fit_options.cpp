#include "fit_options.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "graze/base/errors.hpp"
#include "option_values.hpp"

namespace graze {

std::vector<SoughtParameter> sought_parameters(const std::vector<std::string>& words) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  std::vector<SoughtParameter> list;
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    SoughtParameter parameter{word.substr(0, sign), -kNoLimit, kNoLimit};
    if (sign != std::string::npos) {
      const std::string limits = word.substr(sign + 1);
      const std::size_t colon = limits.find(':');
      const auto low = number_in(limits.substr(0, colon));
      const auto high =
          colon == std::string::npos ? std::nullopt : number_in(limits.substr(colon + 1));
      if (!low || !high)
        throw InputError(
            fmt::format("--parameter: '{}' is not NAME=LOW:HIGH with two finite numbers, e.g. "
                        "stop.gap=1e-3:2e-3",
                        word));
      parameter.low = *low;
      parameter.high = *high;
    }
    list.push_back(parameter);
  }
  return list;
}

MeasurementOptions measurement_options(const FitCommand& command) {
  MeasurementOptions options;
  options.columns = command.columns;
  for (const std::string& word : command.sigmas) {
    const std::size_t sign = word.find('=');
    const std::string column = sign == std::string::npos ? "" : word.substr(0, sign);
    const auto value = number_in(sign == std::string::npos ? word : word.substr(sign + 1));
    if (!value || !(*value > 0.0))
      throw InputError(fmt::format(
          "--sigma: '{}' is not allowed; give a standard uncertainty above 0, alone or as "
          "COLUMN=VALUE",
          word));
    options.uncertainties.emplace_back(column, *value);
  }
  return options;
}

}  // namespace graze
