// What compilers and interpreters say about the source of a plugin.
#pragma once

#include <optional>

#include "engine/workbench.h"

namespace elsie::desktop {

/// A place in a source, as a line of a compiler's output names it.
struct CompilerLine {
  QString file;
  int line = 0;
  QString what;
  bool is_error = false;  // else a warning or a note
};

/// None: the line names no place.
std::optional<CompilerLine> compiler_line(const QString& text);

/// The errors of a message with the lines that they name; without such a line, the whole message.
/// Of a compiler's message, warnings and notes are left out.
Problems problems_in(const QString& message);

}  // namespace elsie::desktop
