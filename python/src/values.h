// Attributes of a world as values of Python.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

#include "bindings.h"

namespace elsie::python {

/// The text of a value, as in a world file: of a str, bool, int, float or a number of numpy. Throws
/// py::type_error.
std::string text_of(const py::handle& value);

/// The paths and texts of a list of (path, value).
std::vector<std::pair<std::string, std::string>> edits_of(const py::list& given);

/// The same as "PATH=VALUE".
std::vector<std::string> texts_of(const py::list& given);

/// The value of the attribute that a path leads to, its default if the file does not set it; None
/// if it has none; a list if the path leads to several. Throws base::BadInput.
py::object value_at(const world::World& world, const plugin::Host& host, const std::string& path);

}  // namespace elsie::python
