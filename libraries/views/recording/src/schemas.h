// The JSON schemas of the channels, from schemas.json. Those whose names begin with "foxglove."
// have the members that Foxglove's documentation gives for them
// (https://docs.foxglove.dev/docs/sdk/schemas), so that viewers draw them; Elsie adds its own
// members. The schemas use only what viewers understand: objects with properties, arrays, and plain
// values. They do not understand references: see schema_of().
#pragma once

#include <string>

#include "format.h"

namespace elsie::recording {

/// The schema of this name, with the parts in place of references to them.
Json schema_of(const std::string& name);

}  // namespace elsie::recording
