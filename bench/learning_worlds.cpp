// The worlds that environments for learning step, without Python: what their speed is compared
// with.
//
//   learning_worlds --write ROBOTS      the world: arena_of_robots.h on `planar`
//   learning_worlds WORLDS ROBOTS STEPS THREADS [--seconds S]
//
// Sets a random motion for each robot before every STEPS steps of the physics, in threads; prints
// robot-steps per second.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "elsie/base/random.h"
#include "elsie/base/thread_pool.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/writer.h"

#include "arena_of_robots.h"

namespace {

elsie::world::World arena(int robots) {
  elsie::world::World world = elsie::bench::arena_of_robots(robots);
  world.physics.engine = "planar";
  return world;
}

/// A world whose robots do what is set.
class Commanded {
 public:
  Commanded(const elsie::plugin::Host& host, int robots)
      : declared_(*host.find(elsie::PluginKind::behavior, "commanded")),
        simulation_(commanded(robots), host) {
    for (std::size_t i = 0; i < simulation_.robots(); ++i) {
      objects_.push_back(&simulation_.object(i, simulation_.world().robots[i].behaviors.front()));
    }
  }

  void step(int steps) {
    for (elsie::Component* object : objects_) {
      set(*object, "forward", random_.uniform(-0.5, 0.5));
      set(*object, "turn", random_.uniform(-11.0, 11.0));
      object->configured();
    }
    for (int i = 0; i < steps; ++i) simulation_.step();
  }

 private:
  static elsie::world::World commanded(int robots) {
    elsie::world::World world = arena(robots);
    for (elsie::world::Robot& robot : world.robots) {
      robot.behaviors.front().plugin = robot.behaviors.front().id = "commanded";
    }
    return world;
  }
  void set(elsie::Component& object, const char* name, double value) const {
    std::find_if(declared_.parameters.begin(), declared_.parameters.end(), [&](const auto& each) {
      return each.name == name;
    })->set(object, value);
  }

  const elsie::Declaration& declared_;
  elsie::simulation::Simulation simulation_;
  std::vector<elsie::Component*> objects_;
  elsie::Random random_;
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc == 3 && argv[1] == std::string("--write")) {
    std::fputs(elsie::world::write_world(arena(std::atoi(argv[2]))).c_str(), stdout);
    return 0;
  }
  if (argc != 5 && argc != 7) {
    std::fprintf(stderr, "usage: learning_worlds WORLDS ROBOTS STEPS THREADS [--seconds S]\n");
    return 2;
  }
  const int worlds = std::atoi(argv[1]), robots = std::atoi(argv[2]), steps = std::atoi(argv[3]);
  const double seconds = argc == 7 ? std::atof(argv[6]) : 1.0;
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  std::vector<std::unique_ptr<Commanded>> all;
  for (int i = 0; i < worlds; ++i) all.push_back(std::make_unique<Commanded>(host, robots));
  elsie::base::ThreadPool pool(static_cast<std::size_t>(std::max(1, std::atoi(argv[4]))));
  const auto step = [&] {
    pool.divide(all.size(), 1, [&](const elsie::base::ThreadPool::Share& share) {
      for (std::size_t i = share.first; i < share.end; ++i) all[i]->step(steps);
    });
  };
  for (int i = 0; i < 100 / steps; ++i) step();  // so that robots have spread
  const auto start = std::chrono::steady_clock::now();
  double taken = 0.0, made = 0.0;
  while (taken < seconds) {
    step();
    made += static_cast<double>(worlds) * robots * steps;
    taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::printf("%.0f\n", made / taken);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
