#include <fmt/format.h>

#include <cmath>

#include "graze/record/study_records.hpp"
#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

std::string number(double value) { return std::isfinite(value) ? digits_text(value, 10) : "-"; }

std::string limits_text(const FittedParameter& parameter) {
  const bool low = std::isfinite(parameter.low), high = std::isfinite(parameter.high);
  if (!low && !high) return "none";
  return fmt::format("{}..{}", low ? digits_text(parameter.low, 6) : "",
                     high ? digits_text(parameter.high, 6) : "");
}

std::string parameters_text(const FitResult& result, const TextOptions& options) {
  Table table({"parameter", "value", "uncertainty", "95 % interval", "start", "limits"});
  for (const FittedParameter& parameter : result.parameters) {
    std::string uncertainty = parameter.at_limit ? "at its limit" : "-", interval = "-";
    if (parameter.uncertainty) {
      uncertainty = digits_text(*parameter.uncertainty, 3);
      interval = fmt::format("{} .. {}", digits_text(parameter.interval_low, 8),
                             digits_text(parameter.interval_high, 8));
    }
    table.add({with_unit(parameter.name, parameter.unit), number(parameter.value), uncertainty,
               interval, digits_text(parameter.start, 6), limits_text(parameter)});
  }
  return table.text(options.width);
}

std::string correlations_text(const FitResult& result, const TextOptions& options) {
  if (result.parameters.size() < 2) return "";
  std::vector<std::string> header = {"correlation"};
  for (const FittedParameter& parameter : result.parameters) header.push_back(parameter.name);
  Table table(header);
  bool any = false;
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    std::vector<std::string> row = {result.parameters[i].name};
    for (std::size_t j = 0; j < result.parameters.size(); ++j) {
      const double value =
          result.correlations.size() == 0
              ? NAN
              : result.correlations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      any = any || std::isfinite(value);
      row.push_back(std::isfinite(value) ? decimals_text(value, 3) : "-");
    }
    table.add(row);
  }
  return any ? "\n" + table.text(options.width) : "";
}

std::string residuals_text(const FitResult& result) {
  std::string text;
  for (const FittedSeries& series : result.series) {
    const Vector missed = series.predicted - series.measured;
    text += fmt::format("{}: {} values, {} {:.3g}{}, largest residual {:.3g}{}", series.name,
                        missed.size(),
                        result.knows_uncertainty ? "root mean square of the residuals"
                                                 : "their standard deviation from the model",
                        series.noise, series.unit.empty() ? "" : " " + series.unit,
                        missed.cwiseAbs().maxCoeff(), series.unit.empty() ? "" : " " + series.unit);
    text += "\n";
  }
  if (result.knows_uncertainty && !result.series.empty())
    text += fmt::format("sum of squares over the uncertainties {:.4g}, degrees of freedom {}\n",
                        result.sum_of_squares, result.freedom);
  return text;
}

}  // namespace

std::string to_text(const FitRecord& record, const TextOptions& options) {
  const FitResult& result = record.result;
  std::string text = fmt::format("{} in {}\n\n", name_of(result.kind), record.data_file);
  text += parameters_text(result, options) + correlations_text(result, options) + "\n" +
          residuals_text(result);
  if (result.quantile > 0.0)
    text +=
        fmt::format("intervals: {:.4g} standard uncertainties, {}\n", result.quantile,
                    result.knows_uncertainty
                        ? std::string("from the uncertainties of the data")
                        : fmt::format("Student's t with {} degrees of freedom", result.freedom));
  if (!record.unused_columns.empty())
    text += fmt::format("columns that are not used: {}\n", joined(record.unused_columns, "and"));
  if (options.verbose)
    text += fmt::format("least sum of squares by {}; {} evaluations of the model\n", result.method,
                        result.evaluations);
  return text + ending(record.outcome);
}

}  // namespace graze
