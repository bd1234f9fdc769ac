// The colours of a graph's nodes, in drawings of it and over time.
#pragma once

#include "elsie/api/graph.h"

#include "colour.h"

namespace elsie::picture {

/// A node that holds others has paler colours.
constexpr Ink node_ink(NodeState state, bool is_frame = false) {
  switch (state) {
    case NodeState::running:
      return is_frame ? hex(0xfff4d1, "within") : hex(0xffd966, "running");
    case NodeState::success:
      return hex(0xb6d7a8, "success");
    case NodeState::failure:
      return hex(0xf4b6ae, "failure");
    case NodeState::dark:
      break;
  }
  return hex(is_frame ? 0xf2f2f2 : 0xfafafa, "panel");
}

}  // namespace elsie::picture
