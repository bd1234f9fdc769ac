// Whether two descriptions say the same, attribute by attribute along the vocabulary.
#pragma once

#include "elsie/world/description.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// What else than the settled attributes of an element is compared.
enum class Compared {
  all,
  settled,  // what is not live: Field::is_live()
};

/// Two objects that `spec` describes. Where they stand in files does not count.
bool same(const ElementSpec& spec, const void* a, const void* b, Compared what = Compared::all);

/// The part of this name that an element of the vocabulary has: "body" of robots.
bool same_part(const ElementSpec& spec, const char* part, const void* a, const void* b);

/// The element that describes robots.
const ElementSpec& robot_spec();
/// As far as the core knows sensors and behaviours: without the plugin's parameters, and without
/// what behaviours hold.
bool same(const SensorUse& a, const SensorUse& b, Compared what);
bool same(const BehaviorUse& a, const BehaviorUse& b, Compared what);
bool same(const PluginUse& a, const PluginUse& b);

}  // namespace elsie::world
