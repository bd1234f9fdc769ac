// The interpreter's lock, for calls from C++ into a script, from any thread.
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>

#include <pybind11/pybind11.h>

namespace elsie::python {

namespace py = pybind11;

/// Has the lock while it lives. Unlike pybind11's, it makes no assumption about the thread.
class Gil {
 public:
  Gil() : state_(PyGILState_Ensure()) {}
  ~Gil() { PyGILState_Release(state_); }
  Gil(const Gil&) = delete;
  Gil& operator=(const Gil&) = delete;

 private:
  PyGILState_STATE state_;
};

/// Something that holds objects of Python and is destroyed without the lock. It is left alone when
/// the interpreter has ended.
template <class Held>
std::shared_ptr<Held> locked_at_end(Held&& held) {
  return {new Held(std::move(held)), [](Held* old) {
            if (Py_IsInitialized() == 0) return;
            const Gil gil;
            delete old;
          }};
}

/// Lets go of objects, without the lock held. They are left alone when the interpreter has ended.
inline void drop(std::initializer_list<py::object*> objects) {
  if (Py_IsInitialized() == 0) {
    for (py::object* const each : objects) each->release();
    return;
  }
  const Gil gil;
  for (py::object* const each : objects) *each = py::object();
}

}  // namespace elsie::python
