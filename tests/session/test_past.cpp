// Sessions: the stored past of a run, which is that of a recording.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "elsie/files/base64.h"

#include "session.h"

using namespace elsie;
using namespace elsie::test;

namespace {

template <class Number>
std::vector<Number> unpacked(const Json& text) {
  const auto numbers = files::unpacked<Number>(text.get<std::string>());
  REQUIRE(numbers);
  return *numbers;
}

/// The samples of all answers to an order, until there are no more.
struct Past {
  std::vector<double> times;
  std::map<std::string, std::vector<float>> values;
  std::vector<Json> placed;
  Json last;

  void ask(Session& session, Json order) {
    do {
      order["after_s"] = times.empty() ? -1.0 : times.back();
      last = session.ask(order);
      INFO(last.dump());
      REQUIRE_FALSE(last.contains("refused"));
      const auto more = unpacked<double>(last["times"]);
      times.insert(times.end(), more.begin(), more.end());
      const auto samples = unpacked<float>(last["values"]);
      REQUIRE(samples.size() == more.size() * last["curves"].size());
      auto from = samples.begin();
      for (const std::string name : last["curves"]) {
        const auto end = from + static_cast<std::ptrdiff_t>(more.size());
        values[name].insert(values[name].end(), from, end);
        from = end;
      }
      placed.insert(placed.end(), last["placed"].begin(), last["placed"].end());
    } while (last["more"] == true);
  }
};

/// The rows of a recording as a table, by column; an empty cell is NaN.
std::map<std::string, std::vector<double>> columns_of(const std::string& csv) {
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
      cells.push_back(cell);
    }
    return cells;
  };
  std::istringstream stream(csv);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = cells_of(line);
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(stream, line)) {
    std::vector<std::string> cells = cells_of(line);
    cells.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      char* end = nullptr;
      const double value = std::strtod(cells[i].c_str(), &end);
      columns[names[i]].push_back(end == cells[i].c_str() ? std::nan("") : value);
    }
  }
  return columns;
}

bool is_same(float a, double b) {
  return (std::isnan(a) && std::isnan(b)) || a == static_cast<float>(b);
}

const std::vector<std::string> kNames{"r1/asked/turn", "r1/turn_left/share", "r1/ahead/distance_m"};

constexpr const char* kTwoWishes = R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1" x="-1">
      <sensors><beam_range id="ahead"/></sensors>
      <behaviors><turn_left/><wander/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
  </robots>
  <limits time="4"/>
</world>
)";

}  // namespace

TEST_CASE("The past has the samples of a recording, whatever the speed and whenever it is asked") {
  const Workplace place;
  const std::string csv = place.file("run.csv").string();
  Session session;
  session.open(kTwoWishes);
  REQUIRE_FALSE(session.ask({{"do", "record"}, {"files", {csv}}}).contains("refused"));
  Past paths, numbers;
  session.ask({{"do", "run"}});
  const bool asks_meanwhile = GENERATE(true, false);
  for (int i = 0; asks_meanwhile && i < 5; ++i) {
    paths.ask(session, {{"do", "paths"}});
    numbers.ask(session, {{"do", "numbers"}, {"names", kNames}});
  }
  session.end_of_run();
  paths.ask(session, {{"do", "paths"}});
  numbers.ask(session, {{"do", "numbers"}, {"names", kNames}});

  const auto recorded = columns_of(place.read("run.csv"));
  REQUIRE(recorded.at("time_s").size() == 41);
  REQUIRE(paths.times.size() == 81);  // twice as many
  CHECK(numbers.times == paths.times);
  for (std::size_t row = 0; row < 41; ++row) {
    const std::size_t i = 2 * row;
    CAPTURE(row);
    CHECK(paths.times[i] == Approx(recorded.at("time_s")[row]));
    CHECK(is_same(paths.values["r1/x"][i], recorded.at("x_m")[row]));
    CHECK(is_same(paths.values["r1/y"][i], recorded.at("y_m")[row]));
    CHECK(is_same(numbers.values[kNames[0]][i], recorded.at("asked_turn_rad_s")[row]));
    CHECK(is_same(numbers.values[kNames[1]][i], recorded.at("behavior[turn_left].share")[row]));
    CHECK(is_same(numbers.values[kNames[2]][i], recorded.at("sensor[ahead].distance_m")[row]));
  }
}

TEST_CASE("The names of numbers come once, and again when they have changed") {
  Session session;
  session.open(kTwoWishes);
  session.step();
  const auto names_after = [&](const Json& layout) {
    const Json answer =
        session.ask({{"do", "numbers"}, {"names", Json::array()}, {"layout", layout}});
    return std::pair(answer["layout"], answer.value("names", std::vector<std::string>()));
  };
  const auto [layout, names] = names_after(0);
  for (const std::string& name : kNames) {
    CHECK(std::find(names.begin(), names.end(), name) != names.end());
  }
  CHECK(names_after(layout).second.empty());
  session.edit({kSecond});
  const auto [next, more] = names_after(layout);
  CHECK(next != layout);
  CHECK(std::find(more.begin(), more.end(), "r2/turn_right/weight") != more.end());

  const Json some =
      session.ask({{"do", "numbers"}, {"names", Json::array()}, {"robots", {"r2"}}})["names"];
  CHECK(std::all_of(some.begin(), some.end(),
                    [](const std::string& name) { return name.starts_with("r2/"); }));
}

TEST_CASE("A robot that an edit adds has no past before, and one that it moves has a gap") {
  Session session;
  session.open(kRoom);
  session.step(20);
  session.edit({kSecond, "robot[r1]/@y=1"});
  session.step(20);
  Past paths;
  paths.ask(session, {{"do", "paths"}});
  REQUIRE(paths.times.size() == 9);
  CHECK(std::isnan(paths.values["r2/x"][4]));
  CHECK(paths.values["r2/x"][5] == Approx(1.0).margin(0.1));
  CHECK(paths.values["r1/y"][4] == Approx(0.0).margin(0.1));
  CHECK(paths.values["r1/y"][5] == Approx(1.0).margin(0.1));
  REQUIRE_FALSE(paths.placed.empty());
  const Json& placed = paths.placed.back();
  CHECK(placed["robot"] == "r1");
  CHECK(placed["time_s"].get<double>() >= paths.times[4]);
  CHECK(placed["time_s"].get<double>() < paths.times[5]);
  Past one;
  one.ask(session, {{"do", "paths"}, {"robots", {"r2"}}});
  CHECK(one.values.size() == 2);
}

TEST_CASE("Measures and fuzzy values are stored only while they are watched") {
  Session session;
  const std::string file = source_path("worlds/clutter.xml");
  session.open(text_of("worlds/clutter.xml"), file);
  session.ask({{"do", "run"}, {"until_s", 0.2}});
  session.event("paused");
  session.ask({{"do", "watch"}, {"what", {"measures", "fuzzy"}}});
  session.ask({{"do", "run"}, {"until_s", 0.4}});
  session.event("paused");
  session.ask({{"do", "watch"}, {"what", Json::array()}});
  session.ask({{"do", "run"}, {"until_s", 0.6}});
  session.event("paused");
  const std::vector<std::string> names =
      session.ask({{"do", "numbers"}, {"names", Json::array()}})["names"];
  const auto fuzzy = std::find_if(names.begin(), names.end(), [](const std::string& name) {
    return name.ends_with("/inputs/range");
  });
  REQUIRE(fuzzy != names.end());
  Past numbers;
  numbers.ask(session, {{"do", "numbers"}, {"names", {"measures/time_s", *fuzzy}}});
  REQUIRE(numbers.times.size() == 13);
  for (std::size_t i = 0; i < 13; ++i) {
    CAPTURE(i);
    const bool is_watched = i > 4 && i <= 8;
    const float time_s = numbers.values["measures/time_s"][i];
    CHECK((is_watched ? time_s == Approx(numbers.times[i]) : std::isnan(time_s)));
    CHECK(std::isnan(numbers.values[*fuzzy][i]) == !is_watched);
  }
}

TEST_CASE("A slow run answers for its past, and a wrong order is refused") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "speed"}, {"factor", 1e-6}});
  session.ask({{"do", "run"}});
  CHECK(session.ask({{"do", "paths"}})["curves"][0] == "r1/x");
  CHECK(session.ask({{"do", "numbers"}}).contains("refused"));
  CHECK(session.ask({{"do", "numbers"}, {"names", "r1/speed"}}).contains("refused"));
  CHECK(session.ask({{"do", "paths"}, {"after_s", "now"}}).contains("refused"));
  Past numbers;
  numbers.ask(session, {{"do", "numbers"}, {"names", {"r9/speed"}}});
  CHECK(std::isnan(numbers.values["r9/speed"].at(0)));
  session.ask({{"do", "reset"}});
  CHECK(unpacked<double>(session.ask({{"do", "paths"}})["times"]) == std::vector{0.0});
}

TEST_CASE("The past of a run that a change at time zero alters has the names and places after it") {
  Session session;
  session.open(R"(<world format="1">
  <arena length="4" width="4"/>
  <robots><robot id="r1" x="-1"/><robot id="r2" x="1"/><robot id="r3"/></robots>
  <changes>
    <change time="0" path="robot[r1]/@remove" value="true"/>
    <change time="0" path="robot[r3]/@y" value="1"/>
  </changes>
  <limits time="0.2"/>
</world>
)");
  session.ask({{"do", "run"}});
  session.end_of_run();
  Past paths;
  paths.ask(session, {{"do", "paths"}});
  REQUIRE(paths.times.size() == 5);
  CHECK_FALSE(paths.values.contains("r1/x"));
  for (std::size_t i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(paths.values["r2/x"][i] == Approx(1.0));
    CHECK(paths.values["r3/y"][i] == Approx(1.0));
  }
}

TEST_CASE("The past answers for ten thousand numbers at once, and refuses more with a sentence") {
  Session session;
  session.open(kRoom);
  std::vector<std::string> names(10'000, "r1/speed");
  for (std::size_t i = 1; i < names.size(); ++i) {
    names[i] = "r1/unknown_" + std::to_string(i);
  }
  const Json answer = session.ask({{"do", "numbers"}, {"names", names}});
  CHECK(answer["curves"].size() == 10'000);
  const auto values = unpacked<float>(answer["values"]);
  REQUIRE(values.size() == 10'000);
  CHECK(values[0] == 0.0F);
  CHECK(std::isnan(values[1]));
  names.emplace_back("r1/energy");
  const Json refused = session.ask({{"do", "numbers"}, {"names", names}});
  REQUIRE(refused.contains("refused"));
  CHECK(refused["refused"][0]["message"] ==
        "the order asks for 10001 numbers; expected at most 10000 `names`: ask for the others in a "
        "further order");
}

TEST_CASE("A sensor that fails to list its numbers loses only these, and a note says so once") {
  Session session({"--plugin", build_path("tests/program/plugins/faulty.so")});
  session.open(R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1" x="-1">
      <sensors><renaming_sensor id="odd"/><beam_range id="ahead"/></sensors>
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
    <robot id="r2" x="1"><sensors><beam_range id="ahead"/></sensors></robot>
  </robots>
  <limits time="0.5"/>
</world>
)");
  session.ask({{"do", "run"}});
  CHECK(session.end_of_run()["outcome"] == "time_limit");
  Past numbers;
  numbers.ask(session, {{"do", "numbers"},
                        {"names", {"r1/odd/early", "r1/ahead/distance_m", "r2/ahead/hit"}}});
  REQUIRE(numbers.times.size() == 11);
  for (std::size_t i = 1; i < 11; ++i) {
    CAPTURE(i);
    CHECK(std::isnan(numbers.values["r1/odd/early"][i]) == (i > 4));
    CHECK(numbers.values["r1/ahead/distance_m"][i] > 0.0F);
    CHECK_FALSE(std::isnan(numbers.values["r2/ahead/hit"][i]));
  }
  const Json note = session.event("note");
  CHECK(note["robot"] == "r1");
  CHECK(note["plugin"] == "odd");
  CHECK_THAT(note["text"].get<std::string>(),
             Catch::Contains("its numbers are not stored from now on"));
  session.ask({{"do", "ping"}});
  CHECK_FALSE(session.has_event("note"));
}

TEST_CASE("The names of numbers come with their units, and with what plugins publish") {
  Session session;
  session.open(R"(<world format="1">
  <robots>
    <robot id="r1">
      <localisation><beacon/></localisation>
      <sensors><beam_range id="ahead"/></sensors>
      <behaviors><turn_left/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
</world>)");
  session.ask({{"do", "step"}});
  const Json answer = session.ask({{"do", "numbers"}, {"names", {"r1/beacon/fixes"}}});
  const auto names = answer["names"].get<std::vector<std::string>>();
  CHECK(std::find(names.begin(), names.end(), "r1/beacon/fixes") != names.end());
  CHECK(answer["units"]["r1/ahead/distance_m"] == "m");
  CHECK(answer["units"]["r1/speed"] == "m/s");
  CHECK_FALSE(answer["units"].contains("r1/ahead/hit"));
  CHECK_FALSE(unpacked<float>(answer["values"]).empty());
}

TEST_CASE("The past has what was lit in graphs, as a number for each node") {
  Session session;
  session.open(R"(<world format="1"><robots><robot id="r1"><behaviors><wander/></behaviors>
    <coordinator><arbiter_states>
      <state name="go" behavior="wander"><transition to="stand" after="1"/></state>
      <state name="stand" ends="success"/>
    </arbiter_states></coordinator></robot></robots><limits time="2"/></world>)");
  session.ask({{"do", "run"}});
  session.end_of_run();
  const std::vector<std::string> names{"r1/arbiter_states/nodes/0", "r1/arbiter_states/nodes/1"};
  Past past;
  past.ask(session, {{"do", "numbers"}, {"names", names}});
  const auto& go = past.values.at(names[0]);
  const auto& stand = past.values.at(names[1]);
  REQUIRE(go.size() == past.times.size());
  for (std::size_t i = 0; i < go.size(); ++i) {
    CAPTURE(past.times[i]);
    if (i == 0) {
      CHECK(std::isnan(go[i]));  // nothing was decided yet
    } else if (std::abs(past.times[i] - 1.0) > 0.03) {
      CHECK(go[i] == (past.times[i] < 1.0 ? 1.0F : 0.0F));
      CHECK(stand[i] == (past.times[i] < 1.0 ? 0.0F : 1.0F));
    }
  }
  const auto offered = past.last["names"];
  CHECK(std::count(offered.begin(), offered.end(), names[1]) == 1);
}
