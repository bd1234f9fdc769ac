// Worlds at the ends of the allowed ranges: none goes wrong without a word. bench/extreme_worlds
// runs as many of them as one likes.
#include <catch2/catch.hpp>

#include "elsie/plugin/host.h"

#include "extreme_worlds.h"
#include "shipped.h"

using namespace elsie;

TEST_CASE("Of a hundred worlds at the ends of what is allowed none explodes in silence") {
  const plugin::Host host(test::shipped_directory());
  int ended_by_fault = 0;
  for (std::uint64_t number = 1; number <= 100; ++number) {
    const test::Extreme world = test::run_extreme_world(number, host);
    INFO("world " << number << ": " << world.seen << '\n' << world.text);
    CHECK_FALSE(world.silent());
    ended_by_fault += world.fault.empty() ? 0 : 1;
  }
  CHECK(ended_by_fault > 0);  // or else the worlds are not extreme
  CHECK(ended_by_fault < 80);
}
