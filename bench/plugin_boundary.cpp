// The cost of the boundary between simulator and plugins.
//
//   plugin_boundary FOLDER_OF_NUMBERED_PLUGIN
//
// 1. One behaviour called through the simulator (Member::respond(): the host's object, the checks
// of its answer, the trace) compared with the same behaviour called directly, in turn, in the
// decision of a running robot: same perception, one core. Median of 201 rounds of 1000 calls.
// 2. Finding, checking and loading 100 plugin libraries: 100 copies of one small library with
// different plugin names. Median of 15. Prints Markdown.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/simulation/simulation.h"
#include "elsie/testing/linked.h"
#include "elsie/world/reader.h"

#include "statistics.h"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kRounds = 201;
constexpr int kCalls = 1000;
constexpr int kLibraries = 100;

double nanoseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

elsie::Behavior* direct = nullptr;  // the behaviour that is called directly
std::vector<double> through_ns, directly_ns;

/// A coordinator that only measures.
class Stopwatch final : public elsie::Coordinator {
 public:
  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    elsie::Motion sum;
    auto start = Clock::now();
    for (int i = 0; i < kCalls; ++i) {
      members[0].begin_step();
      sum += members[0].respond().command;
    }
    through_ns.push_back(nanoseconds_since(start) / kCalls);
    start = Clock::now();
    for (int i = 0; i < kCalls; ++i) {
      const elsie::Response response = direct->respond(now);
      sum += response.command;
    }
    directly_ns.push_back(nanoseconds_since(start) / kCalls);
    return sum.is_finite() ? elsie::WheelPair().motion({1.0, 1.0}) : sum;
  }
};

ELSIE_COORDINATOR(Stopwatch, "stopwatch", "Measures what asking a behaviour costs");

void measure_calls(const std::string& behavior) {
  elsie::plugin::Host host(elsie::plugin::default_search_path());
  elsie::testing::add_linked(host);
  elsie::world::ReadOptions options;
  options.data_directories = {ELSIE_SOURCE_DIR};
  const std::string text = R"(<world format="1"><robots><robot id="r" team="red"><sensors>
      <beam_range id="left" yaw_deg="15"/><beam_range id="right" yaw_deg="-15"/></sensors><behaviors><)" +
                           behavior + R"(/></behaviors><coordinator><stopwatch/></coordinator>
      </robot></robots></world>)";
  elsie::simulation::Simulation simulation(
      elsie::world::parse_world(text, ELSIE_SOURCE_DIR "/worlds/boundary.xml", host, options),
      host);
  auto object = host.create<elsie::Behavior>(elsie::PluginKind::behavior, behavior);
  direct = object.get();
  elsie::plugin::apply_parameters(*host.find(elsie::PluginKind::behavior, behavior), *object, {});
  elsie::Random random(1);
  object->reset(random);
  through_ns.clear();
  directly_ns.clear();
  for (int i = 0; i < kRounds; ++i) {
    simulation.step();
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < through_ns.size(); ++i) {
    differences.push_back(through_ns[i] - directly_ns[i]);
  }
  std::printf("| `%s` | %.0f | %.0f | %.0f | %.2f |\n", behavior.c_str(),
              elsie::bench::median(through_ns), elsie::bench::median(directly_ns),
              elsie::bench::median(differences),
              elsie::bench::median(through_ns) / elsie::bench::median(directly_ns));
}

/// A copy of the library `numbered.so` whose plugin is called numbered_NNN.
void copy_numbered(const fs::path& library, int number, const fs::path& folder) {
  std::ifstream in(library, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  char name[] = "numbered_000";
  std::snprintf(name, sizeof(name), "numbered_%03d", number);
  const std::size_t place = bytes.find("numbered_???");
  if (place == std::string::npos) {
    throw std::runtime_error(library.string() + " has no name to replace");
  }
  bytes.replace(place, sizeof(name) - 1, name);
  std::ofstream(folder / (std::string(name) + ".so"), std::ios::binary) << bytes;
}

void measure_discovery(const fs::path& library) {
  const fs::path folder = fs::temp_directory_path() / "elsie_bench_plugins";
  fs::create_directories(folder);
  for (int i = 0; i < kLibraries; ++i) {
    copy_numbered(library, i, folder);
  }
  std::vector<double> ms;
  for (int i = 0; i < 15; ++i) {
    const auto start = Clock::now();
    const elsie::plugin::Host host({{folder, "given"}});
    ms.push_back(nanoseconds_since(start) / 1e6);
    if (host.all(elsie::PluginKind::behavior).size() != kLibraries) {
      throw std::runtime_error("not all plugins were found in " + folder.string());
    }
  }
  fs::remove_all(folder);
  std::printf(
      "\nFinding, checking and loading %d plugin libraries: %.1f ms (median of 15; %.1f to "
      "%.1f).\n",
      kLibraries, elsie::bench::median(ms), *std::min_element(ms.begin(), ms.end()),
      *std::max_element(ms.begin(), ms.end()));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: plugin_boundary FOLDER_OF_NUMBERED_PLUGIN\n");
    return 2;
  }
  std::printf(
      "| behaviour | asked by its coordinator, ns | called directly, ns | difference, ns | ratio "
      "|\n"
      "|---|---|---|---|---|\n");
  for (const char* behavior : {"wander", "turn_left", "avoid_obstacle"}) {
    measure_calls(behavior);
  }
  measure_discovery(fs::path(argv[1]) / "numbered.so");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
