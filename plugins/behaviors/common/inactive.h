// The response of an inactive behaviour.
#pragma once

#include <elsie/api/behavior.h>

/// Not active and without strength, so that coordinators that select or resolve ignore it. Those
/// that add commands still use `command`.
inline elsie::Response inactive(const elsie::Motion& command = {}) {
  elsie::Response response(command);
  response.activation = 0.0;
  response.strength = 0.0;
  return response;
}
