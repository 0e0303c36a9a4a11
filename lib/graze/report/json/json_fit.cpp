#include "graze/record/detail/fit_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"

namespace graze {
namespace {

Json parameter_json(const FittedParameter& parameter) {
  Json json = {{"name", parameter.name},
               {"unit", parameter.unit},
               {"value", parameter.value},
               {"uncertainty", nullptr},
               {"interval", nullptr},
               {"at_limit", parameter.at_limit},
               {"start", parameter.start},
               {"low", json_number(parameter.low)},
               {"high", json_number(parameter.high)}};
  if (parameter.uncertainty) {
    json["uncertainty"] = json_number(*parameter.uncertainty);
    json["interval"] = {json_number(parameter.interval_low), json_number(parameter.interval_high)};
  }
  return json;
}

Json correlations_json(const Matrix& correlations) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < correlations.rows(); ++i)
    rows.push_back(json_list(correlations.row(i).transpose()));
  return rows;
}

Json series_json(const FittedSeries& series) {
  return {{"name", series.name},
          {"unit", series.unit},
          {"standard_deviation", series.noise},
          {"measured", json_list(series.measured)},
          {"predicted", json_list(series.predicted)},
          {"uncertainty",
           series.uncertainty.size() > 0 ? json_list(series.uncertainty) : Json(nullptr)}};
}

}  // namespace

std::string to_json(const FitRecord& record) {
  const FitResult& result = record.result;
  const Abscissa abscissa = abscissa_of(result.kind);
  Json document = document_head(record.info, record.outcome, record.warnings);
  document["data"] = {
      {"file", record.data_file},
      {"sha256", record.data_sha256},
      {"kind", name_of(result.kind)},
      {"values",
       result.series.empty() ? 0 : result.at.size() * static_cast<long>(result.series.size())},
      {"unused_columns", record.unused_columns}};
  document["parameters"] = Json::array();
  for (const FittedParameter& parameter : result.parameters)
    document["parameters"].push_back(parameter_json(parameter));
  document["correlations"] = correlations_json(result.correlations);
  document["uncertainties"] = result.knows_uncertainty ? "given" : "from the residuals";
  document["sum_of_squares"] = result.knows_uncertainty && !result.series.empty()
                                   ? Json(result.sum_of_squares)
                                   : Json(nullptr);
  document["degrees_of_freedom"] = result.freedom;
  document["quantile"] = result.quantile > 0.0 ? Json(result.quantile) : Json(nullptr);
  document["method"] = result.method;
  document["evaluations"] = result.evaluations;
  document["at"] = {
      {"name", abscissa.name}, {"unit", abscissa.unit}, {"values", json_list(result.at)}};
  document["series"] = Json::array();
  for (const FittedSeries& series : result.series)
    document["series"].push_back(series_json(series));
  return document_text(std::move(document), record.info);
}

}  // namespace graze
