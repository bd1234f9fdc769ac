// Runs a world, watches who decides, and prints the result.
//   own_program [WORLD] [SEED]
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>

#include <elsie/plugin/host.h>
#include <elsie/render/world_cameras.h>
#include <elsie/simulation/simulation.h>
#include <elsie/world/data_directories.h>
#include <elsie/world/reader.h>

namespace simulation = elsie::simulation;
namespace world = elsie::world;

// It is called after every step. It may look at everything and changes nothing.
class Deciders final : public simulation::Observer {
 public:
  std::map<std::string, double> seconds;  // by behaviour: its share in the command, over time

  void stepped(const simulation::Simulation& now) override {
    for (const elsie::Member& member : now.robot(0).members) {
      seconds[std::string(member.name())] += member.trace.share * now.world().physics.step;
    }
  }
};

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : "worlds/contexts.xml";
  simulation::Options options;
  options.cameras = elsie::render::world_cameras;  // for worlds that have some
  options.seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  try {
    const elsie::plugin::Host host(elsie::plugin::default_search_path());
    world::ReadOptions reading;
    reading.data_directories = world::default_data_directories();
    reading.check_plugins = true;
    simulation::Simulation run(world::read_world(file, host, reading), host, options);

    Deciders deciders;
    simulation::Observer* const observers[] = {&deciders};
    const simulation::RunResult result = run.run(observers);

    std::printf("%s after %.1f s: %s\n", simulation::to_string(result.outcome), result.simulated_s,
                result.reason.c_str());
    for (const simulation::RobotResult& robot : result.robots) {
      std::printf("robot %s drove %.2f m and touched something %d times\n", robot.id.c_str(),
                  robot.distance_m, robot.collisions);
    }
    for (const auto& [behavior, seconds] : deciders.seconds) {
      std::printf("%s decided for %.1f s\n", behavior.c_str(), seconds);
    }
    std::printf("state hash %s\n", simulation::hash_text(result.state_hash).c_str());
    return result.outcome == simulation::Outcome::success ? 0 : 1;
  } catch (const elsie::base::Error& error) {  // a sentence, or a line for each mistake of a file
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();  // 2: bad input, 3: a plugin failed, 4: anything else
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
}
