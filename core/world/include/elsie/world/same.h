// Compares two descriptions attribute by attribute, as the vocabulary lists them.
#pragma once

#include "elsie/world/description.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Whether two objects that `spec` describes are equal. Only differences with at least this cost
/// count; locations in files do not.
bool same(const ElementSpec& spec, const void* a, const void* b, Cost least = Cost::nothing);

/// The same for the part of two objects that the child element `part` describes: "body" of robots.
bool same_part(const ElementSpec& spec, const char* part, const void* a, const void* b);

bool same(const Obstacle& a, const Obstacle& b, Cost least);
/// The same for the core's attributes of sensors and behaviours: without the plugin's parameters,
/// and without behaviours inside of behaviours.
bool same(const MountedUse& a, const MountedUse& b, Cost least);
bool same(const BehaviorUse& a, const BehaviorUse& b, Cost least);
bool same(const PluginUse& a, const PluginUse& b);

}  // namespace elsie::world
