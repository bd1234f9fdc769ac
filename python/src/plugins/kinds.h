// How objects of each kind of plugin are made.
#pragma once

#include <memory>

#include "scripted.h"

namespace elsie::python {

std::unique_ptr<Component> make_behavior(const ScriptClassRef& of);
std::unique_ptr<Component> make_coordinator(const ScriptClassRef& of);
std::unique_ptr<Component> make_sensor(const ScriptClassRef& of);
std::unique_ptr<Component> make_actuator(const ScriptClassRef& of);
std::unique_ptr<Component> make_measure(const ScriptClassRef& of);
std::unique_ptr<Component> make_rule(const ScriptClassRef& of);

}  // namespace elsie::python
