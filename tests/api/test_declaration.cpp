#include <catch2/catch.hpp>

#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/sensor.h"

using namespace elsie;

namespace {

class Everything final : public Behavior {
 public:
  double real = 1.5;
  int whole = 3;
  bool flag = true;
  std::string text = "low";
  FilePath file{"a.fcl"};
  std::vector<double> weights{1, 2};
  Response respond(const Perception&) override { return elsie::WheelPair().motion({real, real}); }
};

class Light final : public SensorOf<RangeReading> {
 public:
  RangeReading sense(const SensorContext&) override { return {0.5, 1.0, true}; }
};

Declaration everything() {
  return declare<Everything>(
      PluginKind::behavior, "everything", "Has a parameter of each type",
      parameter("real", &Everything::real,
                {.unit = "m", .min = 0, .max = 2, .meaning = "a number"}),
      parameter("whole", &Everything::whole), parameter("flag", &Everything::flag),
      parameter("text", &Everything::text, {.choices = {"low", "high"}}),
      parameter("file", &Everything::file), parameter("weights", &Everything::weights),
      needs<RangeReading>(), raises("done", "it is done"), version("2.1"));
}

}  // namespace

TEST_CASE("A declaration takes type and default of a parameter from the member") {
  const Declaration d = everything();
  REQUIRE(d.parameters.size() == 6);
  CHECK(d.parameters[0].type == ParameterType::real);
  CHECK(std::get<double>(d.parameters[0].default_value) == 1.5);
  CHECK(d.parameters[0].facts.unit == "m");
  CHECK(d.parameters[1].type == ParameterType::integer);
  CHECK(std::get<std::int64_t>(d.parameters[1].default_value) == 3);
  CHECK(d.parameters[2].type == ParameterType::boolean);
  CHECK(d.parameters[3].type == ParameterType::text);
  CHECK(d.parameters[4].type == ParameterType::file);
  CHECK(std::get<std::string>(d.parameters[4].default_value) == "a.fcl");
  CHECK(d.parameters[5].type == ParameterType::reals);
  CHECK(d.version == "2.1");
  REQUIRE(d.needs.size() == 1);
  CHECK(d.needs[0].kind == "range");
  CHECK(d.needs[0].size == sizeof(RangeReading));
  REQUIRE(d.events.size() == 1);
  CHECK(d.events[0].name == "done");
}

TEST_CASE("A declared parameter reads and writes its member") {
  const Declaration d = everything();
  const auto object = d.create();
  d.parameters[0].set(*object, 0.25);
  d.parameters[1].set(*object, std::int64_t{9});
  d.parameters[4].set(*object, std::string{"b.fcl"});
  d.parameters[5].set(*object, std::vector<double>{7});
  const auto& behavior = static_cast<const Everything&>(*object);
  CHECK(behavior.real == 0.25);
  CHECK(behavior.whole == 9);
  CHECK(behavior.file.path == "b.fcl");
  CHECK(behavior.weights == std::vector<double>{7});
  CHECK(std::get<double>(d.parameters[0].get(*object)) == 0.25);
}

TEST_CASE("By default a behaviour rates candidates by their distance from its command") {
  Everything behavior;
  const Response given{elsie::WheelPair().motion({10, 10})};
  OwnState self;
  Perception::Data data;
  data.self = &self;
  Random random(1);
  const Perception now(data, random);
  const WheelPair& wheels = self.wheels;
  const Motion candidates[] = {wheels.motion({10, 10}), wheels.motion({15, 10}),
                               wheels.motion({13, 14}), wheels.motion({-20, -20})};
  double desirability[4];
  behavior.rate(now, given, candidates, desirability);
  CHECK(desirability[0] == 1.0);
  CHECK(desirability[1] == Approx(0.60653066));
  CHECK(desirability[2] == Approx(desirability[1]));
  CHECK(desirability[3] < 1e-10);
  CHECK(behavior.command_sets(now, given).left.degree(12.5) == Approx(0.5));
  CHECK(behavior.command_sets(now, given).lateral.points.empty());
  self.channels.lateral = true;
  CHECK(behavior.command_sets(now, given).lateral.degree(0.05) == Approx(0.5));
}

TEST_CASE("A perception finds the readings of a kind, and none of a kind that is not there") {
  const RangeReading left{0.4, 1.0, true}, right{1.0, 1.0, false};
  const Mounting mount_left{{}, 0.3, 0}, mount_right{{}, -0.3, 0};
  const SensedReading sensed[] = {{&left, &mount_left, "l"}, {&right, &mount_right, "r"}};
  const ReadingGroup groups[] = {{ReadingKind::of<RangeReading>(), sensed}};
  Perception::Data data;
  data.groups = groups;
  Random random;
  const Perception now(data, random);
  const auto beams = now.readings<RangeReading>();
  REQUIRE(beams.size() == 2);
  CHECK(beams[0]->distance_m == 0.4);
  CHECK(beams[1].azimuth_rad() == -0.3);
  CHECK(beams[1].sensor() == "r");
  double sum = 0;
  for (const auto& beam : beams) {
    sum += beam->distance_m;
  }
  CHECK(sum == 1.4);
  CHECK(now.readings<ProximityReading>().empty());
}

TEST_CASE("A sensor keeps its reading at one address") {
  Light light;
  const void* before = light.reading();
  light.update({0.0, 0.01, {}, nullptr, nullptr, nullptr});
  CHECK(light.reading() == before);
  CHECK(static_cast<const RangeReading*>(before)->distance_m == 0.5);
}
