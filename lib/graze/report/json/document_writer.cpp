#include "graze/report/json/detail/document_writer.hpp"

#include <utility>

namespace graze {
namespace {

struct JsonOf {
  Json operator()(Missing) const { return nullptr; }
  Json operator()(bool value) const { return value; }
  Json operator()(long long value) const { return value; }
  Json operator()(double value) const { return json_number(value); }
  Json operator()(std::string_view value) const { return std::string(value); }
  Json operator()(const NumberPair& pair) const {
    return Json::array({json_number(pair.first), json_number(pair.second)});
  }
};

}  // namespace

DocumentWriter::DocumentWriter() { levels_.push_back({"", Shape::kPart, Json::object()}); }

Json DocumentWriter::take() {
  Json whole = std::move(levels_.front().json);
  levels_.front().json = Json::object();
  return whole;
}

bool DocumentWriter::open(const Field& field, Shape shape) {
  if (field.use == Field::Use::kTables) return false;
  const bool is_list = shape == Shape::kValues || shape == Shape::kList || shape == Shape::kSpread;
  levels_.push_back({std::string(field.name), shape, is_list ? Json::array() : Json::object()});
  return true;
}

void DocumentWriter::close() {
  Level done = std::move(levels_.back());
  levels_.pop_back();
  // The fields of an element of columns are added to their lists.
  if (done.shape == Shape::kElement && levels_.back().shape == Shape::kColumns) {
    Json& lists = levels_.back().json;
    for (auto& [name, value] : done.json.items()) {
      Json& list = lists[name];
      if (list.is_null()) list = Json::array();
      if (!names_only_) list.push_back(std::move(value));
    }
    return;
  }
  // Lists side by side without a name of their own.
  if (done.shape == Shape::kColumns && done.name.empty())
    for (auto& [name, list] : done.json.items()) put(name, std::move(list));
  else
    put(done.name, std::move(done.json));
}

void DocumentWriter::put(std::string_view name, Json value) {
  Json& into = levels_.back().json;
  if (into.is_array())
    into.push_back(std::move(value));
  else
    into[std::string(name)] = std::move(value);
}

void DocumentWriter::take(const Field& field, const FieldValue& value) {
  if (field.use == Field::Use::kTables || field.use == Field::Use::kUnit) return;
  put(field.name, std::visit(JsonOf{}, value));
}

bool UnitList::open(const Field& field, Shape) {
  if (!field.unit.empty()) units_[std::string(field.name)] = field.unit;
  return true;
}

void UnitList::take(const Field& field, const FieldValue&) {
  if (field.unit.empty() && field.use != Field::Use::kUnit) return;
  units_[std::string(field.name)] = field.unit;
}

}  // namespace graze
