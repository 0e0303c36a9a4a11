// Errors of the library as exceptions of graze.errors.
#include <regex>

#include "bindings.hpp"
#include "graze/base/errors.hpp"

namespace graze {
namespace {

namespace py = pybind11;

void raise(const char* kind, const py::object& exception) {
  PyErr_SetObject(py::module_::import("graze.errors").attr(kind).ptr(), exception.ptr());
}

py::object made(const char* kind, const std::string& sentence) {
  // Names of files may be no UTF-8.
  const py::object words = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(sentence.data(), static_cast<Py_ssize_t>(sentence.size()), "replace"));
  return py::module_::import("graze.errors").attr(kind)(words);
}

void raise_input_error(const std::string& sentence) {
  // "file:line:column: key: sentence", as errors.hpp says.
  static const std::regex place(R"(^([^\n]+?):(\d{1,9}):(\d{1,9}): )");
  std::smatch match;
  if (!std::regex_search(sentence, match, place)) {
    // What is wrong with a scene has a place in it, but for what --set says.
    const char* kind = sentence.rfind("--set ", 0) == 0 ? "SceneError" : "OptionError";
    raise(kind, made(kind, sentence));
    return;
  }
  const py::object exception = made("SceneError", sentence);
  exception.attr("file") = made("Error", match[1]).attr("args")[py::int_(0)];
  exception.attr("line") = std::stoi(match[2]);
  exception.attr("column") = std::stoi(match[3]);
  raise("SceneError", exception);
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const InputError& exception) {
      raise_input_error(exception.what());
    } catch (const FileError& exception) {
      raise("FileError", made("FileError", exception.what()));
    }
  });
}

}  // namespace graze
