#include "wheel_on_floor.h"

#include <array>
#include <cmath>

namespace elsie::physics {

void meet_floor(OdeContacts& contacts, dBodyID body, dGeomID geom, const Cylinder& wheel,
                double sinking, WheelDrive drive, dGeomID floor) {
  // The rolling radius and the track are exact when a wheel touches the floor in one point, the
  // lowest of its middle disc.
  const Vector3& axis = wheel.axis;
  const double level = std::sqrt(axis.x * axis.x + axis.y * axis.y);
  if (level > 0.99) {
    const Vector3 down = (1.0 / level) * Vector3{axis.x * axis.z, axis.y * axis.z, -level * level};
    const Vector3 lowest = wheel.center + wheel.radius * down;
    if (lowest.z > contacts.margin(sinking)) return;
    const Vector3 rolling{axis.y / level, -axis.x / level, 0.0};
    if (drive == WheelDrive::motor) {
      contacts.wheel_on_floor(body, lowest, rolling);
    } else {
      contacts.free_wheel_on_floor(body, lowest, rolling);
    }
    return;
  }
  std::array<dContactGeom, 4> found;
  const int count =
      dCollide(geom, floor, static_cast<int>(found.size()), found.data(), sizeof(dContactGeom));
  for (int k = 0; k < count; ++k) {
    contacts.between(body, nullptr, found[static_cast<std::size_t>(k)]);
  }
}

}  // namespace elsie::physics
