// A world in which much happens, to be edited, and small ones.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "elsie/world/reader.h"

#include "change_support.h"

namespace elsie::test {

/// Three robots that wander, a box that can be pushed, one that moves, a resource and a mast.
inline const std::string kLively = R"(<world format="1">
  <arena length="6" width="6"/>
  <obstacles>
    <static_box id="mast" x="-2.5" y="2.5"/>
    <dynamic_box id="crate" x="2.5" y="2.5"/>
    <moving_box id="cart" x="-2.5" y="-2.5" speed="0.1"><waypoint x="-1.5" y="-2.5"/></moving_box>
  </obstacles>
  <resources><resource id="food" x="2.5" y="-2.5"/></resources>
  <robots>
    <robot id="r1" x="-1" leader="true"><sensors><beam_range id="ahead" error="0.05"/></sensors>
      <behaviors><wander restlessness="3"/><wander id="rest" priority="0.1"/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator></robot>
    <robot id="r2" x="0" y="1" heading_deg="90"><sensors><beam_range id="ahead"/></sensors>
      <behaviors><wander restlessness="3"/></behaviors>
      <coordinator><arbiter_suppression/></coordinator></robot>
    <robot id="r3" x="1" heading_deg="-90"><behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator></robot>
  </robots>
  <goals><reach robot="r1" x="2.9" y="2.9" radius="0.01"/></goals>
  <measures><path_length/></measures>
  <limits time="6"/>
</world>)";

inline world::World lively() { return world::parse_world(kLively, "lively.xml", shipped()); }

/// A world with this in it, and a robot "r1" that stands.
inline Simulation of(const std::string& content, const std::string& robot = "",
                     const simulation::Options& options = {}) {
  return Simulation(world::parse_world("<world format=\"1\"><robots><robot id=\"r1\">" + robot +
                                           "</robot></robots>" + content + "</world>",
                                       "small.xml", shipped()),
                    shipped(), options);
}

/// Why a world is refused; "" if it is not.
template <class Make>
std::string why_no_world(Make make) {
  try {
    make();
  } catch (const world::WorldError& refused) {
    return refused.what();
  }
  return "";
}

inline std::string refusal(Simulation& simulation, const std::string& path,
                           const std::string& value) {
  return why_not([&] { simulation.edit(path, value); });
}

inline std::uint64_t hash_after(int steps,
                                const std::vector<std::pair<int, simulation::Edit>>& edits) {
  Simulation simulation(lively(), shipped(), {7});
  for (int step = 0; step < steps; ++step) {
    for (const auto& [when, edit] : edits) {
      if (when == step) {
        simulation.edit(edit.path, edit.value);
      }
    }
    simulation.step();
  }
  return simulation.state_hash();
}

}  // namespace elsie::test
