#include "scripted.h"

#include <atomic>
#include <cmath>
#include <exception>
#include <stdexcept>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "elsie/base/error.h"

#include "perception.h"

namespace elsie::python {
namespace {

py::object helper(const char* name) { return py::module_::import("elsie.plugins").attr(name); }

py::object to_python(const ParameterValue& value) {
  return std::visit([](const auto& held) { return py::cast(held); }, value);
}

/// What a plugin that this one asked has thrown.
thread_local std::exception_ptr passing;

/// The object that notes that the order of hashes is random, so that it is said once.
std::atomic<const Scripted*> the_one_that_notes = nullptr;

bool has_random_hashes() { return helper("_has_random_hashes")().cast<bool>(); }

std::string text_of(py::handle value) { return py::repr(value).cast<std::string>(); }

}  // namespace

ParameterValue value_of(ParameterType type, const py::object& value) {
  switch (type) {
    case ParameterType::real:
      return value.cast<double>();
    case ParameterType::integer:
      return value.cast<std::int64_t>();
    case ParameterType::boolean:
      return value.cast<bool>();
    case ParameterType::text:
    case ParameterType::file:
      return value.cast<std::string>();
    case ParameterType::reals:
      return value.cast<std::vector<double>>();
  }
  return 0.0;
}

OwnErrors::OwnErrors(const ScriptClass& of) {
  if (of.errstate.is_none()) return;
  state_ = of.errstate();
  state_.attr("__enter__")();
}

OwnErrors::~OwnErrors() {
  if (!state_) return;
  const py::error_scope raised;  // the script's
  try {
    state_.attr("__exit__")(py::none(), py::none(), py::none());
  } catch (py::error_already_set& error) {
    error.discard_as_unraisable("the end of numpy.errstate");
  }
}

void keep_passing() { passing = std::current_exception(); }

void throw_fault(py::error_already_set& error, const std::string& file) {
  if (const std::exception_ptr through = std::exchange(passing, nullptr)) {
    if (error.matches(py::module_::import("elsie.errors").attr("PluginFault"))) {
      std::rethrow_exception(through);
    }
  }
  if (error.matches(PyExc_KeyboardInterrupt)) {
    PyErr_SetInterrupt();  // the last thing here: any call of Python would raise it
    throw base::Error("it was interrupted");
  }
  py::object raised = error.value();
  if (error.trace()) PyException_SetTraceback(raised.ptr(), error.trace().ptr());
  throw base::Error(helper("_fault")(raised, file).cast<std::string>());
}

void throw_misuse(const std::string& sentence, py::handle method, const std::string& file) {
  const int line = method ? helper("_line_of")(method).cast<int>() : 0;
  const std::string name = file.substr(file.rfind('/') + 1);
  throw base::Error(name + (line > 0 ? ":" + std::to_string(line) : "") + ": " + sentence);
}

Scripted::Scripted(ScriptClassRef of) : of_(std::move(of)) {
  run(of_->cls, [&] {
    self_ = of_->cls();
    configured_ = method("configured");
    reset_ = method("reset");
    notes_ = method("notes");
    curves_ = method("curves");
    sketch_ = method("sketch");
    // What __init__ sets is the state at the start of a run.
    if (!reset_ &&
        of_->cls.attr("__init__").ptr() !=
            py::handle(reinterpret_cast<PyObject*>(&PyBaseObject_Type)).attr("__init__").ptr()) {
      init_ = self_.attr("__init__");
    }
  });
}

Scripted::~Scripted() {
  const Scripted* own = this;
  the_one_that_notes.compare_exchange_strong(own, nullptr);
  drop({&configured_, &reset_, &init_, &notes_, &curves_, &sketch_, &self_});
}

py::object Scripted::method(const char* name) const {
  return py::getattr(self_, name, py::object());
}

void Scripted::set(const char* name, const ParameterValue& value) {
  run({}, [&] { self_.attr(name) = to_python(value); });
}

ParameterValue Scripted::get(const char* name, ParameterType type) const {
  return run({}, [&]() -> ParameterValue {
    const py::object value = self_.attr(name);
    try {
      return value_of(type, value);
    } catch (const py::cast_error&) {
      throw base::Error(std::string("the parameter '") + name + "' has become " + text_of(value) +
                        "; expected a value of the type of its default");
    }
  });
}

double Scripted::number(const char* name) const {
  return run({}, [&] {
    const py::object value = self_.attr(name);
    if (value.is_none()) return std::nan("");
    const double number = PyFloat_AsDouble(value.ptr());
    if (number == -1.0 && PyErr_Occurred()) {
      PyErr_Clear();
      throw base::Error(std::string("the published number '") + name + "' is " + text_of(value) +
                        "; expected a number, or NaN for none");
    }
    return number;
  });
}

void Scripted::configure() { call_if_there(configured_); }

void Scripted::reset_by(Random& random) {
  if (!reset_) return call_if_there(init_);
  run(reset_, [&] {
    const LentRandom lent = std::make_shared<Lent<Random>>();
    const Lending lending(*lent, random);
    reset_(lent);
  });
}

std::vector<std::string> Scripted::list_notes() const {
  return run(notes_, [&] {
    auto notes = notes_ ? notes_().cast<std::vector<std::string>>() : std::vector<std::string>();
    const Scripted* none = nullptr;
    if (has_random_hashes() &&
        (the_one_that_notes.compare_exchange_strong(none, this) || the_one_that_notes == this)) {
      notes.emplace_back(
          "Python orders sets of texts anew in each process: a plugin that loops over one may "
          "make other runs; set PYTHONHASHSEED=0 in the environment of the process");
    }
    return notes;
  });
}

std::vector<Curve> Scripted::list_curves() const {
  if (!curves_) return {};
  return run(curves_, [&] {
    std::vector<Curve> curves;
    for (const py::handle each : curves_()) {
      auto [name, x_label, y_label, points] =
          each.cast<std::tuple<std::string, std::string, std::string,
                               std::vector<std::pair<double, double>>>>();
      Curve& curve = curves.emplace_back(Curve{name, x_label, y_label, {}});
      for (const auto& [x, y] : points) curve.points.push_back({x, y});
    }
    return curves;
  });
}

void Scripted::draw(Sketch& sketch) const {
  if (!sketch_) return;
  run(sketch_, [&] {
    const auto lent = std::make_shared<Lent<Sketch>>();
    const Lending lending(*lent, sketch);
    sketch_(lent);
  });
}

void Scripted::remember_by(Memory& memory) {
  run({}, [&] {
    for (const std::string& name : of_->remembers) {
      const py::object known = py::getattr(self_, name.c_str(), py::none());
      const auto hand_over = [&](auto value) {
        memory(name, value);
        if (memory.recalls()) self_.attr(name.c_str()) = py::cast(value);
      };
      if (PyBool_Check(known.ptr())) {
        hand_over(known.cast<bool>());
      } else if (PyLong_Check(known.ptr())) {
        hand_over(known.cast<std::int64_t>());
      } else if (PyFloat_Check(known.ptr())) {
        hand_over(known.cast<double>());
      } else if (PyUnicode_Check(known.ptr())) {
        hand_over(known.cast<std::string>());
      } else if (py::isinstance<py::array>(known)) {
        std::vector<double> numbers = known.cast<std::vector<double>>();
        memory(name, numbers);
        if (memory.recalls()) {
          self_.attr(name.c_str()) =
              py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
        }
      } else if (PyList_Check(known.ptr())) {
        hand_over(known.cast<std::vector<double>>());
      } else if (!known.is_none()) {
        throw base::Error("remembers names '" + name + "', which is " + text_of(known) +
                          "; only a bool, int, float, str, or a list or row of numbers can be "
                          "remembered");
      }
    }
  });
}

}  // namespace elsie::python
