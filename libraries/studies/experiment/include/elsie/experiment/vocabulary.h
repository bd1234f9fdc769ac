// The vocabulary of experiment files, in the terms of that of worlds.
#pragma once

#include <string>

#include "elsie/world/vocabulary.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::experiment {

/// The version of the vocabulary: the attribute `format` of a file.
inline constexpr int kFormat = 1;

/// <experiment> with all that it may hold. Its objects are the reader's own.
const world::ElementSpec& vocabulary();

/// XSD 1.0 for experiment files, made of the vocabularies of experiments and worlds and of the
/// declarations of the plugins that the host has: an editor completes and checks the plugins'
/// elements that are set, too.
std::string experiment_schema(const plugin::Host& host);

/// The vocabulary in Markdown: every element with its attributes, and what is measured.
std::string experiment_reference();

}  // namespace elsie::experiment
