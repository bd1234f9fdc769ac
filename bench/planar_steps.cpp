// Robot-steps per second of a whole simulation with the planar engine (sensors, behaviours,
// coordinator, physics) compared with Enki and with a bare loop, in one process.
//
//   planar_steps [--repeats N] [--robots N]...
//
// World: arena_of_robots.h. All get the same poses, boxes and rule. They are run in turn, and the
// ratios are taken round by round, because machines drift. Prints a table in Markdown.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"

#include "arena_of_robots.h"
#include "bare_enki.h"
#include "bare_plane.h"
#include "statistics.h"

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kStepsInAll = 200'000;  // robot-steps in one measurement, before and after a start
constexpr int kMostForEnki = 1'000;   // its cost grows with the square of the robots

template <class Side>
double rate(Side& side, int robots) {
  const int steps = std::max(10, kStepsInAll / robots);
  for (int i = 0; i < steps / 4; ++i) side.step();  // the robots spread
  const auto start = Clock::now();
  for (int i = 0; i < steps; ++i) side.step();
  return static_cast<double>(steps) * robots /
         std::chrono::duration<double>(Clock::now() - start).count();
}

std::string ratio_and_spread(const std::vector<double>& ratios) {
  if (ratios.empty()) return "- | -";
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  char text[64];
  std::snprintf(text, sizeof(text), "%.2f | %.2f to %.2f", elsie::bench::median(ratios), *low,
                *high);
  return text;
}

void compare(const elsie::plugin::Host& host, int robots, int repeats) {
  elsie::world::World arena = elsie::bench::arena_of_robots(robots);
  arena.physics.engine = "planar";
  const auto poses = elsie::bench::poses_of(arena);
  elsie::simulation::Simulation simulation(arena, host);
  std::vector<double> ours, enkis, planes, to_enki, to_plane;
  for (int i = 0; i < repeats; ++i) {
    simulation.reset();
    ours.push_back(rate(simulation, robots));
    if (robots <= kMostForEnki) {
      elsie::bench::BareEnki enki(poses, arena.boxes, arena.physics, arena.arena,
                                  elsie::bench::steer);
      enkis.push_back(rate(enki, robots));
      to_enki.push_back(ours.back() / enkis.back());
    }
    elsie::bench::BarePlane plane(poses, arena.boxes, arena.physics, arena.arena);
    planes.push_back(rate(plane, robots));
    to_plane.push_back(planes.back() / ours.back());
  }
  const std::string enki =
      enkis.empty() ? "-" : std::to_string(std::lround(elsie::bench::median(enkis)));
  std::printf("| %d | %.0f | %s | %s | %.0f | %s |\n", robots, elsie::bench::median(ours),
              enki.c_str(), ratio_and_spread(to_enki).c_str(), elsie::bench::median(planes),
              ratio_and_spread(to_plane).c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  int repeats = 15;
  std::vector<int> robots;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    const int value = std::atoi(argv[i + 1]);
    if (option == "--repeats") {
      repeats = value;
    } else if (option == "--robots") {
      robots.push_back(value);
    }
  }
  if (argc % 2 == 0 || repeats < 1 ||
      std::any_of(robots.begin(), robots.end(), [](int n) { return n < 1; })) {
    std::fprintf(stderr, "usage: planar_steps [--repeats N] [--robots N]...\n");
    return 2;
  }
  if (robots.empty()) robots = {1, 10, 100};
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  std::printf(
      "| robots | Elsie, robot-steps/s | Enki, robot-steps/s | times Enki | spread | bare loop, "
      "robot-steps/s | cost in bare loops | spread |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (const int count : robots) compare(host, count, repeats);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
