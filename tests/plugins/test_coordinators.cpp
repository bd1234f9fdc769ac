#include <cstring>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::make;
using elsie::test::Situation;
using elsie::test::Team;

namespace {
plugin::Object<Coordinator> coordinator(const char* name, test::Parameters parameters = {}) {
  return make<Coordinator>(PluginKind::coordinator, name, std::move(parameters));
}
}  // namespace

TEST_CASE("Suppression runs only the behaviour of highest priority and passes its command on") {
  Team team;
  team.member("low", 1, MotorCommand{1, 2})
      .member("high", 3, MotorCommand{5, 6})
      .member("middle", 2, MotorCommand{3, 4});
  Situation now;
  const auto arbiter = coordinator("arbiter_suppression");
  CHECK(arbiter->coordinate(team.members(), now.perception()) == MotorCommand{5, 6});
  CHECK(team.asked(0) == 0);
  CHECK(team.asked(1) == 1);
  CHECK(team.asked(2) == 0);

  const auto members = team.members();
  CHECK(members[1].trace.asked);
  CHECK(members[1].trace.share == 1.0);
  CHECK(members[0].trace.share == 0.0);
  CHECK(members[0].trace.inhibited_by == 1);
  CHECK(std::strcmp(members[1].trace.reason, "highest priority") == 0);
}

TEST_CASE(
    "With suppression the first in the file wins a tie, and an inactive winner still decides") {
  Team team;
  Response inactive = MotorCommand{7, 8};
  inactive.activation = 0.0;
  team.member("a", 1, inactive).member("b", 1, MotorCommand{1, 1});
  Situation now;
  CHECK(coordinator("arbiter_suppression")->coordinate(team.members(), now.perception()) ==
        MotorCommand{7, 8});
}

TEST_CASE("Vector summation divides the sum of the commands by the number of behaviours") {
  Team team;
  team.member("a", 1, MotorCommand{20, 20})
      .member("b", 5, MotorCommand{-4, 10})
      .member("c", 1, MotorCommand{2, 0});
  Situation now;
  CHECK(coordinator("fusion_vector_summation")->coordinate(team.members(), now.perception()) ==
        MotorCommand{6, 10});
}

TEST_CASE("Weighted vector summation takes each command times its priority") {
  Team team;
  team.member("a", 0.5, MotorCommand{20, 20}).member("b", 2, MotorCommand{-5, 10});
  Situation now;
  const auto fusion = coordinator("fusion_vector_summation", {{"weighted", true}});
  // (0.5 x (20, 20) + 2 x (-5, 10)) / 2
  CHECK(fusion->coordinate(team.members(), now.perception()) == MotorCommand{0, 15});
  const auto members = team.members();
  CHECK(members[0].trace.weight == 0.5);
  CHECK(members[0].trace.share + members[1].trace.share == Approx(1.0));
  CHECK(members[0].trace.share == Approx(std::sqrt(200.0) / (std::sqrt(200.0) + std::sqrt(500.0))));
}

TEST_CASE("Without behaviours the command is zero") {
  Situation now;
  for (const char* name : {"arbiter_suppression", "fusion_vector_summation"}) {
    CHECK(coordinator(name)->coordinate({}, now.perception()) == MotorCommand{});
  }
}
