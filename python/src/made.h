// Objects of Python that were never made.
//
// `elsie.World.__new__(elsie.World)`, and so copy.copy() and pickle, give an object whose
// constructor has not run. pybind11 then allocates memory for it at the first call, by the class's
// own operator new, and passes it on as if there were an object in it. Classes that derive from
// Made refuse that.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "bindings.h"

namespace elsie::python {

class Made {
 public:
  static void* operator new(std::size_t) {
    throw py::type_error("this object was never made: call its class, as in elsie.World(...)");
  }

 protected:
  Made() = default;
  ~Made() = default;
};

/// Makes an object of a class that derives from Made.
template <class Object, class... Arguments>
std::unique_ptr<Object> made(Arguments&&... arguments) {
  return std::unique_ptr<Object>(::new Object(std::forward<Arguments>(arguments)...));
}

}  // namespace elsie::python
