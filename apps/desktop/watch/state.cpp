#include "watch/state.h"

namespace elsie::desktop {

const Json& robot_of(const Json& state, const QString& id) {
  static const Json none;
  for (const Json& robot : member(state, "robots")) {
    if (text_of(robot, "id") == id) {
      return robot;
    }
  }
  return none;
}

}  // namespace elsie::desktop
