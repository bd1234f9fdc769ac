// What a decision costs under each coordinator, for each behaviour that it asks, against
// arbiter_subsumption: with the set-ups of experiments/every_coordinator.xml, two beams, a camera,
// and behaviours that answer at once. Processor time on one core, in turn. Prints Markdown.
//
//   coordinators [--repeats N]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"
#include "elsie/experiment/reader.h"
#include "elsie/testing/coordinator.h"
#include "elsie/testing/plugins.h"

#include "statistics.h"

namespace {

using namespace elsie;

constexpr int kDecisions = 5000;
constexpr const char* kReference = "arbiter_subsumption";

/// A coordinator with members that answer at once.
struct Robot {
  explicit Robot(const world::Robot& described) {
    double side = 1.0;
    for (const world::BehaviorUse& use : described.behaviors) {
      team.member(use.id, use.priority,
                  testing::active(0.6 - 0.1 * side, testing::wheels(10.0 + side, 10.0 - side)));
      side = -side;
    }
    const world::PluginUse& use = *described.coordinator;
    coordinator = std::make_unique<testing::Coordinator>(use.plugin, team, use.parameters,
                                                         world::values_of(use.elements));
    coordinator->now.beam(15, 0.45).beam(-15, 0.7).blob(60);
    coordinator->decide();
  }

  /// Processor time of a decision for each member that it asks, ns.
  double cost() {
    const Perception now = coordinator->now.perception();
    long asked = 0;
    const std::clock_t start = std::clock();
    for (int i = 0; i < kDecisions; ++i) {
      team.next_step();
      (*coordinator)->coordinate(team.members(), now);
      for (const Member& member : team.members()) asked += member.trace.asked ? 1 : 0;
    }
    members_asked = static_cast<double>(asked) / kDecisions;
    return 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
           static_cast<double>(std::max(asked, 1L));
  }

  testing::Team team;
  std::unique_ptr<testing::Coordinator> coordinator;
  double members_asked = 0.0;
};

/// Those that evaluate a network, a fuzzy model or conditions, whatever they ask.
bool infers(const std::string& name) {
  return name.ends_with("neural_network") || name.ends_with("tree") || name.ends_with("states") ||
         name.ends_with("context_blending") || name.ends_with("spreading_activation") ||
         name.ends_with("learning");
}

/// The robots of the experiment's first world by their coordinators' names, at the first level of
/// all other factors.
std::vector<std::pair<std::string, world::Robot>> set_ups() {
  const std::string file = ELSIE_SOURCE_DIR "/experiments/every_coordinator.xml";
  const plugin::Host& host = testing::Plugins::found().host();
  experiment::ReadOptions options;
  options.data_directories = {ELSIE_SOURCE_DIR};
  const experiment::Experiment study = experiment::read_experiment(file, host, options);
  std::vector<std::pair<std::string, world::Robot>> found;
  for (const experiment::Cell& cell : experiment::cells(study)) {
    const auto others = std::count_if(cell.levels.begin() + 1, cell.levels.end(),
                                      [](std::size_t level) { return level != 0; });
    if (cell.world != 0 || others != 0) continue;
    const world::Robot robot = experiment::read_cell(study, cell, host, options).robots.at(0);
    found.emplace_back(robot.coordinator.value().plugin, robot);
  }
  return found;
}

void table(const std::string& head, std::vector<std::pair<std::string, world::Robot>> all,
           Robot& reference, int repeats) {
  std::printf(
      "%s\n\n| coordinator | behaviours asked | ns for each | of `%s`'s | spread |\n"
      "|---|---|---|---|---|\n",
      head.c_str(), kReference);
  for (const auto& [name, described] : all) {
    Robot robot(described);
    std::vector<double> times, ratios;
    for (int i = 0; i < repeats; ++i) {  // in turn, because machines drift
      const double of_reference = reference.cost();
      times.push_back(robot.cost());
      ratios.push_back(times.back() / of_reference);
    }
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    std::printf("| `%s` | %.3g | %.0f | %.2f | %.2f to %.2f |\n", name.c_str(), robot.members_asked,
                bench::median(times), bench::median(ratios), *least, *most);
    std::fflush(stdout);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) try {
  int repeats = 15;
  if (argc == 3 && std::string(argv[1]) == "--repeats") {
    repeats = std::atoi(argv[2]);
  } else if (argc != 1) {
    repeats = 0;
  }
  if (repeats < 1) {
    std::fprintf(stderr, "usage: coordinators [--repeats N]\n");
    return EXIT_FAILURE;
  }
  std::vector<std::pair<std::string, world::Robot>> plain, inferring;
  const world::Robot* described = nullptr;
  const auto all = set_ups();
  for (const auto& one : all) {
    (infers(one.first) ? inferring : plain).push_back(one);
    if (one.first == kReference) described = &one.second;
  }
  if (!described) throw std::runtime_error(std::string("no level has ") + kReference);
  Robot reference(*described);
  table("From the behaviours' answers alone:", plain, reference, repeats);
  table("With conditions, models or networks of their own:", inferring, reference, repeats);
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "coordinators: %s\n", error.what());
  return EXIT_FAILURE;
}
