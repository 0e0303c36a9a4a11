// graze._core: what the Python package is made of. Its own functions are written for the package,
// not for people; those stand in apps/python/graze.
#include <pybind11/pybind11.h>

#include "bindings.hpp"
#include "graze/record/file/run_info.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "Compiled part of graze; use the package graze.";
  module.attr("version") = graze::version();
  graze::bind_errors(module);
  graze::bind_scenes(module);
  graze::bind_results(module);
  graze::bind_commands(module);
  graze::bind_continuation(module);
}
