// The extension module `elsie._elsie`: what the package `elsie` is made of. Users see the package.
#include "bindings.h"

PYBIND11_MODULE(_elsie, module) {
  using namespace elsie::python;
  module.doc() = "Elsie's libraries. Use the package `elsie`.";
  bind_errors(module);
  bind_worlds(module);
  bind_simulations(module);
}
