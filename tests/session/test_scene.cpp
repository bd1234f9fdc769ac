// What the window is told of what sensors look at.
#include <cmath>
#include <map>
#include <string>

#include "session.h"

using namespace elsie;

namespace {

constexpr const char* kSeeing = R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="r0" x="1"><behaviors><turn_left/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
    <robot id="r1" x="-1">
      <sensors>
        <vision id="eye" yaw_deg="90" fov_deg="40" width="60" height="30"/>
        <proximity id="skin" yaw_deg="0" horizontal_fov_deg="40" vertical_fov_deg="10" max_range="0.5"/>
      </sensors>
      <behaviors><turn_left/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <obstacles><static_box id="b1" x="-0.6" length="0.2" width="0.2" height="0.3"/></obstacles>
</world>
)";

}  // namespace

TEST_CASE("A snapshot has what plugins draw: the edges of what sensors watch") {
  test::Session session;
  session.open(kSeeing);
  session.ask({{"do", "step"}});
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  CHECK(snapshot->facts.left_out == 0);
  REQUIRE(snapshot->marks.size() == 16);
  double widest = 0.0, highest = 0.0;
  for (std::size_t i = 0; i < snapshot->marks.size(); ++i) {
    const snapshots::MarkState& edge = snapshot->marks[i];
    CHECK(edge.kind == Sketch::Kind::line);
    CHECK(edge.role == (i < 8 ? SketchRole::range : SketchRole::hit));
    if (i < 8) {
      highest = std::max(highest, edge.end().y);  // the camera looks to the left
    } else {
      widest = std::max(widest, std::abs(edge.end().y));
    }
  }
  CHECK(highest > 0.25);
  CHECK(widest == Approx(0.5 * std::tan(20.0 * M_PI / 180.0)).epsilon(1e-4));
}

TEST_CASE("A snapshot has the outline of a robot where it believes to be") {
  test::Session session;
  session.open(R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1" x="1"><localisation><exact/></localisation><behaviors><turn_left/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
    <robot id="r2" x="-1"><behaviors><turn_left/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
  </robots>
</world>)");
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  REQUIRE(snapshot->marks.size() == 5);  // four edges, and a line ahead
  for (const snapshots::MarkState& mark : snapshot->marks) {
    CHECK(mark.role == SketchRole::belief);
    CHECK(mark.begin().x == Approx(1.0).margin(0.2));
  }
}

TEST_CASE("A scene has the floor, nests, patches in their own frames, and lamps") {
  test::Session session;
  const test::Json scene = session.open(R"(<world format="1">
  <lamps><lamp id="sun" x="1" z="0.7"/></lamps>
  <nests><nest id="home" x="-2" y="1" radius="0.4" colour="#aabbcc"/></nests>
  <floor colour="#102030"/>
  <patches>
    <disc_patch id="spot" x="1" y="2" radius="0.5" colour="#00ff00"/>
    <line_patch id="track" y="1" heading_deg="90"><point x="0" y="0"/><point x="1" y="0"/></line_patch>
  </patches>
</world>)")["scene"];
  CHECK(scene["floor"] == test::Json({{"colour", {0x10, 0x20, 0x30}}}));
  const test::Json& shapes = scene["shapes"];
  CHECK(shapes[0]["path"] == "nest[home]");
  CHECK(shapes[0]["colour"] == test::Json({0xaa, 0xbb, 0xcc}));
  CHECK(shapes[0]["frame"][0] == test::Json({-2.0, 1.0, 0.0}));
  CHECK(shapes[0]["size"][0].get<double>() == Approx(0.8));
  CHECK(shapes[1]["path"] == "patch[spot]");
  CHECK(shapes[1]["colour"] == test::Json({0, 255, 0}));
  CHECK(shapes[1]["frame"][0] == test::Json({1.0, 2.0, 0.0}));
  CHECK(shapes[1]["size"][0].get<double>() == Approx(1.0));
  CHECK(shapes[1]["size"][2] == 0.0);
  for (int piece = 2; piece <= 4; ++piece) {
    CHECK(shapes[piece]["path"] == "patch[track]");
    CHECK(shapes[piece]["frame"][0] == test::Json({0.0, 1.0, 0.0}));
    CHECK(shapes[piece]["frame"][1][1].get<double>() == Approx(1.0));
  }
  CHECK(shapes[5]["path"] == "lamp[sun]");
  CHECK(shapes[5]["shape"] == "sphere");
  CHECK(shapes[5]["frame"][0] == test::Json({1.0, 0.0, 0.7}));
}

TEST_CASE("A scene says what is a wheel or a wall, where goals are, and where sensors look") {
  test::Session session;
  const test::Json scene = session.open(R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1" x="-1">
      <sensors><beam_range id="left" x="0.1" y="0.05" z="0.1" yaw_deg="90"/></sensors>
      <behaviors><turn_left/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
    <robot id="r2" x="1"><behaviors><turn_left/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
  </robots>
  <goals>
    <any><reach robot="r1" x="1" y="0.5" radius="0.3"/><reach robot="r1" of="r2" x="0.4" y="0" radius="0.2"/></any>
  </goals>
</world>)")["scene"];
  std::map<std::string, int> roles;
  for (const auto& shape : scene["shapes"]) ++roles[shape.value("role", "")];
  CHECK(roles["wall"] == 4);
  CHECK(roles["chassis"] == 2);
  CHECK(roles["wheel"] == 4);
  CHECK(scene["bodies"][0]["coverage"] == 0.5);
  REQUIRE(scene["goals"].size() == 2);
  CHECK(scene["goals"][0] ==
        test::Json{{"at", {1.0, 0.5}}, {"radius", 0.3}, {"body", -1}, {"whose", "r1"}});
  CHECK(scene["goals"][1]["body"] == 1);
  REQUIRE(scene["sensors"].size() == 1);
  const auto& sensor = scene["sensors"][0];
  CHECK(sensor["path"] == "robot[r1]/sensor[left]");
  CHECK(sensor["body"] == 0);
  CHECK(sensor["frame"][0][0] == 0.1);
  CHECK(sensor["frame"][1][1].get<double>() == Approx(1.0));
}
