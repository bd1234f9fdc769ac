// What compilers and interpreters say about the source of a plugin.
#pragma once

#include "engine/workbench.h"

namespace elsie::desktop {

/// The errors of a message with the lines that they name; without such a line, the whole message.
/// Of a compiler's message, warnings and notes are left out.
Problems problems_in(const QString& message);

}  // namespace elsie::desktop
