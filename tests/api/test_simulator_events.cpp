// The events of the simulator: one table, and their details as text.
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/api/simulator_events.h"

namespace elsie::test {

TEST_CASE("Every event of the simulator has a name of its own, and is found by it") {
  std::set<std::string_view> names;
  for (const events::Facts& facts : events::of_simulator()) {
    CAPTURE(facts.name);
    CHECK(names.insert(facts.name).second);
    CHECK_FALSE(facts.meaning.empty());
    CHECK(events::find(facts.name) == &facts);
  }
  CHECK(events::find("hello") == nullptr);
}

TEST_CASE("An event has a name and a detail as text") {
  using With = events::Collision::With;
  const auto text = [](const events::AnyEvent& event) {
    return std::string(events::name_of(event)) + " " + events::detail_of(event);
  };
  CHECK(text(events::Raised{"hello"}) == "hello ");
  CHECK(text(events::Collision{With::wall}) == "collision wall");
  CHECK(text(events::Collision{With::charger}) == "collision charger");
  CHECK(text(events::Collision{With::box, "b1"}) == "collision b1");
  CHECK(text(events::Collision{With::robot, "r1"}) == "collision r1");
  CHECK(text(events::Collected{"gold"}) == "collected gold");
  CHECK(text(events::BatteryEmpty{}) == "battery_empty ");
  CHECK(text(events::Changed{"robot[r1]", "x", "3"}) == "changed robot[r1]/@x=3");
  CHECK(text(events::Replaced{"sensor[eye]", "vision"}) == "replaced sensor[eye]: vision");
  CHECK(events::facts_of(events::Raised{"hello"}) == nullptr);
  CHECK(events::facts_of(events::Collected{"gold"})->name == "collected");
}

TEST_CASE("A change has the element and the attribute of its path") {
  const auto changed = events::Changed::of("robot[r1]/behavior[a]/@text", "b/@c=d");
  CHECK(changed.element == "robot[r1]/behavior[a]");
  CHECK(changed.attribute == "text");
  CHECK(changed.value == "b/@c=d");
  CHECK(changed.detail() == "robot[r1]/behavior[a]/@text=b/@c=d");
  const auto of_world = events::Changed::of("@name", "maze");
  CHECK(of_world.element.empty());
  CHECK(of_world.detail() == "@name=maze");
  const auto element = events::Changed::of("robot[r1]/coordinator", "<pick id=\"@c\"/>");
  CHECK(element.element == "robot[r1]/coordinator");
  CHECK(element.attribute.empty());
  CHECK(element.detail() == "robot[r1]/coordinator=<pick id=\"@c\"/>");
  CHECK(events::Changed{"robot[r1]", "x", "3"}.moves_robot());
  CHECK(events::Changed{"robot[r1]", "", "<robot x=\"3\"/>"}.moves_robot());
  CHECK_FALSE(events::Changed{"robot[r1]/drive", "", "<car/>"}.moves_robot());
  CHECK_FALSE(events::Changed{"robot[r1]", "heading_deg", "3"}.moves_robot());
  CHECK_FALSE(events::Changed{"robot[r1]/sensor[a]", "x", "3"}.moves_robot());
}

}  // namespace elsie::test
