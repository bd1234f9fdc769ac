// Tables of the reference pages.
#pragma once

#include <initializer_list>
#include <string>

#include "elsie/world/vocabulary.h"

namespace elsie::reference {

/// The text of a cell, with Markdown's characters escaped.
std::string cell(const std::string& text);

/// "| a | b |" and a line break.
std::string table_row(std::initializer_list<std::string> texts);

/// A field's default: "required", or "" when there is none.
std::string default_text(const world::Field& field);

}  // namespace elsie::reference
