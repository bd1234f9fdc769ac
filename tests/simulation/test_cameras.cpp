// Cameras in worlds that run.
#include <thread>

#include <catch2/catch.hpp>

#include "elsie/render/renderer.h"
#include "elsie/render/world_cameras.h"
#include "elsie/render/world_scene.h"
#include "elsie/world/colours.h"
#include "elsie/world/error.h"

#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;
using simulation::Simulation;

namespace {

world::MountedUse camera(const std::string& id, double yaw_deg = 0.0, Parameters parameters = {}) {
  world::MountedUse use;
  use.plugin = "vision";
  use.id = id;
  use.yaw_deg = yaw_deg;
  use.parameters = std::move(parameters);
  return use;
}

world::Obstacle resource(const std::string& id, double x, double y,
                         const std::string& team = "red") {
  world::Obstacle made = box(id, world::ObstacleKind::resource, x, y);
  made.team = team;
  return made;
}

/// A robot with a camera, and what it may meet.
world::World world_with(std::vector<world::Obstacle> obstacles) {
  world::World world;
  world.teams = {{"red", world::kRedTeam}, {"blue", world::kBlueTeam}};
  world.obstacles = std::move(obstacles);
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted"))};
  world.robots[0].sensors = {camera("eye")};
  world.limits.time = 100;
  return world;
}

ScriptedHost driving(double rate) {
  return ScriptedHost([rate](const Perception&) { return wheels(rate, rate); });
}

const VisionReading& reading(const Simulation& simulation, std::size_t robot = 0,
                             std::size_t sensor = 0) {
  return *static_cast<const VisionReading*>(simulation.sensor(robot, sensor).sensor->reading());
}

/// Where elsie::Camera says that a point of the floor plan is seen from a sensor's frame.
double column_of(const Frame& sensor, double x, double y) {
  const Vector3 d = Vector3{x, y, sensor.origin.z} - sensor.origin;
  return 50.0 - 50.0 / std::tan(radians(15)) * dot(d, sensor.left) / dot(d, sensor.forward);
}

}  // namespace

TEST_CASE("A robot sees a resource where the pinhole model says, while it drives past") {
  const ScriptedHost host = driving(5.0);
  auto world = world_with({resource("food", 3.0, 0.35)});
  world.obstacles[0].length = world.obstacles[0].width = 0.05;
  Simulation simulation(world, host.host, {.cameras = render::world_cameras});
  for (int i = 0; i < 120; ++i) {
    const Frame eye = simulation.sensor_frame(0, 0);  // where it is when the picture is taken
    simulation.step();
    CAPTURE(i);
    REQUIRE(reading(simulation).found);
    CHECK(std::abs(reading(simulation).column - column_of(eye, 3.0, 0.35)) <= 1.0);
  }
  CHECK(reading(simulation).column < 35);  // it has come nearer
}

TEST_CASE("What a camera sees is the world as it is at that instant, without its own robot") {
  const ScriptedHost host = driving(16.0);
  auto world =
      world_with({resource("food", 2.0, 0.5), box("wall", world::ObstacleKind::fixed, 2, -0.5),
                  box("crate", world::ObstacleKind::dynamic, 0.4, 0.0),
                  box("cart", world::ObstacleKind::moving, 1.5, 1.0)});
  world.obstacles[2].mass = 0.02;
  world.obstacles[2].length = world.obstacles[2].width = world.obstacles[2].height = 0.1;
  world.obstacles[3].waypoints = {{1.5, -1.0}};
  world.robots.push_back(robot("r2", 1.0, 0.3, 180, behavior("scripted")));
  world.robots[0].sensors.push_back(camera("wide", 20.0, {{"fov_deg", 80.0}}));
  world.robots[1].sensors = {camera("eye")};
  Simulation simulation(world, host.host, {.cameras = render::world_cameras});
  advance(simulation, 150);
  // The same picture, put together by hand from what can be asked of the simulation.
  render::WorldScene scene(world);
  const Frame eye = simulation.sensor_frame(0, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const Pose& pose = simulation.robot(i).pose;
    scene.place_robot(i, Frame::turned({pose.x, pose.y, 0.0}, pose.heading_rad, 0.0));
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    const Pose pose = *simulation.obstacle(i);
    scene.place_box(i, Frame::turned({pose.x, pose.y, 0.0}, pose.heading_rad, 0.0));
  }
  simulation.step();
  Image expected;
  Image* place[] = {&expected};
  const render::View view{eye, {100, 100, radians(80)}, 0};
  render::Renderer().render(scene.scene(), std::span(&view, 1), place);
  const Image& seen = reading(simulation, 0, 1).raw;
  REQUIRE(seen.bytes.size() == expected.bytes.size());
  // Robots sink and tilt by hairs, which the plan does not say.
  int different = 0;
  for (std::size_t i = 0; i < seen.bytes.size(); i += 3) {
    different += std::abs(seen.bytes[i] - expected.bytes[i]) > 1;
  }
  CHECK(different < 60);
  CHECK(simulation.obstacle(2)->x > 0.45);  // the crate was pushed
  // Each sensor has its own picture.
  CHECK(reading(simulation, 0, 0).raw.bytes != seen.bytes);
  CHECK(reading(simulation, 1, 0).raw.bytes != reading(simulation, 0, 0).raw.bytes);
  CHECK(simulation.sensor(0, 1).picture->bytes == seen.bytes);
}

TEST_CASE("A camera sees what other robots pull where it is") {
  const ScriptedHost host = driving(10.0);
  auto world = world_with({});
  world.robots.push_back(robot("train", 0.6, 0.0, 90, behavior("scripted")));
  world.robots[0].behaviors.clear();
  world.robots[0].coordinator.reset();
  const auto width_of_dark = [&world, &host](std::size_t segments) {
    world.robots[1].segments.resize(segments);
    Simulation simulation(world, host.host, {.cameras = render::world_cameras});
    advance(simulation, 30);
    // Tyres are the darkest thing in the picture.
    const Image& picture = reading(simulation).raw;
    int left = picture.width, right = 0;
    for (int row = 0; row < picture.height; ++row) {
      for (int column = 0; column < picture.width; ++column) {
        if (*picture.pixel(column, row) < 30) {
          left = std::min(left, column);
          right = std::max(right, column);
        }
      }
    }
    return right - left;
  };
  // The robot drives to the left; its segments follow on the right.
  const int alone = width_of_dark(0);
  CHECK(alone > 5);
  CHECK(width_of_dark(1) > alone + 20);
}

TEST_CASE("A collected resource is seen no more, and is back after a reset") {
  const ScriptedHost host = driving(20.0);
  Simulation simulation(world_with({resource("food", 0.5, 0.0)}), host.host,
                        {.cameras = render::world_cameras});
  simulation.step();
  CHECK(reading(simulation).found);
  for (int i = 0; i < 300 && simulation.obstacle(0); ++i) {
    simulation.step();
  }
  REQUIRE_FALSE(simulation.obstacle(0));
  simulation.step();
  CHECK_FALSE(reading(simulation).found);
  simulation.reset();
  CHECK_FALSE(simulation.sensor(0, 0).picture);  // none taken yet
  simulation.step();
  CHECK(reading(simulation).found);
}

TEST_CASE("A robot looks for the resources that it may collect, by their colours") {
  const ScriptedHost host = driving(0.0);
  const auto finds = [&](const world::Obstacle& box) {
    Simulation simulation(world_with({box}), host.host, {.cameras = render::world_cameras});
    simulation.step();
    return reading(simulation).found;
  };
  CHECK(finds(resource("food", 1, 0, "red")));
  CHECK(finds(resource("food", 1, 0, "")));
  CHECK_FALSE(finds(resource("food", 1, 0, "blue")));
  world::Obstacle violet = resource("food", 1, 0, "red");
  violet.colour = Colour{160, 20, 200};
  CHECK(finds(violet));
  violet.kind = world::ObstacleKind::fixed;
  CHECK_FALSE(finds(violet));

  // The list: each colour once, in file order.
  auto world = world_with({resource("a", 1, 0, "red"), resource("b", 1, 1, "blue"),
                           resource("c", 1, 2, ""), resource("d", 1, 3, "red")});
  std::vector<Colour> seen;
  class Asking final : public SensorOf<ProximityReading> {
   public:
    explicit Asking(std::vector<Colour>& list) : list_(list) {}
    ProximityReading sense(const SensorContext& now) override {
      const auto colours = now.world->resource_colours();
      list_.assign(colours.begin(), colours.end());
      CHECK_FALSE(now.image);  // it has no camera
      return {};
    }

   private:
    std::vector<Colour>& list_;
  };
  ScriptedHost asking = driving(0.0);
  Declaration declaration = declaration_of(PluginKind::sensor, "asking",
                                           [&seen] { return std::make_unique<Asking>(seen); });
  declaration.produces = {{ProximityReading::kind, sizeof(ProximityReading)}};
  asking.host.add(std::move(declaration));
  world::MountedUse use;
  use.plugin = use.id = "asking";
  world.robots[0].sensors = {use};
  Simulation simulation(world, asking.host, {.cameras = render::world_cameras});
  simulation.step();
  CHECK(seen == std::vector<Colour>{world::kRedTeam, world::kResourceOfNoTeam});
}

TEST_CASE("A camera that cannot look for a resource's colour is refused, whosesoever it is") {
  const ScriptedHost host = driving(0.0);
  const auto refusal = [&](world::World world) -> std::string {
    world.robots[0].sensors[0].location = {"here.xml", 12};
    try {
      const Simulation simulation(std::move(world), host.host, {.cameras = render::world_cameras});
      return "";
    } catch (const world::WorldError& error) {
      return error.what();
    }
  };
  auto world = world_with({resource("food", 1, 0)});
  world.obstacles[0].colour = Colour{128, 128, 128};
  CHECK_THAT(refusal(world),
             Catch::Contains("here.xml:12: plugin 'vision': it cannot look for the colour "
                             "#808080, a grey like those of floor, walls and sky") &&
                 Catch::Contains("give the objects to find a colour with a hue"));
  // Two robots, two refusals; all that is wrong with a robot at once.
  world.robots.push_back(world.robots[0]);
  world.robots[1].id = "r2";
  world.robots[1].x = 1;
  world.robots[1].sensors.push_back(camera("other"));
  try {
    const Simulation simulation(world, host.host, {.cameras = render::world_cameras});
    FAIL("it was accepted");
  } catch (const world::WorldError& error) {
    CHECK(error.problems().size() == 3);
  }
  // It is no matter to a camera that need not look for it.
  world.robots.resize(1);
  world.obstacles[0].team = "blue";
  CHECK(refusal(world).empty());
  world.obstacles[0].team = "red";
  world.robots[0].sensors[0].elements = {{"match_colour", {{"colours", "#ffd000"}}, {}, {}, {}}};
  CHECK(refusal(world).empty());
}

TEST_CASE("Cameras take pictures once every control period, none when the battery is empty") {
  const ScriptedHost host = driving(10.0);
  auto world = world_with({resource("food", 3.0, 0.0)});
  world.physics.control_steps = 4;
  world.robots[0].battery = 0.5;
  world.robots[0].sensors[0].energy_cost = 1.0;
  world.robots[0].sensors[0].parameters = {{"error", 0.05}};  // no two pictures are alike
  Simulation simulation(world, host.host, {.cameras = render::world_cameras});
  std::vector<std::vector<std::uint8_t>> pictures;
  for (int i = 0; i < 100; ++i) {
    simulation.step();
    if (pictures.empty() || pictures.back() != reading(simulation).raw.bytes) {
      pictures.push_back(reading(simulation).raw.bytes);
    }
  }
  CHECK(simulation.robot(0).empty);
  CHECK(pictures.size() == 13);  // energy for half a second, and a picture every 0.04 s
}

TEST_CASE("The same seed gives the same pictures, from whatever thread each step is taken") {
  const ScriptedHost host = driving(12.0);
  auto world =
      world_with({resource("food", 2.0, 0.3), box("b", world::ObstacleKind::dynamic, 0.5, 0)});
  world.robots[0].sensors[0].parameters = {{"error", 0.05}};
  Simulation one(world, host.host, {.seed = 4, .cameras = render::world_cameras}),
      other(world, host.host, {.seed = 4, .cameras = render::world_cameras});
  Simulation third(world, host.host, {.seed = 5, .cameras = render::world_cameras});
  for (int i = 0; i < 20; ++i) {
    one.step();
    std::thread([&other] { other.step(); }).join();
    third.step();
    REQUIRE(reading(one).raw.bytes == reading(other).raw.bytes);
    REQUIRE(reading(one).processed.bytes == reading(other).processed.bytes);
    CHECK(reading(one).raw.bytes != reading(third).raw.bytes);
  }
  CHECK(one.state_hash() == other.state_hash());
  const auto last = reading(one).raw.bytes;
  one.reset(4);
  advance(one, 20);
  CHECK(reading(one).raw.bytes == last);
}

TEST_CASE("A camera that can take no picture is a fault at the sensor's place in the world file") {
  class Odd final : public SensorOf<ProximityReading> {
   public:
    explicit Odd(const Camera& camera) : camera_(camera) {}
    std::optional<Camera> camera() const override {
      if (camera_.height == 13) {
        throw std::runtime_error("it has no luck");
      }
      return camera_;
    }
    ProximityReading sense(const SensorContext&) override { return {}; }

   private:
    Camera camera_;
  };
  const auto refuse = [](const Camera& bad, const char* sentence) {
    ScriptedHost host = driving(0.0);
    Declaration declaration =
        declaration_of(PluginKind::sensor, "odd", [bad] { return std::make_unique<Odd>(bad); });
    declaration.produces = {{ProximityReading::kind, sizeof(ProximityReading)}};
    host.host.add(std::move(declaration));
    auto world = world_with({});
    world::MountedUse use;
    use.plugin = use.id = "odd";
    use.location = {"here.xml", 17};
    world.robots[0].sensors.push_back(use);
    try {
      const Simulation simulation(world, host.host, {.cameras = render::world_cameras});
      FAIL("it was accepted");
    } catch (const world::WorldError& error) {
      REQUIRE(error.problems().size() == 1);
      CHECK(error.problems()[0].line == 17);
      CHECK_THAT(error.what(), Catch::Contains("here.xml:17:") && Catch::Contains("'odd'") &&
                                   Catch::Contains(sentence));
    }
  };
  refuse({0, 10, 1.0}, "0 x 10 pixels");
  refuse({1000000, 10, 1.0}, "1000000 x 10 pixels, but on this machine");
  refuse({10, 10, 0.0}, "field of view of 0 ");
  refuse({10, 10, 4.0}, "must be above 0 and below 180");
  refuse({10, 13, 1.0}, "it has no luck");
}

TEST_CASE("A world with a camera needs what takes its pictures") {
  const ScriptedHost host = driving(0.0);
  const auto world = world_with({});
  CHECK_THROWS_WITH(Simulation(world, host.host),
                    Catch::Contains("plugin 'vision': no renderer was given for its camera"));
  CHECK_NOTHROW(Simulation(world, host.host, {.cameras = render::world_cameras}));
}
