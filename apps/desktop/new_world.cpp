#include "new_world.h"

namespace elsie::desktop {

QString new_world() {
  return QStringLiteral(R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- A robot collects four resources. Start runs it; Properties and the trees change it. -->
<world format="1" name="my world">
  <arena length="5" width="5"/>
  <obstacles>
    <static_box x="1.2" y="0"/>
    <static_box x="-1.2" y="0"/>
  </obstacles>
  <!-- Beams do not see them: otherwise the robot would avoid them, too. -->
  <resources>
    <resource x="1.4" y="1.4" seen_by_range_sensors="false"/>
    <resource x="-1.4" y="1.2" seen_by_range_sensors="false"/>
    <resource x="-1.3" y="-1.4" seen_by_range_sensors="false"/>
    <resource x="1.2" y="-1.3" seen_by_range_sensors="false"/>
  </resources>
  <robots>
    <robot id="r1" team="red" heading_deg="90">
      <sensors>
        <beam_range id="left" yaw_deg="30"/>
        <beam_range id="ahead"/>
        <beam_range id="right" yaw_deg="-30"/>
        <vision id="eye" error="0.02"/>
      </sensors>
      <behaviors>
        <avoid_obstacle/>
        <find_resource/>
      </behaviors>
      <coordinator>
        <fusion_vector_summation/>
      </coordinator>
    </robot>
  </robots>
  <goals>
    <collect/>
  </goals>
  <limits time="180"/>
</world>
)");
}

}  // namespace elsie::desktop
