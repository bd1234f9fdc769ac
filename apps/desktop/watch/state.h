// Reads the `state` events of a session.
#pragma once

#include <QString>
#include <limits>

#include <nlohmann/json.hpp>

namespace elsie::desktop {

using Json = nlohmann::ordered_json;

/// The member of this name, or null.
const Json& member(const Json& object, const char* name);
QString text_of(const Json& object, const char* name);
/// NaN if there is none, or it is null: such numbers were not finite.
double number_of(const Json& object, const char* name);
/// The robot of a state, or null.
const Json& robot_of(const Json& state, const QString& id);

}  // namespace elsie::desktop
