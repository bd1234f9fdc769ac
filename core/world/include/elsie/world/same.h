// Whether two descriptions say the same, attribute by attribute along the vocabulary.
#pragma once

#include "elsie/world/description.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Two objects that `spec` describes, as far as a difference costs so much or more. Where they
/// stand in files does not count.
bool same(const ElementSpec& spec, const void* a, const void* b, Cost least = Cost::nothing);

/// The part of this name that an element of the vocabulary has: "body" of robots.
bool same_part(const ElementSpec& spec, const char* part, const void* a, const void* b);

bool same(const Box& a, const Box& b, Cost least);
/// As far as the core knows sensors and behaviours: without the plugin's parameters, and without
/// what behaviours hold.
bool same(const SensorUse& a, const SensorUse& b, Cost least);
bool same(const BehaviorUse& a, const BehaviorUse& b, Cost least);
bool same(const PluginUse& a, const PluginUse& b);

}  // namespace elsie::world
