#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "elsie/testing/catch.h"

#include "folder.h"
#include "places.h"

using namespace elsie::testing;
using elsie::Motion;
using elsie::Perception;
using elsie::RangeReading;

namespace {

Trace two_steps() {
  return {{"left", "right"}, {{0.0, {1.0, 2.0}, ""}, {0.01, {3.0, -0.5}, "stuck,freed"}}};
}

/// A new file for each test, removed at the end; the variable that rewrites golden files is not set
/// meanwhile, whoever runs the tests with it.
class File {
 public:
  explicit File(const std::string& text = "") {
    if (!text.empty()) {
      std::ofstream(path) << text;
    }
    if (const char* const was = std::getenv(kUpdateVariable)) {
      was_ = was;
      unsetenv(kUpdateVariable);
    }
  }
  ~File() { was_.empty() ? unsetenv(kUpdateVariable) : setenv(kUpdateVariable, was_.c_str(), 1); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const elsie::test::Folder folder{};
  const std::string path = folder.file("trace.golden");

 private:
  std::string was_;
};

}  // namespace

TEST_CASE("A trace is as in its file when it was written from it") {
  const File file(write_trace(two_steps()));
  CHECK(compare_with_golden(two_steps(), file.path));
  CHECK_THAT(two_steps(), equals_golden(file.path));
}

TEST_CASE("A difference is reported with step, value and expected value") {
  const File file(write_trace(two_steps()));
  Trace trace = two_steps();
  trace.rows[1].values[0] = 3.1;
  trace.rows[1].events = "stuck";
  const Verdict verdict = compare_with_golden(trace, file.path);
  REQUIRE_FALSE(verdict);
  CHECK_THAT(
      verdict.sentence,
      Catch::Contains("in step 1 (0.01 s) left is 3.1, expected 3 within 1e-06; and 1 more"));
  trace.rows[1].values[0] = 3.0;
  CHECK_THAT(compare_with_golden(trace, file.path).sentence,
             Catch::Contains("the events are 'stuck', expected 'stuck,freed'"));
}

TEST_CASE("What is within the tolerance is no difference, and a NaN is one") {
  const File file(write_trace(two_steps()));
  Trace trace = two_steps();
  trace.rows[0].values[0] = 1.009;
  CHECK(compare_with_golden(trace, file.path, 0.01));
  CHECK_FALSE(compare_with_golden(trace, file.path, 0.001));
  trace.rows[0].values[0] = std::nan("");
  CHECK_FALSE(compare_with_golden(trace, file.path, 100.0));
}

TEST_CASE("Other columns, and more or fewer steps, are differences") {
  const File file(write_trace(two_steps()));
  Trace longer = two_steps();
  longer.rows.push_back(longer.rows.back());
  CHECK_THAT(compare_with_golden(longer, file.path).sentence,
             Catch::Contains("it has 3 steps, expected 2"));
  Trace other = two_steps();
  other.columns[1] = "rigth";
  CHECK_THAT(compare_with_golden(other, file.path).sentence,
             Catch::Contains("it has the columns left, rigth, expected left, right"));
}

TEST_CASE("A missing file, or one that is no golden trace, is reported") {
  const File none;
  CHECK_THAT(
      compare_with_golden(two_steps(), none.path).sentence,
      Catch::Contains("there is no golden trace") && Catch::Contains("ELSIE_UPDATE_GOLDEN=1"));
  const File junk("time_s left events\n0 1\n");
  CHECK_THAT(compare_with_golden(two_steps(), junk.path).sentence,
             Catch::Contains(":2: expected 3 fields, found 2"));
  CHECK_THROWS_WITH(read_trace("time_s left events\n0 1,5 -\n", "x"),
                    Catch::Contains("x:2: '1,5' is no number"));
}

TEST_CASE("The file is rewritten when the environment says so") {
  const File file;
  setenv(kUpdateVariable, "1", 1);
  CHECK(compare_with_golden(two_steps(), file.path));
  CHECK_THROWS_WITH(compare_with_golden(two_steps(), "no/such/folder/x.golden"),
                    Catch::Contains("x.golden' cannot be written: No such file"));
  unsetenv(kUpdateVariable);
  CHECK(compare_with_golden(two_steps(), file.path));
}

TEST_CASE("A behaviour over a scripted way is as it was") {
  Behavior finder("find_resource");
  Sequence way(0.1);
  way.hold(0.3, Situation().camera())
      .change(1.0, [](double t) { return Situation().blob(10 + 60 * t); })
      .hold(0.2, Situation().camera());
  CHECK_THAT(record(finder, way), equals_golden("golden/find_resource.golden"));
}

TEST_CASE("A coordinator over a scripted way is as it was") {
  Team team;
  team.member("seek", 1, wheels(10, 10)).member("avoid", 1, [](const Perception& now) {
    return active(1.0 - now.readings<RangeReading>()[0]->distance_m, wheels(-10, 10));
  });
  Coordinator fusion("fusion_fuzzy", team);
  Sequence way(0.1);
  way.change(1.0, [](double t) { return Situation().beam(0, 1.0 - t); });
  CHECK_THAT(record(fusion, team, way), equals_golden("golden/fusion_fuzzy.golden"));
}

TEST_CASE("The trace of a behaviour has what it commands actuators") {
  Behavior say("say");
  const Trace trace = record(say, Sequence(0.1).hold(0.2, Situation().at(1, 2, 0)));
  REQUIRE(trace.rows.size() == 2);
  CHECK(trace.rows[0].events == "act:say:place");
  CHECK(read_trace(write_trace(trace), "x").rows[1].events == trace.rows[1].events);
}

TEST_CASE("The trace of a world has the commands that its actuators carry out") {
  World world = World::from_text(R"(
    <world format="1" name="actuators">
      <arena length="3" width="3"/>
      <resources><resource id="food" x="0.6" y="0" collect="nest" mass="0.05"/></resources>
      <nests><nest x="-1" y="0" radius="0.3"/></nests>
      <robots>
        <robot id="r1">
          <sensors><omnidirectional_camera id="eye"/></sensors>
          <actuators><gripper id="hand" reach="0.1"/><radio id="voice"/></actuators>
          <behaviors><forage/><say/></behaviors>
          <coordinator><arbiter_suppression/></coordinator>
        </robot>
      </robots>
    </world>)");
  const Trace trace = record(world, 6.0, 0.5);
  const auto column = [&](const std::string& name) {
    const auto found = std::find(trace.columns.begin(), trace.columns.end(), name);
    REQUIRE(found != trace.columns.end());
    return static_cast<std::size_t>(found - trace.columns.begin());
  };
  const std::size_t closed = column("r1.hand.closed"), bytes = column("r1.voice.bytes");
  CHECK(trace.rows.front().values[closed] == 0.0);
  CHECK(trace.rows.back().values[closed] == 1.0);
  CHECK(trace.rows.back().values[bytes] == 8.0);
  const File file(write_trace(trace));
  CHECK(compare_with_golden(trace, file.path));
  Trace other = trace;
  other.rows.back().values[closed] = 0.0;
  CHECK_THAT(compare_with_golden(other, file.path).sentence,
             Catch::Contains("r1.hand.closed is 0, expected 1"));
}

TEST_CASE("A small world is as it was, and its events with it") {
  World world = World::from_text(R"(
    <world format="1" name="golden">
      <arena length="2" width="2"/>
      <robots>
        <robot id="r1" team="red" heading_deg="20">
          <behaviors><wander speed="20"/></behaviors>
          <coordinator><arbiter_suppression/></coordinator>
        </robot>
      </robots>
    </world>)");
  const Trace trace = record(world, 3.0, 0.5);
  CHECK(trace.rows.size() == 7);
  CHECK_THAT(trace, equals_golden("golden/small_world.golden", 1e-4));
}
