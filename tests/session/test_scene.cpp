// What the window is told of what sensors look at.
#include <cmath>

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

TEST_CASE("A scene says what each camera sees, from the body that carries it") {
  test::Session session;
  const test::Json views = session.open(kSeeing)["scene"]["views"];
  REQUIRE(views.size() == 1);
  CHECK(views[0]["body"] == 1);
  CHECK(views[0]["sensor"] == "eye");
  CHECK(views[0]["width"] == 60);
  CHECK(views[0]["height"] == 30);
  CHECK(views[0]["fov_rad"].get<double>() == Approx(40.0 * M_PI / 180.0));
  const test::Json forward = views[0]["frame"][1];
  CHECK(forward[0].get<double>() == Approx(0.0).margin(1e-12));
  CHECK(forward[1].get<double>() == Approx(1.0));
}

TEST_CASE("A snapshot has the edges of what a proximity sensor watches") {
  test::Session session;
  session.open(kSeeing);
  session.ask({{"do", "step"}});
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  REQUIRE(snapshot->beams.size() == 8);
  const double half = 0.5 * std::tan(20.0 * M_PI / 180.0);
  double widest = 0.0;
  for (const snapshots::BeamState& edge : snapshot->beams) {
    CHECK(edge.robot == 1);
    CHECK(edge.hit == 1);
    widest = std::max(widest, std::abs(static_cast<double>(edge.to[1])));
  }
  CHECK(widest == Approx(half).epsilon(1e-4));
}

TEST_CASE("A scene has the floor, patches in their own frames, and lamps") {
  test::Session session;
  const test::Json scene = session.open(R"(<world format="1">
  <lamps><lamp id="sun" x="1" z="0.7"/></lamps>
  <floor colour="#102030"/>
  <patches>
    <disc_patch id="spot" x="1" y="2" radius="0.5" colour="#00ff00"/>
    <line_patch id="track" y="1" heading_deg="90"><point x="0" y="0"/><point x="1" y="0"/></line_patch>
  </patches>
</world>)")["scene"];
  CHECK(scene["floor"] == test::Json({{"colour", {0x10, 0x20, 0x30}}}));
  const test::Json& shapes = scene["shapes"];
  CHECK(shapes[0]["path"] == "patch[spot]");
  CHECK(shapes[0]["colour"] == test::Json({0, 255, 0}));
  CHECK(shapes[0]["frame"][0] == test::Json({1.0, 2.0, 0.0}));
  CHECK(shapes[0]["size"][0].get<double>() == Approx(1.0));
  CHECK(shapes[0]["size"][2] == 0.0);
  for (int piece = 1; piece <= 3; ++piece) {
    CHECK(shapes[piece]["path"] == "patch[track]");
    CHECK(shapes[piece]["frame"][0] == test::Json({0.0, 1.0, 0.0}));
    CHECK(shapes[piece]["frame"][1][1].get<double>() == Approx(1.0));
  }
  CHECK(shapes[4]["path"] == "lamp[sun]");
  CHECK(shapes[4]["shape"] == "sphere");
  CHECK(shapes[4]["frame"][0] == test::Json({1.0, 0.0, 0.7}));
}
