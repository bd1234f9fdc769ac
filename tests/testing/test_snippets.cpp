// What docs/testing-a-plugin.md and the pages on coordinators and sensors show: the pages are
// compared with this file.
#include "elsie/testing/catch.h"

#include "places.h"

namespace testing = elsie::testing;
using testing::Situation;

namespace {

struct LightReading {
  static constexpr const char* kind = "light";
  double lux = 0.0;
};

}  // namespace

TEST_CASE("Perceptions of the page") {
  Situation now;
  now.beam(15, 0.2).beam(-15, 1.0);   // range sensors at +-15 deg; 1.0 m is their range here
  now.proximity(180, true);           // something is behind the robot
  now.blob(70);                       // a camera with a red blob at column 70, of 100
  now.reading(LightReading{80}, 45);  // a kind of your own, 45 deg to the left
  now.at(1, 2, 90).moving(0.3);       // it stands at (1, 2), looks north, drives at 0.3 m/s
  now.battery(0.1).charging(false);
  now.leader(2, 2).mate("r3", 0, 2).charger(3, 0);
  now.event("collision").time(2.5).period(0.01);
  CHECK(now.perception().readings<LightReading>().size() == 1);
  CHECK(now.perception().team().mates.size() == 2);
}

TEST_CASE("Time on the page") {
  testing::Sequence way;
  way.hold(0.5, Situation().camera()).change(1.0, [](double t) {
    return Situation().blob(10 + 60 * t);
  });
  testing::Behavior finder("find_resource");
  const std::vector<elsie::Response> answers = finder.respond(way);
  CHECK_THAT(answers[50], testing::raises("resource_in_view"));
  CHECK_THAT(answers.back(), testing::turns_right());

  const testing::Trace trace = testing::record(finder, way);
  CHECK_THAT(trace, testing::equals_golden("golden/finder.golden", 1e-6));
}

TEST_CASE("Parameters on the page") {
  testing::Behavior wander("wander", {{"speed", 12}, {"restlessness", 2.0}});
  wander.reset(7);  // the seed of its random stream
  CHECK_THAT(wander.respond(Situation()), testing::drives_forward());
  wander.set({{"speed", 3}});  // as a user does while it runs
}

TEST_CASE("An object takes over from another") {
  testing::Behavior wander("wander");
  wander.respond(Situation());
  testing::Behavior renewed("wander");
  CHECK(renewed.take_over(wander));
  CHECK(renewed.respond(Situation()).command == wander.respond(Situation()).command);
}

TEST_CASE("Expectations on the page") {
  testing::Behavior avoid("avoid_obstacle");
  const elsie::Response response = avoid.respond(Situation().beam(15, 1.0).beam(-15, 0.2));
  CHECK_THAT(response, testing::turns_left() && testing::is_active() && testing::raises_nothing());
  CHECK_THAT(response, !testing::commands_wheels(20, 20, 0.5));
}

TEST_CASE("Members on the page") {
  testing::Team team;
  team.member("avoid", 2, testing::active(0.5, testing::wheels(10, -10)))
      .member("seek", 1, [](const elsie::Perception& now) {
        return elsie::Response(elsie::Motion{0.1 * now.time_s(), 0.0, 0.0});
      });
  testing::Coordinator arbiter("arbiter_suppression", team);
  CHECK_THAT(arbiter.decide(), testing::commands_wheels(10, -10));
  CHECK(team.trace("seek").reason == std::string("suppressed"));
  CHECK(team.asked("seek") == 0);
}

TEST_CASE("Elements on the page") {
  testing::Team layers;
  layers.member("drive", 1, testing::active(1, testing::wheels(10, 10)))
      .member("alarm", 1, testing::active(1, testing::wheels(-5, 5)));
  testing::Coordinator robot("arbiter_subsumption", layers, {{"threshold", 0.5}},
                             {{"suppress", {{"by", "alarm"}, {"of", "drive"}}}});
  CHECK_THAT(robot.decide(), testing::commands_wheels(-5, 5));
}

TEST_CASE("A coordinator that asks further gets the answers given to its members") {
  const auto likes_to_turn_left = [](const elsie::Motion& command) {
    return command.turn > 0.0 ? 1.0 : 0.2;
  };
  testing::Team team;
  team.member("cautious", 1, testing::active(1, testing::wheels(5, 10))).rating(likes_to_turn_left);
  team.member("lazy", 1, testing::active(1, {}))
      .sets({elsie::FuzzySet::triangle(0, 2), elsie::FuzzySet::triangle(0, 2)});
  testing::Coordinator vote("arbiter_voting", team);
  CHECK_THAT(vote.decide(), testing::turns_left());
  const std::vector<double> inside_a_behavior =
      vote.rate({testing::wheels(0, 10), testing::wheels(10, 0)});
  CHECK(inside_a_behavior[0] > inside_a_behavior[1]);
}

TEST_CASE("Surroundings on the page") {
  testing::Surroundings room;
  room.wall(1, -2, 1, 2).box(0.5, 0.3).robot("mate", 2, 0).at(0, 0, 10);
  testing::Sensor beam("beam_range", {{"error", 0.05}});
  beam.turned(-20);
  beam.reset(7);  // the seed of its noise
  CHECK(beam.sense<elsie::RangeReading>(room).distance_m == Approx(0.96).epsilon(0.2));

  testing::Sensor camera("vision");
  testing::Surroundings colours;
  colours.resource(1, 0, testing::kRed);  // what the sensor looks for
  const testing::Picture picture = testing::Picture(100, 100).disc(70, 40, 8, testing::kRed);
  CHECK(camera.sense<elsie::VisionReading>(picture, colours).column == Approx(70).margin(1));
}

TEST_CASE("Worlds on the page") {
  const std::string file = elsie::test::source_path("worlds/clutter.xml");
  testing::World world =
      testing::World::from_file(file, {.seed = 3, .set = {"robot[r1]/@max_speed=0.3"}});
  world.run_for(2.0);
  CHECK(world.robot("r1").distance_m > 0.1);
}

TEST_CASE("The checker on the page") {
  testing::CheckOptions options;
  options.settings = {{"model", "fuzzy_models/contexts_of_travel.fcl"}};
  options.members = {"avoid_obstacle", "go_to_point", "recharge"};
  CHECK_THAT(
      testing::check_plugin(elsie::PluginKind::coordinator, "fusion_context_blending", options),
      testing::finds_nothing());
}

TEST_CASE("Libraries on the page") {
  const std::string library = elsie::test::build_path("tests/testing/plugins/broken_plugins.so");
  const testing::Plugins mine{library};
  testing::Behavior behavior(mine, "sound");
  CHECK_THAT(behavior.respond(Situation()), testing::raises("stepped"));
}

TEST_CASE("A rule on the page") {
  testing::Scene now;
  now.robot("r1").resource("food", 1, 2);
  testing::Rule back("respawn", {{"after", 0.02}});
  back.apply(now);
  now.remove_obstacle("food");
  CHECK(back.apply(now.step()).edits.empty());
  CHECK(back.apply(now.at_step(3)).edits[0] == "resource[food]/@x=1");
}

TEST_CASE("A measure on the page") {
  testing::Scene now;
  now.robot("r1", 1, 2).behaves("avoid_obstacle").behaves("wander").robot("r2").leads();
  testing::Measure share("time_share", {{"behavior", "wander"}, {"robot", "r1"}});
  share.observe(now);
  for (const double part : {1.0, 0.25}) {
    now.behavior("r1", "wander").share = part;
    now.behavior("r1", "avoid_obstacle").share = 1.0 - part;
    share.observe(now.step());
  }
  CHECK(share.value("decided") == 0.5);
  CHECK(share.value("share") == 0.625);
}
