#include "random_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "elsie/api/simulator_events.h"
#include "elsie/base/words.h"
#include "elsie/plugin/kind_name.h"

namespace elsie::testing {
namespace {

constexpr double kPi = std::numbers::pi;

Colour random_colour(Random& random) {
  const std::array colours{kRed, kGreen, kBlue, Colour{255, 255, 255}, Colour{230, 200, 20}};
  return colours[index(random, colours.size())];
}

double random_distance(double max_range, Random& random) {
  return random.chance(0.3) ? max_range : random.chance(0.1) ? 0.0 : random.uniform(0.0, max_range);
}

VisionReading random_view(double fov_rad, bool with_pictures, Random& random) {
  VisionReading view;
  view.horizontal_fov_rad = fov_rad;
  if (with_pictures) {
    view.raw = random_picture(view.width, view.height, random);
    view.processed = mask_of(view.raw, kRed);
  }
  view.found = random.chance(0.7);
  if (view.found) {
    view.column = random.uniform(0.0, view.width);
    view.row = random.uniform(0.0, view.height);
    view.area_px = random.uniform(1.0, view.width * view.height);
  }
  return view;
}

Response random_wish(Random& random) {
  const std::array extremes{0.0, 1e-12, 5.0, -5.0, 25.0, 1e3};
  const auto number = [&] {
    return random.chance(0.7) ? random.uniform(-30, 30) : extremes[index(random, 6)];
  };
  const auto degree = [&] { return random.chance(0.3) ? 0.0 : random.uniform(); };
  Response wish({number(), number()});
  wish.activation = degree();
  wish.strength = degree();
  wish.speed_strength = degree();
  wish.turn_strength = degree();
  return wish;
}

/// Changes a situation from one instant to the next, within what a body can do.
void move(Situation& now, Random& random) {
  OwnState& self = now.self;
  const double speed = std::clamp(self.moving.forward + random.uniform(-0.1, 0.1), -0.5, 0.5);
  const double turn = std::clamp(self.moving.turn + random.uniform(-1.0, 1.0), -5.0, 5.0);
  now.moving(speed, turn);
  if (random.chance(0.02)) {
    now.at(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-180, 180));
  }
  self.pose.x += speed * kPeriod * std::cos(self.pose.heading_rad);
  self.pose.y += speed * kPeriod * std::sin(self.pose.heading_rad);
  self.pose.heading_rad = wrap_angle(self.pose.heading_rad + turn * kPeriod);
  const double limit = self.max_wheel_rate();
  const double left = random.uniform(-limit, limit);
  self.commanded = self.wheels.motion({left, random.uniform(-limit, limit)});
  self.energy =
      random.chance(0.05) ? random.uniform(1e-3, self.capacity) : std::max(1e-3, self.energy - 1.0);
  self.charging = now.team.charger && random.chance(0.2);
  if (now.team.nest) {
    // By the battery, so that other input stays as it is.
    const auto phase = static_cast<std::size_t>(self.energy) / 10;
    static constexpr HeldThing kThings[] = {{"thing", "gripper", true},
                                            {"thing", "gripper", false}};
    self.held = std::span(kThings).subspan(phase % 2, phase / 2 % 2);
  }
}

}  // namespace

Image random_picture(int width, int height, Random& random) {
  Picture picture(width, height);
  for (int blobs = static_cast<int>(random.uniform(0, 4)); blobs > 0; --blobs) {
    picture.disc(random.uniform(0, width), random.uniform(0, height),
                 random.uniform(0, 0.3 * std::min(width, height)) + 1.0, random_colour(random));
  }
  return picture.image();
}

/// Every second robot is round.
world::Robot random_robot(int number, const Vector2& at, Random& random) {
  world::Robot robot;
  robot.id = "robot" + std::to_string(number);
  robot.x = at.x;
  robot.y = at.y;
  robot.leader = random.chance(0.3);
  robot.heading_deg = random.uniform(-180, 180);
  robot.body.round = number % 2 == 1;
  return robot;
}

Surroundings random_surroundings(const Colour& colour, bool has_company, Random& random) {
  const auto place = [&](double furthest = 3.0) {
    const double angle = random.uniform(-kPi, kPi), distance = random.uniform(0.3, furthest);
    return Vector2{distance * std::cos(angle), distance * std::sin(angle)};
  };
  Surroundings around;
  around.resource(100.0, 100.0, colour);  // out of sight, so that all scenes have the same colours
  const int things = static_cast<int>(random.uniform(0, 8));
  int robots = 0;
  if (has_company) {
    around.robot(random_robot(robots++, place(0.6), random));
  }
  for (int i = 0; i < things; ++i) {
    const Vector2 at = place();
    switch (index(random, 4)) {
      case 0:
        around.wall(at.x, at.y, at.x + random.uniform(0.1, 2.0), at.y + random.uniform(-1.0, 1.0));
        break;
      case 1:
        around.robot(random_robot(robots++, at, random));
        break;
      case 2:
        around.resource(at.x, at.y, colour);
        break;
      default:
        around.box(at.x, at.y);
    }
  }
  return around;
}

Input as_a_mate(Input input) {
  for (Situation& now : input.instants) {
    now.self.id = kFirstMate;
    now.self.is_leader = !now.self.is_leader;
    now.self.team_index = now.self.team_index == 0 ? 1 : 0;
  }
  return input;
}

/// The parts of a robot that are constant in a run.
struct InputMaker::Layout {
  struct Eye {
    double azimuth_deg;
    double value;  // a beam's range in m, a camera's field of view in degrees
  };
  Situation body;
  std::vector<Eye> beams, switches, cameras;
  std::size_t mates = 0;
  bool has_leader = false;
  std::string words;
};

int InputMaker::robots() const {
  if (plugin::is_of_world(declaration_.kind)) {
    return options_.scenes.empty() ? 6 : static_cast<int>(options_.scenes.size());
  }
  return options_.robots.empty() ? 6 : static_cast<int>(options_.robots.size());
}

InputMaker::Layout InputMaker::layout(int robot, Random& random) const {
  Layout made;
  const auto around = [&](std::size_t n, double value, std::vector<Layout::Eye>& eyes) {
    for (std::size_t i = 0; i < n; ++i) {
      eyes.push_back({random.uniform(-180, 180), value});
    }
  };
  switch (robot) {
    case 0:  // the robot of most worlds
      made.beams = {{15, 1.0}, {-15, 1.0}};
      made.cameras = {{0, 30}};
      made.body.charger(1, 1);
      break;
    case 1:
      for (int i = 0; i < 8; ++i) {
        made.beams.push_back({45.0 * i - 180.0, 2.0});
      }
      around(2, 0.5, made.switches);
      made.cameras = {{0, 60}, {-60, 60}};
      made.mates = 3;
      made.has_leader = true;
      made.body.nest(1, 1);
      break;
    case 2:
      made.beams = {{0, 0.5}};
      made.mates = 1;
      made.body.self.is_leader = true;
      break;
    case 3:
      break;  // only the sensors that it needs
    default:
      around(index(random, 9), random.uniform(0.1, 5.0), made.beams);
      around(index(random, 4), random.uniform(0.1, 1.0), made.switches);
      around(index(random, 3), random.uniform(10, 120), made.cameras);
      made.mates = index(random, 5);
      made.has_leader = random.chance(0.5);
      if (random.chance(0.5)) {
        made.body.charger(random.uniform(-5, 5), random.uniform(-5, 5));
      }
      made.body.self.team_index = static_cast<int>(index(random, 5));
  }
  for (const ReadingDeclaration& need : declaration_.needs) {
    if (need.kind == RangeReading::kind && made.beams.empty()) {
      made.beams = {{0, 1.0}};
    } else if (need.kind == ProximityReading::kind && made.switches.empty()) {
      made.switches = {{0, 0.5}};
    } else if (need.kind == VisionReading::kind && made.cameras.empty()) {
      made.cameras = {{0, 30}};
    }
  }
  made.words = "a robot with " + base::counted(made.beams.size(), "range sensor") + ", " +
               base::counted(made.switches.size(), "proximity sensor") + ", " +
               base::counted(made.cameras.size(), "camera") + " and " +
               base::counted(made.mates, "mate");
  return made;
}

void InputMaker::add_own_kinds(Situation& now, Random& random) const {
  for (const ReadingDeclaration& need : declaration_.needs) {
    const bool is_there = need.kind == RangeReading::kind || need.kind == ProximityReading::kind ||
                          need.kind == VisionReading::kind;
    if (is_there || options_.add_readings) {
      continue;
    }
    const auto sensors = plugins_.host().all(PluginKind::sensor);
    const auto maker = std::find_if(sensors.begin(), sensors.end(), [&](const Declaration* sensor) {
      return !sensor->produces.empty() && sensor->produces[0].kind == need.kind &&
             sensor->produces[0].fits(need);
    });
    if (maker == sensors.end()) {
      throw std::runtime_error("it needs readings of the kind '" + need.kind +
                               "', but no sensor that was found makes them, so it could not be "
                               "tested; put the sensor's library into the plugin path, or give the "
                               "checker add_readings");
    }
    // Two beside each other, new ones for each instant, so that their readings stay in place.
    for (const double side : {1.0, -1.0}) {
      const Mounting mounting{{0.03, 0.02 * side, 0.05}, 0.3 * side, 0.0};
      const auto sensor = std::make_shared<Sensor>(plugins_, (*maker)->name);
      sensor->mounted(mounting);
      sensor->reset(random.bits());
      Surroundings around = random_surroundings(random_colour(random), false, random);
      around.at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-180, 180));
      if (const auto camera = (*sensor)->camera()) {
        const Image picture = random_picture(camera->width, camera->height, random);
        sensor->update(around, &picture);
      } else {
        sensor->update(around, nullptr);
      }
      now.sensed((*sensor)->kind(), {sensor, (*sensor)->reading()}, mounting, "",
                 &(*maker)->produces.front());
    }
  }
}

/// Mostly one; every second from a device that does not know where it comes from.
void InputMaker::add_message(Situation& now, Random& random) const {
  if (random.chance(0.4)) return;
  const HeardDeclaration& kind = declaration_.hears[index(random, declaration_.hears.size())];
  const double scale = random.chance(0.8) ? 1.0 : 1e3;
  HeardMessage heard;
  heard.message = std::make_shared<const AnyMessage>(kind.make([&](const ReadingField& field) {
    for (std::size_t i = 0; field.is_number() && field.is_stored && i < field.count; ++i) {
      field.set_number(i, scale * random.uniform(-3.0, 10.0));
    }
  }));
  heard.device = "device";
  heard.from = random.chance(0.2) ? "" : kFirstMate;
  heard.age_s = random.chance(0.5) ? 0.0 : random.uniform(0.0, 2.0);
  if (random.chance(0.5)) {
    heard.distance_m = random.uniform(0.0, 5.0);
    heard.bearing_rad = random.uniform(-kPi, kPi);
    heard.elevation_rad = random.uniform(-0.5, 0.5);
  }
  now.hear(heard);
}

Input InputMaker::make_driven(int robot, Random& random) {
  Input input;
  input.robot = robot == 0 ? "a robot of the usual size" : "a robot of another size";
  if (robot > 0) {
    Chassis& chassis = input.chassis;
    const double scale = random.uniform(0.5, 10.0);
    chassis.length = scale * random.uniform(0.06, 0.16);
    chassis.width = scale * random.uniform(0.06, 0.16);
    chassis.height = scale * random.uniform(0.02, 0.1);
    chassis.clearance = scale * random.uniform(0.005, 0.015);
    chassis.wheel_radius = scale * random.uniform(0.012, 0.02);
    chassis.wheel_width = scale * random.uniform(0.004, 0.01);
    chassis.half_axle = 0.5 * (chassis.width + chassis.wheel_width);
    input.max_speed = random.uniform(0.05, 3.0);
  }
  for (std::size_t i = 0; i < kInstants; ++i) {
    const double most = 3.0 * input.max_speed;
    const bool stops = random.chance(0.1);
    Motion asked;
    if (!stops) {
      asked = {random.uniform(-most, most), random.uniform(-most, most), random.uniform(-20, 20)};
    }
    // Each channel alone, too.
    if (random.chance(0.2)) asked.forward = 0.0;
    if (random.chance(0.3)) asked.lateral = 0.0;
    if (random.chance(0.2)) asked.turn = 0.0;
    input.asked.push_back(asked);
  }
  return input;
}

Input InputMaker::make(int robot, Random& random) const {
  if (plugin::is_of_world(declaration_.kind)) {
    return make_watched(robot, random);
  }
  if (declaration_.kind == PluginKind::drive || declaration_.kind == PluginKind::localisation) {
    return make_driven(robot, random);
  }
  Input input;
  input.mounting = {
      {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(0.01, 0.3)},
      random.uniform(-kPi, kPi),
      random.chance(0.5) ? 0.0 : random.uniform(-0.5, 0.5)};
  if (declaration_.kind == PluginKind::sensor) {
    input.robot = "a robot in random surroundings";
    const Colour colour = random_colour(random);
    for (int i = 0; i < 3; ++i) {
      input.scenes.push_back(
          std::make_shared<Surroundings>(random_surroundings(colour, i == 0, random)));
    }
    for (std::size_t i = 0; i < kInstants; ++i) {
      input.poses.push_back(
          {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-kPi, kPi)});
    }
    return input;
  }
  const bool given = !options_.robots.empty();
  const Layout made = given ? Layout() : layout(robot, random);
  Situation now = given ? options_.robots[static_cast<std::size_t>(robot)] : made.body;
  input.robot = given ? "robot " + std::to_string(robot + 1) + " of those given" : made.words;

  std::vector<std::string> events;
  for (const events::Facts& event : events::of_simulator()) {
    if (event.is_perceived) {
      events.emplace_back(event.name);
    }
  }
  for (const EventDeclaration& event : declaration_.events) {
    events.push_back(event.name);
  }
  for (const std::string& event : declaration_.reacts_to) {
    if (!events::find(event)) {
      events.push_back(event);
    }
  }
  const bool looks =
      std::any_of(declaration_.needs.begin(), declaration_.needs.end(),
                  [](const ReadingDeclaration& need) { return need.kind == VisionReading::kind; });
  std::vector<double> ranges;
  for (const Layout::Eye& beam : made.beams) {
    ranges.push_back(random_distance(beam.value, random));
  }
  for (std::size_t step = 0; step < kInstants; ++step) {
    move(now, random);
    Situation instant = now;
    for (std::size_t i = 0; i < made.beams.size(); ++i) {
      const Layout::Eye& beam = made.beams[i];
      // Mostly, things continue as before.
      ranges[i] = random.chance(0.1)
                      ? random_distance(beam.value, random)
                      : std::clamp(ranges[i] + random.uniform(-0.02, 0.02), 0.0, beam.value);
      instant.beam(beam.azimuth_deg, ranges[i], beam.value);
    }
    for (const Layout::Eye& eye : made.switches) {
      instant.proximity(eye.azimuth_deg, random.chance(0.3), eye.value);
    }
    for (const Layout::Eye& eye : made.cameras) {
      instant.view(random_view(radians(eye.value), looks, random), eye.azimuth_deg);
    }
    for (std::size_t i = 0; i < made.mates; ++i) {
      if (random.chance(0.8)) {  // else out of reach
        instant.mate("mate" + std::to_string(i), now.self.pose.x + random.uniform(-2, 2),
                     now.self.pose.y + random.uniform(-2, 2), made.has_leader && i == 0,
                     random.uniform(-180, 180), static_cast<int>(i));
      }
    }
    if (random.chance(0.2)) {
      instant.event(events[index(random, events.size())]);
    }
    if (!declaration_.hears.empty()) {
      add_message(instant, random);
    }
    if (!given) {  // a given robot keeps its sensors
      add_own_kinds(instant, random);
    }
    if (options_.add_readings) {
      options_.add_readings(instant, random);
    }
    input.instants.push_back(instant.time(static_cast<double>(step) * kPeriod).period(kPeriod));
  }

  input.members = options_.members;
  if (input.members.empty() && declaration_.kind == PluginKind::coordinator) {
    // Two on the usual robot, none on one of the others.
    const std::size_t members = robot == 0 ? 2 : robot == 3 ? 0 : 1 + index(random, 5);
    for (std::size_t i = 0; i < members; ++i) {
      input.members.push_back("member" + std::to_string(i + 1));
    }
  }
  for (std::size_t i = 0; i < input.members.size(); ++i) {
    input.priorities.push_back(random.chance(0.5) ? 1.0 : random.uniform(-3, 10));
  }
  for (std::size_t step = 0; step < kInstants; ++step) {
    std::vector<Response>& wishes = input.wishes.emplace_back();
    std::generate_n(std::back_inserter(wishes), std::max<std::size_t>(1, input.members.size()),
                    [&] { return random_wish(random); });
  }
  return input;
}

}  // namespace elsie::testing
