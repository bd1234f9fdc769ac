// The base of all plugin objects that a script implements.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "elsie/api/component.h"
#include "elsie/api/declaration.h"
#include "elsie/api/remember.h"

#include "gil.h"
#include "lent.h"

namespace elsie::python {

namespace py = pybind11;

/// A class of a script that is a plugin. Objects of C++ share it.
struct ScriptClass {
  std::string file;
  py::object cls;
  py::object declared;  // the dict of elsie.plugins
  py::object errstate;  // makes numpy.errstate as the script has set it; None: it has not
  std::vector<std::string> remembers;
};
using ScriptClassRef = std::shared_ptr<const ScriptClass>;

/// The value of a parameter. Throws py::cast_error for one of another type.
ParameterValue value_of(ParameterType type, const py::object& value);

/// While it lives, numpy does about errors what the script has said (numpy.seterr).
class OwnErrors {
 public:
  explicit OwnErrors(const ScriptClass& of);
  ~OwnErrors();
  OwnErrors(const OwnErrors&) = delete;
  OwnErrors& operator=(const OwnErrors&) = delete;

 private:
  py::object state_;
};

/// Call it in a catch block: what is handled goes through the script, and on as it is, if it is a
/// fault of another plugin that the script has asked.
void keep_passing();
/// Throws what a script raised as base::Error, with its line. Call it with the lock. Ctrl+C in a
/// process of Python is raised again when that gets to run.
[[noreturn]] void throw_fault(py::error_already_set& error, const std::string& file);
/// The same for a sentence about what a method answered, with the line at which the method begins.
[[noreturn]] void throw_misuse(const std::string& sentence, py::handle method,
                               const std::string& file);

/// The object of Python behind one of C++.
class Scripted {
 public:
  explicit Scripted(ScriptClassRef of);
  Scripted(const Scripted&) = delete;
  Scripted& operator=(const Scripted&) = delete;

  /// Parameters and published numbers. These take the lock.
  void set(const char* name, const ParameterValue& value);
  ParameterValue get(const char* name, ParameterType type) const;
  double number(const char* name) const;

 protected:
  ~Scripted();

  /// The bound method; null: the class has none.
  py::object method(const char* name) const;
  /// Runs with the lock; what the script raises becomes base::Error. `method`: for its line.
  template <class Action>
  auto run(py::handle method, Action&& action) const {
    const Gil gil;
    try {
      const OwnErrors errors(*of_);
      return action();
    } catch (py::error_already_set& error) {
      throw_fault(error, of_->file);
    } catch (const py::cast_error&) {
      throw_misuse(
          "it gives a value of another type than expected; help(elsie.Behavior), and that of the "
          "other kinds, says what each method answers",
          method, of_->file);
    } catch (const std::exception& error) {
      throw_misuse(error.what(), method, of_->file);
    }
  }
  /// Calls a method if the class has it.
  template <class... Arguments>
  void call_if_there(const py::object& method, Arguments&&... arguments) const {
    if (!method) return;
    run(method, [&] { method(std::forward<Arguments>(arguments)...); });
  }

  void configure();
  void reset_by(Random& random);
  std::vector<std::string> list_notes() const;
  std::vector<Curve> list_curves() const;
  void draw(Sketch& sketch) const;
  void remember_by(Memory& memory);

  const ScriptClass& of() const { return *of_; }
  const py::object& self() const { return self_; }

 private:
  ScriptClassRef of_;
  py::object self_;
  py::object configured_, reset_, init_, notes_, curves_, sketch_;
};

/// An object of one kind of plugin. `Base`: Behavior, ...
template <class Base>
class ScriptedPlugin : public Base, public Scripted {
 public:
  using Scripted::Scripted;

  void configured() override { configure(); }
  void reset(Random& random) override { reset_by(random); }
  std::vector<std::string> notes() const override { return list_notes(); }
  std::vector<Curve> curves() const override { return list_curves(); }
  void sketch(Sketch& sketch) const override { draw(sketch); }
};

/// The same for a class that names what it remembers.
template <class Plugin>
class WithMemory final : public Plugin, public Remembers {
 public:
  using Plugin::Plugin;
  void remember(Memory& memory) override { this->remember_by(memory); }
};

template <class Plugin>
std::unique_ptr<Component> make_scripted(const ScriptClassRef& of) {
  const Gil gil;
  if (of->remembers.empty()) return std::make_unique<Plugin>(of);
  return std::make_unique<WithMemory<Plugin>>(of);
}

}  // namespace elsie::python
