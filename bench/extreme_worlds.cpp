// How many of N worlds at the ends of the allowed ranges fail, and how many of these fail silently.
//
//   extreme_worlds [N [FIRST]]
//
// N is 2000 by default, and FIRST, the number of the first world, 1. The same numbers give the same
// worlds. Exit code 1 if a world failed silently; it is printed then.
#include "extreme_worlds.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  try {
    const elsie::plugin::Host host(elsie::plugin::default_search_path());
    int faults = 0, faults_with_warning = 0, gave_up = 0, warned = 0, silent = 0;
    for (std::uint64_t number = first; number < first + count; ++number) {
      const elsie::test::Extreme world = elsie::test::run_extreme_world(number, host);
      warned += world.warned;
      gave_up += world.gave_up;
      faults += !world.fault.empty();
      faults_with_warning += !world.fault.empty() && world.warned;
      if (world.silent()) {
        ++silent;
        std::printf("world %llu: %s\n%s\n", static_cast<unsigned long long>(number),
                    world.seen.c_str(), world.text.c_str());
      }
    }
    std::printf(
        "%llu worlds: %d had warnings; %d ended by a fault of the physics, %d of them had "
        "warnings; in %d the solver gave up; %d went wrong in silence\n",
        static_cast<unsigned long long>(count), warned, faults, faults_with_warning, gave_up,
        silent);
    return silent == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "extreme_worlds: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
