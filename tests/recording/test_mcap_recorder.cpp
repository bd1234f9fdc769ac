#include <catch2/catch.hpp>

#include "elsie/api/measure.h"
#include "elsie/files/base64.h"
#include "elsie/picture/image_file.h"
#include "elsie/render/world_cameras.h"
#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/world/writer.h"

#include "recorded.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;
using simulation::Simulation;

namespace {

class SilentMeasure final : public Measure {
 public:
  std::vector<Quantity> quantities() const override { return {{"", "", "nothing"}}; }
  void observe(const Observation&) override {}
  void report(const RunEnd&, std::span<std::optional<double>>) const override {
    throw std::runtime_error("there is nothing to tell");
  }
};

world::World two_named_robots() {
  world::World world;
  world.name = "two";
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("go_to_point", 2, {{"x", 3.0}})));
  world.robots[0].behaviors.push_back(behavior("wander", 1));
  world.robots[0].sensors.push_back(beam("eye", 0));
  world.robots.push_back(robot("r2", 1, 1, 0, behavior("wander")));
  world.limits.time = 2;
  return world;
}

std::map<std::string, std::string> metadata_of(const std::filesystem::path& file,
                                               const std::string& name) {
  mcap::Reader reader(file);
  while (reader.next()) {
  }
  for (const mcap::Metadata& metadata : reader.metadata()) {
    if (metadata.name == name) {
      return metadata.values;
    }
  }
  return {};
}

}  // namespace

TEST_CASE("Poses and states are those of their time, bit for bit") {
  const RecordedFile file(two_named_robots(), shipped());
  auto all = recorded(file.path);
  const auto& states = all["/robots/r1/state"];
  REQUIRE(states.size() == 21);
  CHECK(states.front().time_ns == 0);
  CHECK(states.front().content.at("x_m") == 0.0);
  CHECK(states[7].time_ns == 700'000'000);
  CHECK(states.back().time_ns == 2'000'000'000);
  CHECK(states.back().content.at("x_m").get<double>() == file.result.robots[0].pose.x);
  CHECK(states.back().content.at("heading_rad").get<double>() ==
        file.result.robots[0].pose.heading_rad);
  CHECK(states.back().content.at("distance_m").get<double>() == file.result.robots[0].distance_m);
  CHECK(states.back().content.at("energy").get<double>() == file.result.robots[0].energy);
  const auto& pose = all["/robots/r1/pose"].back().content;
  CHECK(pose.at("frame_id") == "world");
  CHECK(pose.at("pose").at("position").at("y").get<double>() == file.result.robots[0].pose.y);
  const auto& turned = pose.at("pose").at("orientation");
  CHECK(2 * std::atan2(turned.at("z").get<double>(), turned.at("w").get<double>()) ==
        Approx(file.result.robots[0].pose.heading_rad));
  CHECK(all["/robots/r2/state"].size() == 21);
}

TEST_CASE("Readings, commands and traces are those of the last decision, and have its time") {
  world::World world = two_named_robots();
  world.physics.control_steps = 4;
  const RecordedFile file(world, shipped());
  auto all = recorded(file.path);
  const auto& readings = all["/robots/r1/readings"];
  REQUIRE(readings.size() == 20);  // none at the start: nothing was decided yet
  CHECK(readings.front().time_s() == Approx(0.1));
  CHECK(readings.front().timestamp_s() == Approx(0.08));
  CHECK(readings.front().content.at("sensors").at("eye").at("distance_m") == 1.0);
  CHECK(readings.front().content.at("sensors").at("eye").at("hit") == 0.0);
  const auto& command = all["/robots/r1/command"].front();
  CHECK(command.timestamp_s() == Approx(0.08));
  const auto& traces = all["/robots/r1/trace"];
  // The last one that differed until then: it holds.
  const auto after = std::find_if(traces.begin(), traces.end(),
                                  [](const Recorded& trace) { return trace.time_ns > 80'000'000; });
  REQUIRE(after != traces.begin());
  const auto& trace = *std::prev(after);
  CHECK(trace.timestamp_s() == trace.time_s());
  const auto& rows = trace.content.at("behaviors");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].at("path") == "go_to_point");
  CHECK(rows[0].at("coordinator") == "arbiter_suppression");
  CHECK(rows[0].at("asked") == true);
  CHECK(rows[0].at("share") == 1.0);
  CHECK(rows[0].at("forward_m_s") == trace.content.at("asked_forward_m_s"));
  CHECK(rows[0].at("forward_m_s").get<double>() ==
        Approx(command.content.at("asked_forward_m_s").get<double>()).margin(0.00001));
  CHECK(rows[0].at("reason") == "highest priority");
  CHECK(rows[1].at("asked") == false);
  CHECK(rows[1].at("inhibited_by") == "go_to_point");
  CHECK(!rows[0].contains("time_s"));
  CHECK(all["/robots/r2/readings"].front().content.at("sensors").empty());
}

TEST_CASE("The file says what ran: world, seed, program, periods; and how it ended") {
  McapFile file;
  Simulation simulation(two_named_robots(), shipped(), {.seed = 18446744073709551615ULL});
  const auto result = record(simulation, file.path, {.rate_hz = 20, .program = "elsie 1.2.3"});
  CHECK(mcap::Reader(file.path).header().library == "elsie 1.2.3");
  const auto run = metadata_of(file.path, "elsie.run");
  CHECK(run.at("world") == "two");
  CHECK(run.at("seed") == "18446744073709551615");
  CHECK(run.at("time_limit_s") == "2");
  CHECK(run.at("step_s") == "0.01");
  CHECK(run.at("sample_steps") == "5");
  const auto end = metadata_of(file.path, "elsie.result");
  CHECK(end.at("outcome") == to_string(result.outcome));
  CHECK(end.at("reason") == result.reason);
  CHECK(end.at("steps") == "200");
  const auto measures = metadata_of(file.path, "elsie.measures");
  CHECK(measures.at("success") == "0");
  CHECK(measures.at("time_s") == "2");
  CHECK(std::stod(measures.at("path_length_m")) ==
        result.robots[0].distance_m + result.robots[1].distance_m);
  CHECK(recording::read_recorded_run(file.path).result->measures.at("time_s") == 2.0);
  const auto worlds = recorded(file.path)["/world"];
  REQUIRE(worlds.size() == 1);
  CHECK(worlds[0].content.at("xml") == world::write_world(simulation.world()));
  CHECK(worlds[0].content.at("seed") == "18446744073709551615");
}

TEST_CASE("A run is the same with a recording and without, and so are two recordings of it") {
  const auto record_bytes = [](Simulation& simulation, std::uint64_t& hash) {
    McapFile file;
    hash = record(simulation, file.path, {.images = true}).state_hash;
    return file.bytes();
  };
  Simulation simulation(shipped_world("find_resource.xml", 3), shipped(),
                        {.cameras = render::world_cameras});
  const std::uint64_t alone = simulation.run().state_hash;
  simulation.reset();
  std::uint64_t watched = 0, again = 0;
  const std::string first = record_bytes(simulation, watched);
  Simulation other(shipped_world("find_resource.xml", 3), shipped(),
                   {.cameras = render::world_cameras});
  CHECK(record_bytes(other, again) == first);
  CHECK(first.size() > 5000);
  CHECK(watched == alone);
  CHECK(again == alone);
}

TEST_CASE("What cameras see is recorded on request, whole, with the time at which it was taken") {
  McapFile file;
  Simulation simulation(shipped_world("find_resource.xml", 1), shipped(),
                        {.cameras = render::world_cameras});
  record(simulation, file.path, {.images = true});
  auto all = recorded(file.path);
  const std::string robot = simulation.robot(0).description->id;
  const simulation::SensorView sensor = simulation.sensor(0, 0);
  REQUIRE(sensor.camera);
  const auto& reading = *static_cast<const VisionReading*>(sensor.sensor->reading());
  const std::string camera(sensor.id);
  const std::string topic = "/robots/" + robot + "/cameras/" + camera;
  REQUIRE(all[topic].size() == 10);
  CHECK(all[topic + "/processed"].size() == 10);
  const auto& last = all[topic].back();
  CHECK(last.time_s() == Approx(1.0));
  CHECK(last.timestamp_s() == Approx(0.99));
  CHECK(last.content.at("format") == "png");
  const std::string text = last.content.at("data");
  CHECK(text.starts_with("iVBORw0KGgo"));                                // the mark of PNG files
  CHECK(text.size() == (picture::png(reading.raw).size() + 2) / 3 * 4);  // and all of it, noise too

  record(simulation, file.path);
  CHECK(!recorded(file.path).contains(topic));
}

TEST_CASE("A robot whose battery is empty sees nothing") {
  world::World world = shipped_world("find_resource.xml", 2);
  world.robots[0].energy = 0.5;
  world.robots[0].sensors[0].energy_cost = 1.0;
  const RecordedFile file(world, shipped(), {.cameras = render::world_cameras}, {.images = true});
  auto all = recorded(file.path);
  std::size_t pictures = 0;
  for (const auto& [topic, messages] : all) {
    pictures +=
        topic.find("/cameras/") != std::string::npos && topic.find("processed") == std::string::npos
            ? messages.size()
            : 0;
  }
  CHECK(pictures > 0);
  CHECK(pictures < 10);
}

TEST_CASE("Events are written when they happen, with the robot's place") {
  McapFile file;
  world::World world = one_robot(behavior("wander", 1, {{"speed", 20.0}, {"restlessness", 0.0}}));
  world.obstacles.push_back(box("b", world::ObstacleKind::fixed, 0.5, 0));
  world.limits.time = 2;
  Simulation simulation(world, shipped());
  const simulation::TimedEdit changes[] = {{1.5, {"robot[r1]/@max_speed", "0.3"}}};
  const auto recorder = recording::mcap_recorder(file.path);
  simulation::Observer* const observers[] = {recorder.get()};
  const auto result = simulation.run(observers, changes);
  const auto events = recorded(file.path)["/events"];
  REQUIRE(events.size() == result.events.size());
  REQUIRE(events.size() == 2);
  CHECK(events[0].time_s() == Approx(result.events[0].time_s));
  CHECK(events[0].content.at("name") == "r1");
  CHECK(events[0].content.at("event") == "collision");
  CHECK(events[0].content.at("message").get<std::string>().starts_with("collision: "));
  CHECK(events[0].content.at("level") == 3);  // a warning
  CHECK(events[0].content.at("x_m").get<double>() == Approx(0.35).margin(0.02));
  CHECK(events[1].content.at("detail") == "robot[r1]/@max_speed=0.3");
  CHECK(events[1].content.at("element") == "robot[r1]");
  CHECK(events[1].content.at("attribute") == "max_speed");
  CHECK(events[1].content.at("value") == "0.3");
  CHECK_FALSE(events[0].content.contains("element"));
  CHECK(events[1].content.at("level") == 2);
}

TEST_CASE("The scene is written at the start, and again when a box has left it") {
  world::World world = one_robot(behavior("wander", 1, {{"speed", 20.0}, {"restlessness", 0.0}}));
  world.obstacles.push_back(box("prey", world::ObstacleKind::resource, 0.5, 0));
  world.obstacles.push_back(box("pushed", world::ObstacleKind::dynamic, 0, 2));
  world.limits.time = 3;
  const RecordedFile file(world, shipped());
  auto all = recorded(file.path);
  const auto ids = [&](std::size_t i) {
    std::vector<std::string> found;
    for (const auto& entity : all["/scene"].at(i).content.at("entities")) {
      found.push_back(entity.at("id"));
    }
    return found;
  };
  REQUIRE(all["/scene"].size() == 2);
  CHECK(ids(0) == std::vector<std::string>{"arena", "box/prey", "box/pushed", "robot/r1"});
  CHECK(ids(1) == std::vector<std::string>{"arena", "box/pushed", "robot/r1"});
  CHECK(all["/scene"][1].content.at("deletions")[0].at("type") == 1);  // all that was there
  std::vector<std::string> frames;
  for (const auto& transform : all["/tf"].back().content.at("transforms")) {
    frames.push_back(transform.at("child_frame_id"));
  }
  CHECK(frames == std::vector<std::string>{"robot/r1", "box/pushed"});
}

TEST_CASE("There is a sample at the very end, wherever that is between two periods") {
  world::World world = two_named_robots();
  world.limits.time = 1.23;
  const RecordedFile file(world, shipped(), {}, {.rate_hz = 5});
  const auto states = recorded(file.path)["/robots/r1/state"];
  REQUIRE(states.size() == 1 + 6 + 1);
  CHECK(states.back().time_s() == Approx(1.23));
  CHECK(states.back().content.at("x_m").get<double>() == file.result.robots[0].pose.x);
}

TEST_CASE("A sample is in the file a second later, however long the next one takes") {
  McapFile file;
  world::World world = two_named_robots();
  world.limits.time = 100;
  Simulation simulation(world, shipped());
  const auto recorder = recording::mcap_recorder(file.path, {.rate_hz = 0.1});
  recorder->started(simulation);
  while (simulation.time_s() < 28) {
    simulation.step();
    recorder->stepped(simulation);
  }
  // As a program that is killed now would leave it.
  const auto states = recorded(file.path)["/robots/r1/state"];
  REQUIRE(states.size() == 3);
  CHECK(states.back().time_s() == 20.0);
}

TEST_CASE("A plugin that fails ends the run, and what was recorded is kept, with its end") {
  McapFile file;
  ScriptedHost scripted([](const Perception& now) -> Response {
    if (now.time_s() > 0.5) {
      throw std::runtime_error("enough");
    }
    return Motion{now.time_s(), 0, 0};
  });
  world::World world = one_robot();
  Simulation simulation(world, scripted.host);
  CHECK_THROWS_AS(record(simulation, file.path, {.rate_hz = 100}), simulation::PluginFault);
  CHECK(recorded(file.path)["/robots/r1/state"].size() == 52);
  const auto result = metadata_of(file.path, "elsie.result");
  CHECK(result.at("outcome") == "stopped");
  CHECK_THAT(result.at("reason"),
             Catch::Contains("of robot 'r1' failed in step 51") && Catch::EndsWith(": enough"));
  const traces::Trace trace = recording::read_trace(file.path);
  CHECK(trace.outcome == "stopped");
  CHECK(trace.robots[0].members[0].notes.size() == 51);
}

TEST_CASE("A measure that fails in the end fails the run, and the recording is whole") {
  McapFile file;
  Declaration declaration;
  declaration.kind = PluginKind::measure;
  declaration.name = "silent";
  declaration.description = "Has nothing to tell when it is asked";
  declaration.create = [] { return std::make_unique<SilentMeasure>(); };
  ScriptedHost scripted([](const Perception&) -> Response { return wheels(5, 5); });
  scripted.host.add(std::move(declaration));
  world::World world = one_robot();
  world.limits.time = 1;
  world.measures.emplace_back();
  world.measures[0].plugin = world.measures[0].id = "silent";
  Simulation simulation(world, scripted.host);
  CHECK_THROWS_WITH(record(simulation, file.path), Catch::Contains("nothing to tell"));
  const auto run = recording::read_recorded_run(file.path);
  CHECK(run.missing_end.empty());
  CHECK(run.end_s == Approx(1.0));
  REQUIRE(run.result);
  CHECK(run.result->outcome == "stopped");
  CHECK(!run.result->measures.contains("silent"));
}

TEST_CASE("Text that is not UTF-8 becomes text that is") {
  world::World world = two_named_robots();
  world.name = "caf\xe9 \"quoted\"";
  world.limits.time = 0.1;
  const RecordedFile file(world, shipped());
  CHECK(recorded(file.path)["/world"][0].content.at("name") == "caf\xef\xbf\xbd \"quoted\"");
}

TEST_CASE("A recording that cannot be made says so") {
  CHECK_THROWS_WITH(recording::mcap_recorder("/nowhere/at/all.mcap"),
                    Catch::Contains("'/nowhere/at/all.mcap' cannot be created"));
  McapFile file;
  CHECK_THROWS_WITH(recording::mcap_recorder(file.path, {.rate_hz = 0}),
                    "a recording needs a positive number of samples a second");
}

TEST_CASE("A round robot is a cylinder that stands, on two that lie") {
  world::World world = one_robot(behavior("wander", 1, {{"speed", 20.0}, {"restlessness", 0.0}}));
  world.robots[0].body.round = true;
  world.limits.time = 0.1;
  const RecordedFile file(world, shipped());
  const auto all = recorded(file.path);
  const auto& drawn = all.at("/scene").at(0).content.at("entities").back();
  CHECK(drawn.at("cubes").empty());
  CHECK(drawn.at("spheres").size() == 2);  // casters
  const auto& cylinders = drawn.at("cylinders");
  REQUIRE(cylinders.size() == 3);
  // The direction of a cylinder's axis is up, turned by its orientation; its z is 1 - 2 (x2 + y2).
  const auto upwards = [](const nlohmann::json& cylinder) {
    const auto& q = cylinder.at("pose").at("orientation");
    const double x = q.at("x"), y = q.at("y");
    return 1.0 - 2.0 * (x * x + y * y);
  };
  CHECK(cylinders[0].at("size").at("x") == 0.08);
  CHECK(cylinders[0].at("size").at("z") == 0.08);
  CHECK(upwards(cylinders[0]) == Approx(1.0));
  for (const std::size_t wheel : {1U, 2U}) {
    CHECK(cylinders[wheel].at("size").at("z") == 0.01);
    CHECK(upwards(cylinders[wheel]) == Approx(0.0).margin(1e-9));
  }
}

TEST_CASE("Cylinders are cylinders, and prisms are triangles that enclose their volume") {
  world::World world;
  world.obstacles.push_back(box("drum", world::ObstacleKind::dynamic, 1, 0));
  world.obstacles.back().shape = ObstacleShape::cylinder;
  world.obstacles.back().radius = 0.3;
  world.obstacles.push_back(box("wedge", world::ObstacleKind::fixed, 0, 1));
  world.obstacles.back().shape = ObstacleShape::prism;
  world.obstacles.back().points = {{0, 0}, {0, 1}, {1, 1}, {1.5, 0.5}, {1, 0}};
  world.obstacles.back().height = 0.4;
  world.limits.time = 0.1;
  const RecordedFile file(world, shipped());
  const auto entities = recorded(file.path)["/scene"].at(0).content.at("entities");
  const auto& drum = entities.at(1).at("cylinders").at(0);
  CHECK(entities.at(1).at("cubes").empty());
  CHECK(drum.at("size").at("x") == 0.6);
  CHECK(drum.at("size").at("z") == 0.2);
  const auto& wedge = entities.at(2).at("triangles").at(0);
  CHECK(entities.at(2).at("cubes").empty());
  CHECK(wedge.at("pose").at("position").at("y") == 1.0);
  CHECK(wedge.at("pose").at("position").at("z") == 0.2);
  // The signed volumes of the tetrahedra between the middle and the triangles (divergence theorem).
  double volume = 0.0;
  const auto& indices = wedge.at("indices");
  REQUIRE(indices.size() == 3 * (2 * 5 + 2 * 3));
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    Vector3 corner[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& point = wedge.at("points").at(indices[i + k].get<std::size_t>());
      corner[k] = {point.at("x"), point.at("y"), point.at("z")};
    }
    const auto& [a, b, c] = corner;
    volume += (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
               a.z * (b.x * c.y - b.y * c.x)) /
              6.0;
  }
  CHECK(volume == Approx(1.25 * 0.4));
}

TEST_CASE("The scene has the floor's colour, its image and patches as triangles, and lamps") {
  world::World world = one_robot(behavior("wander"));
  world.floor.colour = Colour{255, 0, 0};
  world.floor.pixels = std::make_shared<const Image>(Image{2, 1, 3, {0, 255, 0, 0, 0, 255}});
  world.patches.push_back({.id = "d", .shape = world::PatchShape::disc, .points = {}});
  world.lamps.push_back({.id = "sun", .x = 1.0});
  world.limits.time = 0.1;
  const RecordedFile file(world, shipped());
  auto all = recorded(file.path);
  const auto entities = all["/scene"].at(0).content.at("entities");
  REQUIRE(entities.size() == 4);
  CHECK(entities[0].at("cubes")[0].at("color").at("g") == 0.0);
  CHECK(entities[1].at("id") == "floor");
  const auto& drawn = entities[1].at("triangles").at(0);
  CHECK(drawn.at("points").size() == 4 + 4 + 24);
  CHECK(drawn.at("colors").size() == drawn.at("points").size());
  CHECK(drawn.at("indices").size() == 6 + 6 + 3 * 22);
  CHECK(drawn.at("points").back().at("z") > drawn.at("points")[0].at("z"));
  CHECK(entities[2].at("id") == "lamp/sun");
  CHECK(entities[2].at("spheres").size() == 1);
  CHECK(entities[2].at("texts")[0].at("text") == "sun");
}

TEST_CASE("The scene has nests as discs on the floor, also without patches") {
  world::World world = one_robot(behavior("wander"));
  world::Nest& nest = world.nests.emplace_back();
  nest.id = "home";
  nest.x = 1.0;
  nest.colour = {0, 255, 0};
  world.limits.time = 0.1;
  const RecordedFile file(world, shipped());
  auto all = recorded(file.path);
  const auto entities = all["/scene"].at(0).content.at("entities");
  REQUIRE(entities.size() == 3);  // arena, floor, robot
  CHECK(entities[1].at("id") == "floor");
  const auto& drawn = entities[1].at("triangles").at(0);
  REQUIRE(drawn.at("points").size() == 24);
  double sum = 0.0;
  for (const auto& point : drawn.at("points")) sum += point.at("x").get<double>();
  CHECK(sum / 24.0 == Approx(1.0));
  CHECK(drawn.at("colors")[0].at("g") == 1.0);
}

TEST_CASE("Fields are recorded once a second and at the end, and read back for the picture") {
  world::World world = one_robot(behavior("wander"));
  world.arena.length = 4.0, world.arena.width = 2.0;
  world.fields.resize(2);
  world::ScalarField &coarse = world.fields[0], &fine = world.fields[1];
  coarse.id = "heat";
  coarse.cell = 0.5;
  coarse.half_life = 1.0;
  coarse.start = 8.0;
  fine.id = "fine";
  fine.cell = 0.01;
  fine.start = 3.0;
  world.limits.time = 2.5;
  const RecordedFile file(world, shipped());
  auto all = recorded(file.path);
  const auto& heat = all["/fields/heat"];
  REQUIRE(heat.size() == 4);
  CHECK(heat[0].time_s() == 0.0);
  CHECK(heat[1].time_s() == Approx(1.0));
  CHECK(heat[3].time_s() == Approx(2.5));
  const auto& content = heat[1].content;
  CHECK(content.at("column_count") == 8);
  CHECK(content.at("cell_size").at("y") == 0.5);
  CHECK(content.at("row_stride") == 32);
  CHECK(content.at("pose").at("position").at("x") == -2.0);
  const auto values = files::unpacked<float>(content.at("data").get<std::string>());
  REQUIRE(values);
  CHECK(values->size() == 8 * 4);
  CHECK(values->front() == Approx(4.0F));
  CHECK(all["/fields/fine"][0].content.at("column_count") == 256);

  const recording::RecordedRun run = recording::read_recorded_run(file.path, 1.7);
  REQUIRE(run.fields.size() == 2);
  CHECK(run.fields.at("heat").columns == 8);
  CHECK(run.fields.at("heat").rows == 4);
  CHECK(run.fields.at("heat").values[5] == Approx(4.0F));
  CHECK(run.fields.at("fine").values[1000] == Approx(3.0F));
}
