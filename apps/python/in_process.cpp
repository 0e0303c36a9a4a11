#include "in_process.hpp"

#include <exception>
#include <optional>

#include "program.hpp"
#include "work_thread.hpp"

namespace graze {
namespace {

namespace py = pybind11;

}  // namespace

std::shared_ptr<FoundResult> run_in_process(Command command, const py::object& progress) {
  const auto found = std::make_shared<FoundResult>();
  std::visit([&](CommonOptions& common) { common.caller = found.get(); }, command);
  std::optional<py::error_already_set> raised;
  std::exception_ptr error;
  {
    const py::gil_scoped_release release;
    do_beside(
        [&] {
          try {
            run_command(command);
          } catch (...) {
            error = std::current_exception();
          }
        },
        [&] {
          const py::gil_scoped_acquire lock;
          try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (!progress.is_none()) progress(found->progress());
          } catch (py::error_already_set& exception) {
            raised.emplace(std::move(exception));
            found->stop();
          }
        });
  }
  if (raised) {
    // Some exceptions take no attributes; they are raised all the same.
    if (found->record() &&
        PyObject_SetAttrString(raised->value().ptr(), "result", py::cast(found).ptr()) != 0)
      PyErr_Clear();
    throw std::move(*raised);
  }
  if (error) std::rethrow_exception(error);
  if (!progress.is_none()) progress(1.0);
  return found;
}

}  // namespace graze
