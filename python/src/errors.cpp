// Errors of Elsie as exceptions of Python.
#include <exception>
#include <stdexcept>
#include <string>

#include "elsie/base/error.h"
#include "elsie/base/problems.h"
#include "elsie/fuzzy/error.h"
#include "elsie/neural/error.h"
#include "elsie/plugin/error.h"
#include "elsie/simulation/edit.h"
#include "elsie/simulation/fault.h"
#include "elsie/world/error.h"

#include "bindings.h"

namespace elsie::python {
namespace {

py::object made(const char* type, const std::string& sentence, int exit_code) {
  py::object error = py::module_::import("elsie.errors").attr(type)(sentence);
  error.attr("exit_code") = exit_code;
  return error;
}

void raise(const py::object& error) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

const char* type_of(const base::Error& error) {
  if (dynamic_cast<const simulation::PluginFault*>(&error)) return "PluginFault";
  if (dynamic_cast<const simulation::PhysicsFault*>(&error)) return "PhysicsFault";
  if (dynamic_cast<const plugin::PluginError*>(&error)) return "PluginError";
  if (dynamic_cast<const world::WorldError*>(&error)) return "WorldError";
  if (dynamic_cast<const base::FileError*>(&error)) return "ModelError";
  return error.exit_code() == base::kBadInput ? "InputError" : "Error";
}

void translate(const base::Error& error) {
  const py::object made_of_it = made(type_of(error), error.what(), error.exit_code());
  if (const auto* const file = dynamic_cast<const base::FileError*>(&error)) {
    const py::object problem = py::module_::import("elsie.errors").attr("Problem");
    py::list problems;
    for (const base::Problem& each : file->problems()) {
      problems.append(problem(each.file, each.line, each.message));
    }
    made_of_it.attr("problems") = py::tuple(problems);
  }
  if (const auto* const fault = dynamic_cast<const simulation::PluginFault*>(&error)) {
    made_of_it.attr("plugin") = fault->plugin;
    made_of_it.attr("id") = fault->id;
    made_of_it.attr("robot") = fault->robot;
    made_of_it.attr("step") = fault->step;
    made_of_it.attr("place") = fault->place;
  }
  if (const auto* const fault = dynamic_cast<const simulation::PhysicsFault*>(&error)) {
    made_of_it.attr("robot") = fault->robot;
    made_of_it.attr("step") = fault->step;
  }
  raise(made_of_it);
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const base::Error& error) {
      // Ctrl+C in a plugin ended the run: that is what the user did.
      if (PyErr_CheckSignals() != 0) return;
      translate(error);
    } catch (const simulation::EditRefused& error) {
      raise(made("EditRefused", error.what(), base::kBadInput));
    } catch (const std::invalid_argument& error) {
      raise(made("InputError", error.what(), base::kBadInput));
    }
  });
}

}  // namespace elsie::python
