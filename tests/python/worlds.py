"""Small worlds for tests."""

ARENA = """<?xml version="1.0"?>
<!-- A comment that edits keep. -->
<world format="1" name="arena">
  <arena length="4" width="4"/>
  <physics engine="planar"/>
  <obstacles>
    <static_box id="block" x="1" y="0.5"/>
  </obstacles>
  <robots>
    <robot id="r1" x="0" y="0" max_speed="0.3">
      <sensors>
        <beam_range id="left" yaw_deg="30"/>
        <beam_range id="right" yaw_deg="-30"/>
      </sensors>
      <behaviors>
        <wander priority="1"/>
        <avoid_obstacle priority="2"/>
      </behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
    <robot id="r2" x="-1" y="-1" heading_deg="90">
      <behaviors><wander/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
  </robots>
  <limits time="5"/>
</world>
"""
