// Results: their documents, texts, tables as NumPy arrays, charts and pictures.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <utility>

#include "bindings.hpp"
#include "charts.hpp"
#include "drawing.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/units.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/reader.hpp"
#include "in_process.hpp"
#include "shown_choice.hpp"

namespace graze {
namespace {

namespace py = pybind11;

// In the order of AnyRecord.
constexpr const char* kKinds[] = {
    "check", "simulation", "orbits",         "branches",    "loci", "diagram", "run_diagram",
    "map",   "comparison", "comparison_map", "sensitivity", "cost", "fit",     "modes"};
static_assert(std::size(kKinds) == std::variant_size_v<AnyRecord>);

const AnyRecord& record_of(const FoundResult& result) {
  if (!result.record()) throw py::value_error("the command ended without a result");
  return *result.record();
}

py::str words(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

// Read-only, as tables share one memory with the result.
template <class Number>
py::array view(const Number* data, std::size_t count, std::size_t stride, const py::object& owner) {
  py::array_t<Number> array({count}, {stride * sizeof(Number)}, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

// Takes the list's memory over.
template <class Number>
py::array array_of(std::vector<Number>&& list) {
  auto* kept = new std::vector<Number>(std::move(list));
  const py::capsule owner(kept, [](void* at) { delete static_cast<std::vector<Number>*>(at); });
  return view(kept->data(), kept->size(), 1, owner);
}

py::object values_of(decltype(ResultColumn::values)&& of) {
  if (auto* listed = std::get_if<WordColumn>(&of)) {
    py::list names;
    for (const std::string& word : listed->words) names.append(words(word));
    return py::make_tuple(array_of(std::move(listed->codes)), names);
  }
  if (auto* truths = std::get_if<TruthColumn>(&of)) return array_of(std::move(truths->codes));
  if (auto* whole = std::get_if<std::vector<std::int64_t>>(&of)) return array_of(std::move(*whole));
  return array_of(std::move(std::get<std::vector<double>>(of)));
}

// Columns of rows, all in one piece of memory that `owner` keeps.
py::list columns_of(const Rows& rows, const py::object& owner) {
  py::list list;
  for (std::size_t i = 0; i < rows.columns().size(); ++i)
    list.append(py::make_tuple(rows.columns()[i],
                               view(rows.data() + i, rows.count(), rows.columns().size(), owner)));
  return list;
}

py::list table(const py::object& self, const std::string& name) {
  const auto& result = self.cast<const FoundResult&>();
  record_of(result);
  if (name == "samples" && result.samples()) return columns_of(*result.samples(), self);
  std::optional<ResultTable> found;
  {
    const py::gil_scoped_release release;
    found = table_of(result, name);
  }
  if (!found) throw py::key_error(name);
  py::list list;
  for (ResultColumn& column : found->take_columns())
    list.append(py::make_tuple(column.name, values_of(std::move(column.values))));
  return list;
}

std::string printed(const FoundResult& result, bool verbose) {
  const TextOptions options{100, verbose};
  return std::visit(
      [&](const auto& record) { return fitted_lines(to_text(record, options), options); },
      record_of(result));
}

// Throws where the record is not drawn into such a file, or keeps too little of what is drawn.
template <class Record>
void check_drawable(const CommonOptions& command, const Record& record) {
  check_plot<Record>(command);
  if (const std::string nothing = nothing_to_draw(record); !nothing.empty())
    throw py::value_error(nothing);
}
void check_drawable(const CommonOptions& command, const MapRecord& record) {
  check_plot<MapRecord>(command);
  if (is_page_name(command.plot.file)) check_map_page(command.plot.file, record.map.options);
}
void check_drawable(const CommonOptions& command, const SimulationRecord& record) {
  check_plot<SimulationRecord>(command);
  if (record.samples.empty() && !record.section)
    throw py::value_error(
        "the run kept none of the motion that a picture shows; give it a folder, out=, or plot()");
}

// The record as `look` sees it: as it is, or a copy that shows something else (--show, --at).
template <class Look>
auto showing(const FoundResult& result, const std::string& show, const std::string& at,
             const Look& look) {
  if (show.empty() && !at.empty()) throw InputError("--at: it needs --show");
  if (show.empty()) return std::visit(look, record_of(result));
  AnyRecord copy = record_of(result);
  choose_shown({show, at, "the call"}, copy);
  return std::visit(look, std::as_const(copy));
}

void save(const FoundResult& result, const std::string& file, const std::string& show,
          const std::string& at) {
  const py::gil_scoped_release release;
  CommonOptions command;
  command.plot.file = file;
  showing(result, show, at, [&](const auto& record) {
    check_drawable(command, record);
    draw(command, record, result.scene());
  });
}

// None where there is nothing to draw.
std::optional<py::dict> chart(const FoundResult& result, const std::string& show,
                              const std::string& at) {
  return showing(result, show, at, [&](const auto& record) -> std::optional<py::dict> {
    if (!nothing_to_draw(record).empty()) return {};
    return chart_dict(chart_shown(record, result.scene()));
  });
}

template <class Record>
const std::vector<std::string>& warnings_in(const Record& record) {
  if constexpr (requires { record.warnings; })
    return record.warnings;
  else
    return record.branches.warnings;
}

// Throws where there is none.
const FoundResult& complete(const FoundResult& result) {
  record_of(result);
  return result;
}

}  // namespace

void bind_results(py::module_& module) {
  using Self = const FoundResult&;
  py::class_<FoundResult, std::shared_ptr<FoundResult>>(module, "FoundResult")
      .def_property_readonly(
          "kind",
          [](Self self) {
            return self.record() ? std::optional<std::string>(kKinds[self.record()->index()])
                                 : std::nullopt;
          })
      .def_property_readonly("scene_text",
                             [](Self self) { return words(write_scene(complete(self).scene())); })
      .def_property_readonly("outcome", [](Self self) { return outcome_of(complete(self)).name; })
      .def_property_readonly("message",
                             [](Self self) { return words(outcome_of(complete(self)).message); })
      .def_property_readonly(
          "warnings",
          [](Self self) {
            py::list list;
            for (const std::string& warning : std::visit(
                     [](const auto& record) { return warnings_in(record); }, record_of(self)))
              list.append(words(warning));
            return list;
          })
      .def("json",
           [](Self self) {
             std::string text;
             {
               const py::gil_scoped_release release;
               text = document_of(complete(self));
             }
             return words(text);
           })
      .def("text", [](Self self, bool verbose) { return words(printed(self, verbose)); })
      .def("table_names", [](Self self) { return table_names(complete(self)); })
      .def("table", table)
      .def("chart", chart)
      .def("unit",
           [](Self self, const std::string& unit) {
             return unit_in(complete(self).scene().units, unit);
           })
      .def("save", save);
  module.def("looks", look_dicts);
  module.def("axis_unit", axis_unit_pair);
}

}  // namespace graze
