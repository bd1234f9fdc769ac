#include <elsie/testing/catch.h>

namespace testing = elsie::testing;

TEST_CASE("Each wish counts as much as its behaviour is active") {
  testing::Team team;
  team.member("avoid", 1, testing::active(0.6, testing::wheels(0, 10)))
      .member("seek", 1, testing::active(0.2, testing::wheels(20, 10)));
  testing::Coordinator fusion("fusion_activity", team);
  CHECK_THAT(fusion.decide(), testing::commands_wheels(5, 10));
  CHECK(team.trace("avoid").share == Approx(0.75));
  CHECK(team.trace("avoid").reason == std::string("active"));
}

TEST_CASE("When nobody is active enough the robot stands") {
  testing::Team team;
  team.member("avoid", 1, testing::active(0.01, testing::wheels(10, 10)));
  testing::Coordinator fusion("fusion_activity", team, {{"least", 0.1}});
  CHECK_THAT(fusion.decide(), testing::stands());
  CHECK(team.trace("avoid").share == 0.0);
}

TEST_CASE("Nothing else is wrong with it") {
  CHECK_THAT(testing::check_plugin(elsie::PluginKind::coordinator, "fusion_activity"),
             testing::finds_nothing());
}
