// What robots say to each other: who hears it, when, and in which order.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/message.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/simulation.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

struct Word {
  static constexpr const char* kind = "word";
  double number = 0.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("number", number);
  }
};

/// Says a word in the periods that `when` names, and publishes what it heard last.
class Talks final : public Behavior {
 public:
  double word = 0.0;
  std::string to;
  std::int64_t first = 0, last = 0;  // periods in which it speaks
  bool relays = false;               // says what it hears again
  void reset(Random&) override { period_ = 0; }
  Response respond(const Perception& now) override {
    Response response;
    if (period_ >= first && period_ <= last) response.say(Word{word}, to);
    if (relays && !now.all_heard().empty()) {
      response.act(SayCommand{now.all_heard()[0].message, to});
    }
    ++period_;
    sum = count = 0.0;
    age = distance = bearing = -1.0;
    order = 0.0;
    for (const auto& heard : now.heard<Word>()) {
      sum += heard->number;
      order = 10.0 * order + heard->number;
      count += 1.0;
      age = heard.age_s();
      distance = heard.distance_m();
      bearing = heard.bearing_rad();
      named = !heard.from().empty();
    }
    return response;
  }
  double sum = 0.0, count = 0.0, age = -1.0, distance = -1.0, bearing = -1.0, order = 0.0;
  bool named = false;
  double is_named() const { return named ? 1.0 : 0.0; }

 private:
  std::int64_t period_ = 0;
};

const plugin::Host& talking() {
  static const plugin::Host made = [] {
    plugin::Host host(shipped_directory());
    host.add(declare<Talks>(
        PluginKind::behavior, "talks", "talks", only_acts(), parameter("word", &Talks::word),
        parameter("to", &Talks::to), parameter("first", &Talks::first),
        parameter("last", &Talks::last), parameter("relays", &Talks::relays),
        publishes("sum", &Talks::sum), publishes("count", &Talks::count),
        publishes("age", &Talks::age), publishes("distance", &Talks::distance),
        publishes("bearing", &Talks::bearing), publishes("order", &Talks::order),
        publishes("named", &Talks::is_named)));
    return host;
  }();
  return made;
}

std::string talker(const std::string& id, double x, double y, double word,
                   const std::string& device = "<radio/>", const std::string& more = "",
                   double heading_deg = 0.0) {
  return "<robot id=\"" + id + "\" x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) +
         "\" heading_deg=\"" + std::to_string(heading_deg) + "\"><actuators>" + device +
         "</actuators><behaviors><talks word=\"" + std::to_string(word) + "\" " + more +
         "/></behaviors></robot>";
}

simulation::Simulation of_robots(const std::string& robots, const std::string& more = "",
                                 const simulation::Options& options = {}) {
  return {
      world::parse_world("<world format=\"1\">" + more + "<robots>" + robots + "</robots></world>",
                         "talk.xml", talking()),
      talking(), options};
}

std::map<std::string, double> shown(const simulation::Simulation& simulation, std::size_t robot) {
  std::map<std::string, double> all;
  simulation.visit_published(
      robot, [&](const simulation::PublishedValue& each) { all[each.number.name] = each.value; });
  return all;
}

double heard_by(const simulation::Simulation& simulation, std::size_t robot) {
  return shown(simulation, robot)["sum"];
}

}  // namespace

TEST_CASE("A message is heard once, in the control period after it was said") {
  simulation::Simulation simulation =
      of_robots(talker("a", 0, 0, 3) + talker("b", 1, 0, 5, "<radio/>", R"(first="9" last="9")"));
  simulation.step();
  CHECK(heard_by(simulation, 1) == 0.0);
  simulation.step();
  CHECK(heard_by(simulation, 1) == 3.0);
  CHECK(shown(simulation, 1)["age"] == Approx(0.01));
  CHECK(shown(simulation, 1)["named"] == 1.0);
  CHECK(heard_by(simulation, 0) == 0.0);
  REQUIRE(simulation.heard(1).size() == 1);
  CHECK(simulation.heard(1)[0].from == "a");
  simulation.step();
  CHECK(heard_by(simulation, 1) == 0.0);
}

TEST_CASE("Who hears is within the range of the one who speaks") {
  simulation::Simulation simulation =
      of_robots(talker("loud", 0, 0, 3, R"(<radio range="2"/>)") +
                talker("quiet", 1.9, 0, 5, R"(<radio range="0.5"/>)") +
                talker("far", 2.1, 0, 7, R"(<radio range="1"/>)"));
  simulation.step();
  simulation.step();
  CHECK(heard_by(simulation, 0) == 0.0);
  CHECK(heard_by(simulation, 1) == 3.0 + 7.0);
  CHECK(heard_by(simulation, 2) == 5.0);
}

TEST_CASE("A message may go to one robot, and never to the own one") {
  simulation::Simulation simulation = of_robots(talker("a", 0, 0, 3, "<radio/>", R"(to="c")") +
                                                talker("b", 0.5, 0, 0) + talker("c", 0, 0.5, 0));
  simulation.step();
  simulation.step();
  CHECK(heard_by(simulation, 1) == 0.0);
  CHECK(heard_by(simulation, 2) == 3.0);
  simulation::Simulation wrong = of_robots(talker("a", 0, 0, 3, "<radio/>", R"(to="a")"));
  CHECK_THROWS_WITH(wrong.step(), Catch::Contains("sends a message to its own robot 'a'"));
  simulation::Simulation narrow = of_robots(talker("a", 0, 0, 3, R"(<radio bandwidth="4"/>)"));
  CHECK_THROWS_WITH(narrow.step(), Catch::Contains("has 8 bytes; its bandwidth is 4"));
}

TEST_CASE("Messages are heard in the order of their senders' ids, whatever that of the file") {
  const std::string a = talker("a", 0.2, 0, 1), b = talker("b", -0.2, 0, 2),
                    c = talker("c", 0, 0.2, 3),
                    me = talker("me", 0, 0, 0, "<radio/>", "last=\"-1\"");
  for (const std::string& robots : {a + b + c + me, c + me + b + a, me + b + a + c}) {
    simulation::Simulation simulation = of_robots(robots);
    simulation.step();
    simulation.step();
    for (std::size_t i = 0; i < 4; ++i) {
      if (simulation.robot(i).description->id == "me") {
        CHECK(shown(simulation, i)["order"] == 123.0);
      }
    }
  }
}

TEST_CASE("A delay is waited for, and ages the message") {
  simulation::Simulation simulation =
      of_robots(talker("a", 0, 0, 3, R"(<radio delay="0.03"/>)") + talker("b", 1, 0, 0));
  std::vector<double> heard;
  for (int i = 0; i < 5; ++i) {
    simulation.step();
    heard.push_back(heard_by(simulation, 1));
    if (heard.back() > 0.0) CHECK(shown(simulation, 1)["age"] == Approx(0.03));
  }
  CHECK(heard == std::vector<double>{0, 0, 0, 3, 0});
}

TEST_CASE("A radio with a failure of its own speaks later, or not at all") {
  const auto heard_with = [](const std::string& failure) {
    simulation::Simulation simulation =
        of_robots(talker("a", 0, 0, 3, "<radio>" + failure + "</radio>") + talker("b", 1, 0, 0));
    std::vector<double> heard;
    for (int i = 0; i < 5; ++i) {
      simulation.step();
      heard.push_back(heard_by(simulation, 1));
    }
    return heard;
  };
  CHECK(heard_with(R"(<failure latency="0.02"/>)") == std::vector<double>{0, 0, 0, 3, 0});
  CHECK(heard_with(R"(<failure dropout="1"/>)") == std::vector<double>{0, 0, 0, 0, 0});
}

TEST_CASE("Loss is drawn for each sender, receiver and period, the same in any number of threads") {
  const auto heard_with = [](std::size_t threads, std::uint64_t seed) {
    std::string robots;
    for (int i = 0; i < 80; ++i) {
      robots += talker("r" + std::to_string(i), 0.3 * (i % 10), 0.3 * (i / 10), 1,
                       R"(<radio range="0.31" loss="0.25"/>)", R"(last="99")");
    }
    simulation::Simulation simulation = of_robots(robots, "", {.seed = seed, .threads = threads});
    std::vector<double> counts;
    for (int step = 0; step < 20; ++step) {
      simulation.step();
      for (std::size_t i = 0; i < 80; ++i) counts.push_back(shown(simulation, i)["count"]);
    }
    return counts;
  };
  const auto one = heard_with(1, 4);
  CHECK(heard_with(3, 4) == one);
  CHECK(heard_with(1, 5) != one);
  double sum = 0.0;
  for (const double count : one) sum += count;
  const double said = 19.0 * 2.0 * (9 * 8 + 10 * 7);  // pairs of neighbours, both ways
  CHECK(sum / said == Approx(0.75).margin(0.02));
}

TEST_CASE("Range and bearing repeats, tells from where, and needs a line of sight") {
  const std::string device = R"(<range_and_bearing x="0" y="0"/>)";
  const auto two = [&](const std::string& more, const std::string& of_device) {
    return of_robots(
        talker("a", 0, 0, 3, of_device) + talker("b", 1, 1, 0, of_device, "last=\"-1\"", 90.0),
        more);
  };
  simulation::Simulation simulation = two("", device);
  for (int i = 0; i < 3; ++i) {
    simulation.step();
    if (i == 0) continue;
    CHECK(heard_by(simulation, 1) == 3.0);
    CHECK(shown(simulation, 1)["distance"] == Approx(std::sqrt(2.0)).epsilon(1e-3));
    CHECK(shown(simulation, 1)["bearing"] == Approx(radians(135.0)).epsilon(1e-3));
    CHECK(shown(simulation, 1)["named"] == 0.0);
  }
  simulation::Simulation known = two("", R"(<range_and_bearing tells_id="true"/>)");
  known.step();
  known.step();
  CHECK(shown(known, 1)["named"] == 1.0);
  simulation::Simulation hidden =
      two(R"(<obstacles><static_box x="0.5" y="0.5" height="1"/></obstacles>)", device);
  hidden.step();
  hidden.step();
  CHECK(heard_by(hidden, 1) == 0.0);
  // A radio goes through.
  simulation::Simulation through =
      two(R"(<obstacles><static_box x="0.5" y="0.5" height="1"/></obstacles>)", "<radio/>");
  through.step();
  through.step();
  CHECK(heard_by(through, 1) == 3.0);
}

TEST_CASE("A robot hears only devices of the kind that it has") {
  simulation::Simulation simulation =
      of_robots(talker("a", 0, 0, 3) + talker("b", 0.5, 0, 0, "<range_and_bearing/>") +
                R"(<robot id="deaf" x="1"><behaviors><talks last="-1"/></behaviors></robot>)");
  simulation.step();
  simulation.step();
  CHECK(heard_by(simulation, 1) == 0.0);
  CHECK(heard_by(simulation, 2) == 0.0);
}

TEST_CASE("A robot that loses its radio in a run hears nothing more") {
  simulation::Simulation simulation =
      of_robots(talker("a", 0, 0, 3, "<radio/>", R"(last="99")") +
                R"(<robot id="b" x="0.5"><actuators><radio/></actuators></robot>)");
  simulation.step();
  simulation.step();
  CHECK(simulation.heard(1).size() == 1);
  simulation.edit("robot[b]/actuator[radio]/@remove", "true");
  simulation.step();
  CHECK(simulation.heard(1).empty());
}

TEST_CASE("Who heard whom is sketched by an arrow of a role of its own") {
  simulation::Simulation simulation =
      of_robots(talker("a", 0, 0, 3, "<radio/>", R"(last="99")") +
                R"(<robot id="b" x="0.5"><actuators><radio/></actuators></robot>)");
  simulation.step();
  simulation.step();
  REQUIRE(simulation.heard(1).size() == 1);
  std::size_t arrows = 0;
  for (const simulation::PluginSketch& each : simulation.sketches(1)) {
    for (const Sketch::Mark& mark : each.sketch.marks()) {
      if (mark.role != SketchRole::message) continue;
      ++arrows;
      REQUIRE(mark.kind == Sketch::Kind::arrow);
      CHECK(each.sketch.places(mark)[0].x == simulation.heard(1)[0].sender_at.x);
      CHECK(each.sketch.places(mark)[1].x == simulation.actuator(1, 0).frame.origin.x);
    }
  }
  CHECK(arrows == 1);
}

TEST_CASE("A robot whose battery is empty neither speaks nor hears") {
  simulation::Simulation simulation = of_robots(talker("a", 0, 0, 3, "<radio/>", R"(last="99")") +
                                                talker("b", 0.5, 0, 5, "<radio/>", R"(last="99")"));
  simulation.step();
  simulation.edit("robot[a]/@energy", "0");
  simulation.step();
  CHECK(heard_by(simulation, 1) == 3.0);  // said before
  simulation.step();
  CHECK(heard_by(simulation, 1) == 0.0);
  CHECK(heard_by(simulation, 0) == 0.0);
}

TEST_CASE("A message may be passed on for ever") {
  const std::string more = R"(relays="true" last=")";
  auto simulation = of_robots(talker("a", 0, 0, 3, "<radio/>", more + "0\"") +
                                  talker("b", 1, 0, 5, "<radio/>", more + "-1\""),
                              R"(<physics engine="planar"/>)");
  for (int i = 0; i < 100'000; ++i) simulation.step();
  CHECK(heard_by(simulation, 0) + heard_by(simulation, 1) == 3.0);
}

TEST_CASE("A message to a robot that there never was ends the run and names who said it") {
  simulation::Simulation simulation =
      of_robots(talker("r1", 0, 0, 3, "<radio/>", R"(to="r9")") + talker("r2", 1, 0, 0));
  CHECK_THROWS_WITH(simulation.step(),
                    Catch::Contains("'talks'") && Catch::Contains("r1") &&
                        Catch::Contains("it says a message to the robot 'r9', and there is no such "
                                        "robot; did you mean 'r1'?"));
  simulation::Simulation far = of_robots(talker("r1", 0, 0, 3, "<radio/>", R"(to="leader")"));
  CHECK_THROWS_WITH(far.step(),
                    Catch::Contains("'leader', and there is no such robot; there are: r1"));
}

TEST_CASE("A message to a robot that an edit removed is heard by nobody; one that it added hears") {
  simulation::Simulation simulation =
      of_robots(talker("a", 0, 0, 3, "<radio/>", R"(to="b" last="99")") + talker("b", 0.5, 0, 0) +
                talker("c", 0, 0.5, 0, "<radio/>", "last=\"-1\""));
  simulation.step();
  simulation.edit("robot[b]/@remove", "true");
  advance(simulation, 3);
  CHECK(simulation.heard(1).empty());
  simulation.edit("robot[+]", "<robot id=\"b\" x=\"0.5\"><actuators><radio/></actuators></robot>");
  advance(simulation, 2);
  CHECK(simulation.heard(2).size() == 1);
  simulation.edit("robot[c]/behavior[talks]/@to", "d");
  simulation.edit("robot[c]/behavior[talks]/@last", "99");
  CHECK_THROWS_WITH(simulation.step(), Catch::Contains("'d', and there is no such robot"));
}

TEST_CASE("Noise of a device disturbs from where it seems to hear, not what it says") {
  const auto heard_with = [](const std::string& noise, std::size_t threads = 1) {
    simulation::Simulation simulation = of_robots(
        talker("a", 0, 0, 3, "<range_and_bearing x=\"0\"/>", R"(last="99")") +
            talker("b", 1, 0, 0, "<range_and_bearing x=\"0\">" + noise + "</range_and_bearing>",
                   "last=\"-1\"", 90.0),
        "", {.seed = 3, .threads = threads});
    std::vector<HeardMessage> all;
    for (int i = 0; i < 400; ++i) {
      simulation.step();
      for (const HeardMessage& heard : simulation.heard(1)) all.push_back(heard);
    }
    CHECK(heard_by(simulation, 1) == 3.0);
    return all;
  };
  const auto biased = heard_with(
      R"(<noise on="distance" bias="0.5"/><noise on="bearing" bias="3"/><noise on="elevation" bias="0.1"/>)");
  REQUIRE(biased.size() == 399);
  CHECK(biased[0].distance_m == Approx(1.5));
  CHECK(biased[0].bearing_rad == Approx(wrap_angle(radians(90.0) + 3.0)));
  CHECK(biased[0].elevation_rad == Approx(0.1));
  const auto noisy = heard_with(R"(<noise on="distance" gaussian="0.02"/>)");
  double sum = 0.0, squares = 0.0;
  for (const HeardMessage& heard : noisy) {
    sum += heard.distance_m - 1.0;
    squares += (heard.distance_m - 1.0) * (heard.distance_m - 1.0);
    CHECK(heard.bearing_rad == Approx(radians(90.0)));
  }
  CHECK(sum / 399 == Approx(0.0).margin(0.004));
  CHECK(std::sqrt(squares / 399) == Approx(0.02).epsilon(0.15));
  const auto again = heard_with(R"(<noise on="distance" gaussian="0.02"/>)", 2);
  CHECK(std::equal(noisy.begin(), noisy.end(), again.begin(), again.end(),
                   [](const HeardMessage& one, const HeardMessage& other) {
                     return one.distance_m == other.distance_m;
                   }));
  CHECK_THAT(why_no_world([&] {
               of_robots(talker("a", 0, 0, 3,
                                "<range_and_bearing><noise on=\"range\"/></range_and_bearing>"));
             }),
             Catch::Contains("names no number of its command or of what it hears; it has"));
}

TEST_CASE("Messages under way are part of the state; without any the hash is that of the bodies") {
  const auto hash_of = [](double word, int steps) {
    simulation::Simulation simulation =
        of_robots(talker("a", 0, 0, word, R"(<radio delay="0.05"/>)") + talker("b", 1, 0, 0));
    advance(simulation, steps);
    return simulation.state_hash();
  };
  CHECK(hash_of(3, 2) != hash_of(4, 2));
  CHECK(hash_of(3, 2) == hash_of(3, 2));
  CHECK(hash_of(3, 20) == hash_of(4, 20));  // all are heard
}

TEST_CASE("A result has the messages that each robot sent and heard, if it can hear any") {
  simulation::Simulation simulation =
      of_robots(talker("a", 0, 0, 3, "<radio/>", R"(last="9")") + talker("b", 0.5, 0, 0) +
                R"(<robot id="c" x="0" y="0.5"><actuators><led/></actuators></robot>)");
  advance(simulation, 20);
  const auto result = simulation.result();
  REQUIRE(result.robots[0].talk);
  CHECK(result.robots[0].talk->sent == 10);
  CHECK(result.robots[0].talk->heard == 1);
  CHECK(result.robots[1].talk->sent == 1);
  CHECK(result.robots[1].talk->heard == 10);
  CHECK_FALSE(result.robots[2].talk);
}
