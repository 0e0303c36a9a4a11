// Private to this room. The document of a result, from its description.
#pragma once

#include <string>
#include <vector>

#include "graze/record/described/detail/result_visitor.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

class DocumentWriter : public ResultVisitor {
 public:
  DocumentWriter();
  // Moves the document out.
  Json take();

 protected:
  bool wants(Field::Use use) const override { return use != Field::Use::kTables; }
  bool open(const Field& field, Shape shape) override;
  void close() override;
  void take(const Field& field, const FieldValue& value) override;
  void hear_names_only(bool only) override { names_only_ = only; }

 private:
  struct Level {
    std::string name;
    Shape shape;
    Json json;
  };
  void put(std::string_view name, Json value);

  std::vector<Level> levels_;
  bool names_only_ = false;
};

// The units of all numbers of a description, by their names.
class UnitList : public ResultVisitor {
 public:
  Json take() { return std::move(units_); }
  bool sees_all() const override { return true; }

 protected:
  bool open(const Field& field, Shape shape) override;
  void close() override {}
  void take(const Field& field, const FieldValue& value) override;

 private:
  Json units_ = Json::object();
};

}  // namespace graze
