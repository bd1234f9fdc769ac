#include "elsie/testing/world.h"

#include <cmath>

#include "elsie/base/near_name.h"
#include "elsie/render/world_cameras.h"
#include "elsie/world/reader.h"

namespace elsie::testing {
namespace {

world::ReadOptions read_options(const WorldOptions& options, std::uint64_t seed) {
  world::ReadOptions how;
  how.seed = seed;
  how.edits = options.set;
  how.data_directories = data_directories();
  how.check_plugins = true;
  return how;
}

}  // namespace

World World::from_file(const std::string& file, const WorldOptions& options,
                       const Plugins& plugins) {
  return {[=, host = plugins](std::uint64_t seed) {
            return world::read_world(file, host.host(), read_options(options, seed));
          },
          options, plugins};
}

World World::from_text(std::string_view xml, const WorldOptions& options, const Plugins& plugins) {
  return {[=, text = std::string(xml), host = plugins](std::uint64_t seed) {
            return world::parse_world(text, "world in a test", host.host(),
                                      read_options(options, seed));
          },
          options, plugins};
}

World::World(std::function<world::World(std::uint64_t)> read, const WorldOptions& options,
             const Plugins& plugins)
    : plugins_(plugins), read_(std::move(read)) {
  begin(options.seed);
}

void World::begin(std::uint64_t seed) {
  simulation_ = std::make_unique<simulation::Simulation>(
      read_(seed), plugins_.host(),
      simulation::Options{.seed = seed, .cameras = render::world_cameras});
}

World& World::step(int steps) {
  for (int i = 0; i < steps; ++i) {
    simulation_->step();
  }
  return *this;
}

World& World::run_for(double seconds) {
  return step(static_cast<int>(std::lround(seconds / simulation_->world().physics.step)));
}

bool World::run_until(const std::function<bool(const World&)>& reached, double seconds) {
  const auto steps = std::lround(seconds / simulation_->world().physics.step);
  for (long i = 0; i < steps && !reached(*this); ++i) {
    step();
  }
  return reached(*this);
}

simulation::RunResult World::run() {
  simulation_->reset();
  return simulation_->run();
}

World& World::reset(std::uint64_t seed) {
  // Layouts that are drawn from the run's seed are others with this one.
  const auto& drawn = simulation_->world().drawn;
  if (drawn && drawn->by_run) {
    begin(seed);
  } else {
    simulation_->reset(seed);
  }
  return *this;
}

std::size_t World::index_of(const std::string& robot) const {
  const auto& robots = simulation_->world().robots;
  std::vector<std::string_view> ids;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots[i].id == robot) {
      return i;
    }
    ids.emplace_back(robots[i].id);
  }
  throw std::invalid_argument("there is no robot '" + robot + "' in the world" +
                              base::did_you_mean(robot, ids));
}

simulation::RobotView World::robot(const std::string& id) const {
  return simulation_->robot(index_of(id));
}

const TraceRow& World::trace(const std::string& robot, const std::string& behavior) const {
  std::vector<std::string_view> paths;
  const simulation::RobotView view = this->robot(robot);
  for (const simulation::TracedMember& member : view.trace) {
    if (member.path == behavior) {
      return member.member->trace;
    }
    paths.emplace_back(member.path);
  }
  throw std::invalid_argument("robot '" + robot + "' has no behavior '" + behavior + "'" +
                              base::did_you_mean(behavior, paths));
}

const void* World::reading(const std::string& robot, const std::string& sensor,
                           const ReadingKind& kind) const {
  const std::size_t index = index_of(robot);
  std::vector<std::string_view> ids;
  for (std::size_t i = 0; i < simulation_->sensors(index); ++i) {
    const simulation::SensorView view = simulation_->sensor(index, i);
    if (view.id == sensor) {
      if (!(view.sensor->kind() == kind)) {
        throw std::invalid_argument("sensor '" + sensor + "' of robot '" + robot +
                                    "' makes readings of the kind '" + view.sensor->kind().name +
                                    "', not '" + kind.name + "'");
      }
      return view.sensor->reading();
    }
    ids.push_back(view.id);
  }
  throw std::invalid_argument("robot '" + robot + "' has no sensor '" + sensor + "'" +
                              base::did_you_mean(sensor, ids));
}

int World::count(std::string_view event, std::string_view robot) const {
  int count = 0;
  for (const simulation::EventRecord& record : simulation_->events()) {
    count += record.name() == event && (robot.empty() || record.robot == robot);
  }
  return count;
}

std::optional<double> World::measured(const std::string& name) const {
  std::vector<std::string> names;
  for (const simulation::MeasuredValue& measured : simulation_->result().measures) {
    if (measured.name == name) {
      return measured.value;
    }
    names.push_back(measured.name);
  }
  throw std::invalid_argument("the run has no measure '" + name + "'" +
                              base::did_you_mean(name, names));
}

}  // namespace elsie::testing
