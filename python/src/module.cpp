// The extension module `elsie._elsie`: what the package `elsie` is made of. Users see the package.
#include "elsie/process/arithmetic.h"

#include "bindings.h"

PYBIND11_MODULE(_elsie, module) {
  using namespace elsie::python;
  module.doc() = "Elsie's libraries. Use the package `elsie`.";
  py::options options;
  options.disable_function_signatures();  // the package's own classes say them
  bind_errors(module);
  bind_worlds(module);
  bind_simulations(module);
  bind_pictures(module);
  bind_inference(module);
  module.def("has_fixed_arithmetic", &elsie::process::has_fixed_arithmetic);
  module.attr("version") = ELSIE_VERSION;
  bind_environments(module);
  options.enable_function_signatures();  // help() is the reference of plugin authors
  bind_plugins(module);
}
