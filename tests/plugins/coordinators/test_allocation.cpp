// A decision does not allocate once its memory has grown.

#include "allocations.h"
#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("A decision that needs no fuzzy sets allocates nothing after the first few") {
  for (const char* name :
       {"arbiter_suppression", "arbiter_action_selection", "arbiter_subsumption", "arbiter_voting",
        "arbiter_strength", "fusion_vector_summation", "fusion_interval"}) {
    CAPTURE(name);
    Team team;
    team.member("a", 1, active(1.0, wheels(40, 40)))
        .member("b", 1, active(0.5, wheels(10, -10)))
        .member("c", 2, active(0.0, wheels(5, 5)));
    Coordinated robot(name, team);
    Random random(1);
    const auto decide = [&](int times) {
      for (int step = 0; step < times; ++step) {
        for (std::size_t i = 0; i < 3; ++i) {
          team.answer(i).command =
              WheelPair().motion({random.uniform(-40, 40), random.uniform(-40, 40)});
          team.answer(i).activation = random.chance(0.2) ? 0.0 : random.uniform();
        }
        robot.decide_at(0.01 * step);
      }
    };
    decide(200);
    const long before = test::allocations();
    decide(200);
    CHECK(test::allocations() == before);
  }
}

TEST_CASE("The count sees what plugins allocate") {
  Team team;
  team.member("a", 1, wheels(1, 1));
  Coordinated robot("fusion_fuzzy", team);  // sets are vectors
  robot.decide();
  const long before = test::allocations();
  robot.decide();
  CHECK(test::allocations() > before);
}
