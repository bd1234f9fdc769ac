// The answer of a behaviour that has nothing to say.
#pragma once

#include <elsie/api/behavior.h>

/// Not active and without strength, so that coordinators that select or resolve pass it over. Those
/// that add up commands still get `command`.
inline elsie::Response inactive(const elsie::MotorCommand& command = {}) {
  elsie::Response response(command);
  response.activation = 0.0;
  response.strength = 0.0;
  return response;
}
