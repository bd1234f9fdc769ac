// What the vision sensor finds in pictures of worlds.
#include <algorithm>
#include <thread>

#include <catch2/catch.hpp>

#include "camera_work.h"

using namespace elsie;
using namespace elsie::test;

namespace {

world::Obstacle resource(double x, double y, const std::string& team = "red") {
  world::Obstacle box;
  box.kind = world::ObstacleKind::resource;
  box.x = x;
  box.y = y;
  box.team = team;
  return box;
}

world::Obstacle obstacle(double x, double y) {
  world::Obstacle box;
  box.x = x;
  box.y = y;
  return box;
}

/// A robot of the red team at the origin, looking along x, with a camera on it.
class Scout {
 public:
  explicit Scout(test::Parameters parameters = {}, const std::vector<ElementValue>& steps = {})
      : watcher_(std::move(parameters), steps) {
    world.teams = {{"red", world::kRedTeam}, {"blue", world::kBlueTeam}};
    watcher_.world.colours = {world::kRedTeam};
  }

  world::World world;
  Vector3 mount{0.04, 0.0, 0.09};
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;

  const VisionReading& look() {
    return watcher_.look_at(photograph(
        world, Frame::turned(mount, radians(yaw_deg), radians(pitch_deg)), watcher_.camera()));
  }
  Watcher& watcher() { return watcher_; }

  /// The column at which elsie::Camera sees a point.
  double column_of(double x, double y) const {
    const Camera camera = watcher_.camera();
    const double angle = std::atan2(y - mount.y, x - mount.x) - radians(yaw_deg);
    return 0.5 * camera.width * (1.0 - std::tan(angle) / std::tan(0.5 * camera.horizontal_fov_rad));
  }

 private:
  Watcher watcher_;
};

}  // namespace

TEST_CASE(
    "A resource at a known bearing and distance is found in the column of the pinhole model") {
  for (const double distance : {1.0, 2.5, 4.0}) {
    for (const double bearing : {-12.0, -5.0, 0.0, 3.0, 11.0}) {
      Scout scout;
      scout.mount.x = 0.0;
      const double x = distance * std::cos(radians(bearing));
      const double y = distance * std::sin(radians(bearing));
      scout.world.obstacles = {resource(x, y)};
      scout.world.obstacles[0].length = scout.world.obstacles[0].width = 0.06;
      const VisionReading& seen = scout.look();
      CAPTURE(distance, bearing, seen.column, seen.area_px);
      REQUIRE(seen.found);
      CHECK(std::abs(seen.column - scout.column_of(x, y)) <= 1.0);
      CHECK(seen.width == 100);
      CHECK(seen.height == 100);
      CHECK(seen.horizontal_fov_rad == Approx(radians(30)));
    }
  }
}

TEST_CASE("A mounting off the middle, turned and tilted, is taken into account") {
  for (const double yaw : {-70.0, 30.0, 160.0}) {
    for (const double pitch : {-10.0, 0.0, 6.0}) {
      Scout scout;
      scout.mount = {0.02, -0.03, 0.12};
      scout.yaw_deg = yaw;
      scout.pitch_deg = pitch;
      // Two metres away, five degrees to the left of the camera's axis.
      const double angle = radians(yaw + 5.0);
      const double x = scout.mount.x + 2.0 * std::cos(angle);
      const double y = scout.mount.y + 2.0 * std::sin(angle);
      scout.world.obstacles = {resource(x, y)};
      scout.world.obstacles[0].length = scout.world.obstacles[0].width = 0.05;
      scout.world.obstacles[0].heading_deg = degrees(angle);
      const VisionReading& seen = scout.look();
      CAPTURE(yaw, pitch, seen.column, seen.row);
      REQUIRE(seen.found);
      const double half = 50.0 / std::tan(radians(15));
      // The middle of the box, 0.1 m above the floor, in the camera's frame.
      const Frame camera = Frame::turned(scout.mount, radians(yaw), radians(pitch));
      const Vector3 d = Vector3{x, y, 0.1} - camera.origin;
      CHECK(std::abs(seen.column - (50 - half * dot(d, camera.left) / dot(d, camera.forward))) <=
            1.0);
      CHECK(std::abs(seen.row - (50 - half * dot(d, camera.up) / dot(d, camera.forward))) <= 1.0);
    }
  }
}

TEST_CASE("Where there is no resource nothing is found") {
  Scout scout;
  scout.world.obstacles = {obstacle(1.0, 0.0), obstacle(2.0, 0.3)};
  scout.world.chargers.emplace_back().x = 1.5;
  world::Robot& mate = scout.world.robots.emplace_back();
  mate.team = "red";
  mate.x = 0.6;
  mate.y = 0.15;
  const VisionReading& seen = scout.look();
  CHECK_FALSE(seen.found);
  CHECK(seen.column == 0.0);
  CHECK(seen.row == 0.0);
  CHECK(seen.area_px == 0.0);
  CHECK(seen.raw.bytes.size() == 100 * 100 * 3);
  CHECK(seen.processed.bytes == std::vector<std::uint8_t>(100 * 100, 0));
}

TEST_CASE("An obstacle hides what is behind it, wholly or in part") {
  Scout scout;
  scout.world.obstacles = {resource(2.0, 0.0)};
  const double whole = scout.look().area_px;
  CHECK(whole > 200);

  scout.world.obstacles.push_back(obstacle(1.0, 0.0));
  CHECK_FALSE(scout.look().found);

  scout.world.obstacles[1].y = 0.1;  // its right face is on the camera's axis
  const VisionReading& part = scout.look();
  CHECK(part.area_px == Approx(0.5 * whole).epsilon(0.1));
  CHECK(part.column > 53.0);

  scout.world.obstacles[1].x = 3.0;
  CHECK(scout.look().area_px == whole);
}

TEST_CASE("Resources of another team are not seen; those for all are") {
  Scout scout;
  scout.world.obstacles = {resource(1.5, 0.0, "blue")};
  CHECK_FALSE(scout.look().found);
  scout.world.obstacles.push_back(resource(2.0, 0.4));
  CHECK(scout.look().column < 20);
  scout.world.obstacles = {resource(1.5, 0.0, "")};
  CHECK_FALSE(scout.look().found);  // the red robot looks for red ones only
  scout.watcher().world.colours = {world::kRedTeam, world::kResourceOfNoTeam};
  CHECK(scout.look().found);
}

TEST_CASE("Of several resources the reading is about the largest") {
  Scout scout;
  scout.world.obstacles = {resource(3.0, 0.4), resource(1.5, -0.2), resource(4.0, 0.0)};
  const VisionReading& seen = scout.look();
  CHECK(std::abs(seen.column - scout.column_of(1.5, -0.2)) <= 2.0);
  // The mask shows all three.
  const auto pixels = std::count(seen.processed.bytes.begin(), seen.processed.bytes.end(), 255);
  CHECK(static_cast<double>(pixels) > seen.area_px + 60);
}

TEST_CASE("The reading's blob is the one in the mask, and its centre the mean of its pixels") {
  Scout scout;
  scout.world.obstacles = {resource(1.2, 0.15)};
  scout.world.obstacles[0].heading_deg = 30;
  const VisionReading& seen = scout.look();
  double area = 0, column = 0, row = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const int value = *seen.processed.pixel(x, y);
      REQUIRE((value == 0 || value == 255));
      if (value == 255) {
        area += 1;
        column += x + 0.5;
        row += y + 0.5;
      }
    }
  }
  CHECK(seen.area_px == area);
  CHECK(seen.column == Approx(column / area));
  CHECK(seen.row == Approx(row / area));
}

TEST_CASE("Resources of many colours are found from all sides, whichever way the light falls") {
  for (const Colour colour : {Colour{0xd0, 0x30, 0x30},
                              {255, 0, 0},
                              {255, 0, 40},
                              {255, 60, 0},
                              {255, 208, 0},
                              {46, 158, 79},
                              {0, 255, 255},
                              {48, 96, 208},
                              {160, 0, 200},
                              {90, 30, 30},
                              {140, 110, 110},
                              {255, 255, 255}}) {
    Scout scout;
    scout.watcher().world.colours = {colour};
    scout.world.obstacles = {resource(0.0, 0.0)};
    scout.world.obstacles[0].colour = colour;
    CAPTURE(static_cast<int>(colour.red), static_cast<int>(colour.green),
            static_cast<int>(colour.blue));
    for (double around = 0; around < 360; around += 30) {
      scout.mount = {-1.2 * std::cos(radians(around)), -1.2 * std::sin(radians(around)), 0.25};
      scout.yaw_deg = around;
      scout.pitch_deg = -8;
      const VisionReading& seen = scout.look();
      CAPTURE(around, seen.area_px);
      REQUIRE(seen.found);
      CHECK(seen.column == Approx(50).margin(1.0));
      // Everything, and nothing else: 0.2 m at 1.2 m are 31 pixels, more where a corner is ahead.
      CHECK(seen.area_px > 900);
      CHECK(seen.area_px < 2200);
    }
  }
}

TEST_CASE("A grey that floor and walls have, too, is refused with a sentence") {
  Scout scout;
  scout.world.obstacles = {resource(1.0, 0.0)};
  scout.watcher().world.colours = {{128, 128, 128}};
  CHECK_THROWS_WITH(scout.look(), Catch::Contains("cannot look for the colour #808080") &&
                                      Catch::Contains("give the objects to find a colour"));
  // With its own pipeline it does not use the resources' colours.
  Scout other({}, {{"threshold", {{"low", std::vector<double>{200, 0, 0}}}}});
  other.watcher().world.colours = {{128, 128, 128}};
  CHECK_FALSE(other.look().found);
}

TEST_CASE("A robot that may collect nothing finds nothing") {
  Scout scout;
  scout.world.obstacles = {resource(1.0, 0.0)};
  scout.watcher().world.colours.clear();
  CHECK_FALSE(scout.look().found);
}

TEST_CASE("Size and field of view can be set") {
  Scout scout({{"width", std::int64_t{160}}, {"height", std::int64_t{40}}, {"fov_deg", 70.0}});
  scout.world.obstacles = {resource(1.5, 0.6)};
  scout.world.obstacles[0].length = scout.world.obstacles[0].width = 0.06;
  const VisionReading& seen = scout.look();
  CHECK(seen.width == 160);
  CHECK(seen.height == 40);
  CHECK(seen.raw.bytes.size() == 160 * 40 * 3);
  CHECK(seen.processed.bytes.size() == 160 * 40);
  CHECK(seen.horizontal_fov_rad == Approx(radians(70)));
  REQUIRE(seen.found);
  CHECK(std::abs(seen.column - scout.column_of(1.5, 0.6)) <= 1.0);
}

TEST_CASE("The error is noise on every pixel, from the sensor's own stream") {
  Scout clean, noisy({{"error", 0.02}});
  clean.world.obstacles = noisy.world.obstacles = {resource(1.0, 0.0)};
  const VisionReading reference = clean.look();
  const VisionReading seen = noisy.look();
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < seen.raw.bytes.size(); ++i) {
    const double d = static_cast<double>(seen.raw.bytes[i]) - reference.raw.bytes[i];
    sum += d;
    squares += d * d;
  }
  const auto n = static_cast<double>(seen.raw.bytes.size());
  CHECK(sum / n == Approx(0.0).margin(0.1));
  CHECK(std::sqrt(squares / n) == Approx(0.02 * 255).epsilon(0.05));
  CHECK(seen.column == Approx(reference.column).margin(0.5));
  // The same stream gives the same picture; the next picture differs.
  Scout again({{"error", 0.02}});
  again.world.obstacles = noisy.world.obstacles;
  CHECK(again.look().raw.bytes == seen.raw.bytes);
  CHECK(again.look().raw.bytes != seen.raw.bytes);
}

TEST_CASE("Without a picture the sensor says so") {
  Watcher watcher;
  CHECK_THROWS_WITH(watcher.look_at({}), Catch::Contains("no picture"));
}

TEST_CASE("The plugin can go while threads that looked through it still run") {
  const Image image = photograph({}, Frame::turned({0, 0, 0.1}, 0, 0), {300, 300, radians(60)});
  std::thread([&image] {
    const plugin::Host host(test::shipped_directory());
    auto sensor = host.create<Sensor>(PluginKind::sensor, "vision");
    const Declaration* vision = host.find(PluginKind::sensor, "vision");
    plugin::apply_parameters(*vision, *sensor, {}, {{"blur", {}}, {"match_colour", {}}});
    test::Colours world;
    world.colours = {world::kRedTeam};
    const Mounting mounting;
    sensor->equipped({&mounting, world.colours});
    Random random;
    SensorContext now{0.0, 0.01, {}, &mounting, &world, &random};
    now.image = &image;
    sensor->update(now);
  }).join();
  CHECK(true);  // the thread's end calls OpenCV, which must still be loaded
}

TEST_CASE("A camera draws what it looks at, and the direction of what it has found") {
  Scout scout({{"fov_deg", 40.0}});
  scout.mount.x = 0.0;
  const auto sketch_now = [&] {
    scout.look();
    Sketch sketch(Frame{});
    scout.watcher().sensor().sketch(sketch);
    return sketch;
  };
  const Sketch blind = sketch_now();
  for (const Sketch::Mark& mark : blind.marks()) CHECK(mark.role == SketchRole::range);
  const double bearing = radians(8.0);
  scout.world.obstacles = {resource(2.0 * std::cos(bearing), 2.0 * std::sin(bearing))};
  const Sketch sketch = sketch_now();
  const Sketch::Mark& found = sketch.marks().back();
  CHECK(found.role == SketchRole::hit);
  REQUIRE(found.count == 2);
  const Vector3& end = sketch.places(found)[1];
  CHECK(std::atan2(end.y, end.x) == Approx(bearing).margin(0.01));
}
