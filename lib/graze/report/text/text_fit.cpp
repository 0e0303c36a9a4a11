#include <fmt/format.h>

#include <cmath>

#include "graze/record/detail/fit_record.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/detail/suggestion.hpp"

namespace graze {
namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.10g}", value) : "-";
}

std::string limits_text(const FittedParameter& parameter) {
  const bool low = std::isfinite(parameter.low), high = std::isfinite(parameter.high);
  if (!low && !high) return "none";
  return fmt::format("{}..{}", low ? fmt::format("{:.6g}", parameter.low) : "",
                     high ? fmt::format("{:.6g}", parameter.high) : "");
}

std::string parameters_text(const FitResult& result) {
  Table table({"parameter", "value", "uncertainty", "95 % interval", "start", "limits"});
  for (const FittedParameter& parameter : result.parameters) {
    std::string uncertainty = parameter.at_limit ? "at its limit" : "-", interval = "-";
    if (parameter.uncertainty) {
      uncertainty = fmt::format("{:.3g}", *parameter.uncertainty);
      interval = fmt::format("{} .. {}", fmt::format("{:.8g}", parameter.interval_low),
                             fmt::format("{:.8g}", parameter.interval_high));
    }
    table.add({with_unit(parameter.name, parameter.unit), number(parameter.value), uncertainty,
               interval, fmt::format("{:.6g}", parameter.start), limits_text(parameter)});
  }
  return table.text();
}

std::string correlations_text(const FitResult& result) {
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
      row.push_back(std::isfinite(value) ? fmt::format("{:.3f}", value) : "-");
    }
    table.add(row);
  }
  return any ? "\n" + table.text() : "";
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

std::string to_text(const FitRecord& record) {
  const FitResult& result = record.result;
  std::string text = fmt::format("{} in {}\n\n", name_of(result.kind), record.data_file);
  text += parameters_text(result) + correlations_text(result) + "\n" + residuals_text(result);
  if (result.quantile > 0.0)
    text +=
        fmt::format("intervals: {:.4g} standard uncertainties, {}\n", result.quantile,
                    result.knows_uncertainty
                        ? std::string("from the uncertainties of the data")
                        : fmt::format("Student's t with {} degrees of freedom", result.freedom));
  if (!record.unused_columns.empty())
    text += fmt::format("columns that are not used: {}\n", joined(record.unused_columns, "and"));
  text += fmt::format("least sum of squares by {}; {} evaluations of the model\n", result.method,
                      result.evaluations);
  if (!record.outcome.message.empty())
    text += fmt::format("{}: {}\n", record.outcome.name, record.outcome.message);
  return text;
}

}  // namespace graze
