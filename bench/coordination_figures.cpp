// One world with several coordinators, over the same seeds.
//
//   coordination_figures WORLD.xml [--seeds N] --variant LABEL [PATH=VALUE...] [--variant ...]
//
// Seeds 1 to N (20). A variant is the world with these edits, as in `elsie run --set`. Prints
// rows of a table in Markdown: variant, number of runs that reached the goals, resources collected,
// distance (m) and time (s) as mean and standard deviation over all runs, the same over successful
// runs, and contacts.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "statistics.h"

namespace {

using elsie::bench::mean;
using elsie::bench::mean_and_deviation;

struct Variant {
  std::string label;
  std::vector<std::string> edits;
};

struct Order {
  std::string world;
  int seeds = 20;
  std::vector<Variant> variants;
};

Order order_of(int argc, char** argv) {
  Order order;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool has_next = i + 1 < words.size();
    if (words[i] == "--seeds" && has_next) {
      order.seeds = std::atoi(words[++i].c_str());
    } else if (words[i] == "--variant" && has_next) {
      order.variants.push_back({words[++i], {}});
    } else if (order.world.empty()) {
      order.world = words[i];
    } else if (!order.variants.empty()) {
      order.variants.back().edits.push_back(words[i]);
    }
  }
  return order;
}

struct Figures {
  std::vector<double> distance_m, time_s, collected, contacts;
  std::vector<double> distance_of_successes_m, time_of_successes_s;
};

Figures run(elsie::world::World world, const elsie::plugin::Host& host, int seeds) {
  Figures figures;
  elsie::simulation::Simulation simulation(std::move(world), host,
                                           {.cameras = elsie::render::world_cameras});
  for (int seed = 1; seed <= seeds; ++seed) {
    simulation.reset(static_cast<std::uint64_t>(seed));
    const auto result = simulation.run();
    double distance = 0.0, collected = 0.0, contacts = 0.0;
    for (const auto& robot : result.robots) {
      distance += robot.distance_m;
      collected += robot.collected;
      contacts += robot.collisions;
    }
    figures.distance_m.push_back(distance);
    figures.time_s.push_back(result.simulated_s);
    figures.collected.push_back(collected);
    figures.contacts.push_back(contacts);
    if (result.outcome == elsie::simulation::Outcome::success) {
      figures.distance_of_successes_m.push_back(distance);
      figures.time_of_successes_s.push_back(result.simulated_s);
    }
  }
  return figures;
}

}  // namespace

int main(int argc, char** argv) try {
  const Order order = order_of(argc, argv);
  if (order.world.empty() || order.seeds < 1 || order.variants.empty()) {
    std::fprintf(stderr,
                 "usage: coordination_figures WORLD.xml [--seeds N] "
                 "--variant LABEL [PATH=VALUE...] [--variant ...]\n");
    return 2;
  }
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  for (const Variant& variant : order.variants) {
    elsie::world::ReadOptions options;
    options.data_directories = {ELSIE_SOURCE_DIR};
    options.edits = variant.edits;
    const Figures figures =
        run(elsie::world::read_world(order.world, host, options), host, order.seeds);
    std::printf("| %s | %zu of %d | %.2f | %s | %s | %s | %s | %.2f |\n", variant.label.c_str(),
                figures.time_of_successes_s.size(), order.seeds, mean(figures.collected),
                mean_and_deviation(figures.distance_m, 2).c_str(),
                mean_and_deviation(figures.time_s, 1).c_str(),
                mean_and_deviation(figures.distance_of_successes_m, 2).c_str(),
                mean_and_deviation(figures.time_of_successes_s, 1).c_str(), mean(figures.contacts));
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
