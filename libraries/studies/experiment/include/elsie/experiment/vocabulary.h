// The vocabulary of experiment files, built like that of worlds.
#pragma once

#include <string>

#include "elsie/world/vocabulary.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::experiment {

/// The version of the vocabulary: the attribute `format` of a file.
inline constexpr int kFormat = 1;

/// The element <experiment> with all its contents. Its objects are private to the reader.
const world::ElementSpec& vocabulary();

/// XSD 1.0 for experiment files, from the vocabularies of experiments and worlds and the
/// declarations of the host's plugins, so that editors also complete and check the plugins'
/// elements in settings.
std::string experiment_schema(const plugin::Host& host);

/// The vocabulary in Markdown: every element with its attributes, and the measures of every run.
std::string experiment_reference();

}  // namespace elsie::experiment
