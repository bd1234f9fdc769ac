// What a program of any language is told, and what it may answer.
#include <algorithm>
#include <array>
#include <thread>

#include <catch2/catch.hpp>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "elsie/messages/say.h"
#include "elsie/plugin/error.h"
#include "elsie/readings/lidar.h"
#include "elsie/testing/coordinator.h"

#include "programs.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;
using testing::Situation;
using testing::Team;

namespace {

/// A program that listens on a socket and answers each line of a time so, the others with {}.
class Listener {
 public:
  Listener(const std::string& path, std::string answer) : answer_(std::move(answer)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    listening_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    REQUIRE(bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    REQUIRE(listen(listening_, 1) == 0);
    thread_ = std::thread([this] { serve(); });
  }
  /// What it was told, when its client has left.
  std::vector<Json> told() {
    thread_.join();
    return lines_of(heard_);
  }
  ~Listener() {
    if (thread_.joinable()) thread_.join();
    close(listening_);
  }

 private:
  void serve() {
    const int client = accept(listening_, nullptr, nullptr);
    std::array<char, 4096> buffer;
    for (std::size_t answered = 0;;) {
      const ssize_t count = read(client, buffer.data(), buffer.size());
      if (count <= 0) break;
      heard_.append(buffer.data(), static_cast<std::size_t>(count));
      for (std::size_t end; (end = heard_.find('\n', answered)) != std::string::npos;) {
        const std::string line = heard_.substr(answered, end - answered);
        answered = end + 1;
        if (line == "{\"end\":true}") continue;
        const std::string answer = (line.starts_with("{\"time\"") ? answer_ : "{}") + "\n";
        if (write(client, answer.data(), answer.size()) < 0) break;
      }
    }
    close(client);
  }

  std::string answer_, heard_;
  int listening_ = -1;
  std::thread thread_;
};

}  // namespace

TEST_CASE("A program commands a motion, or the rates of two wheels") {
  CHECK(answer_of(answering(R"({"forward":0.25,"turn":-1.5})")).command == Motion{0.25, 0, -1.5});
  CHECK(answer_of(answering(R"({"lateral":0.1})")).command == Motion{0, 0.1, 0});
  CHECK(answer_of(answering(R"({"left":10,"right":5})")).command == testing::wheels(10, 5));
  CHECK(answer_of(answering("{}")).command == Motion{});
}

TEST_CASE("A program may answer all that a behaviour may") {
  const Response response = answer_of(answering(
      R"({"activation":0.5,"strength":0.25,"speed_strength":0,"lateral_strength":0.5,)"
      R"("turn_strength":0.75,"matters":1.5,"status":"success","charge":true,)"
      R"("events":["remote_signal"],"acts":[{"actuator":"lamp","kind":"led","red":255,"on":true},)"
      R"({"kind":"grip","close":1}]})"));
  CHECK(response.activation == 0.5);
  CHECK(response.strength == 0.25);
  CHECK(response.speed_strength == 0.0);
  CHECK(response.lateral_strength == 0.5);
  CHECK(response.turn_strength == 0.75);
  CHECK(response.matters_rad == 1.5);
  CHECK(response.status == Status::success);
  CHECK(response.charge);
  REQUIRE(response.events.size() == 1);
  CHECK(response.events[0].name == "remote_signal");
  REQUIRE(response.acts.size() == 2);
  CHECK(response.acts[0].actuator() == "lamp");
  CHECK(response.acts[0].kind().name == std::string("led"));
  CHECK(response.acts[0].numbers() == NamedNumbers{{"red", 255.0}, {"on", 1.0}});
  CHECK(response.acts[1].actuator().empty());
}

namespace {

/// As a behaviour in C++ defines it.
struct Offer {
  static constexpr const char* kind = "offer";
  double x = 0.0, y = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("x", x);
    visitor("y", y);
  }
};

}  // namespace

TEST_CASE("What a program says is heard as a struct of the same numbers in C++") {
  const Response response = answer_of(
      answering(R"({"say":[{"kind":"offer","to":"r2","by":"radio","numbers":{"x":1.5,"y":-2}}]})"));
  REQUIRE(response.acts.size() == 1);
  CHECK(response.acts[0].actuator() == "radio");
  const auto& said = *static_cast<const SayCommand*>(response.acts[0].command());
  CHECK(said.to == "r2");
  CHECK(said.message->bytes() == sizeof(Offer));
  REQUIRE(said.message->kind() == ReadingKind::of<Offer>());
  const auto& offer = *static_cast<const Offer*>(said.message->content());
  CHECK(offer.x == 1.5);
  CHECK(offer.y == -2.0);
}

TEST_CASE("A program is told its robot, a seed, then what the robot perceives, and the end") {
  const Folder folder;
  const std::string file = folder.file("told");
  {
    Remote remote(noting(file));
    Situation now;
    now.reading(LidarReading{{1.5, 0.1, 2.0}, 4.0}, Mounting{{0.03, 0, 0.1}, 0.5, 0.0}, "front")
        .at(1, 2, 90)
        .mate("r2", 1, 3)
        .charger(3, 0)
        .event("collision")
        .time(0.25)
        .hear(PlaceMessage{0.5F, 1.0F}, {.device = "radio", .from = "r2", .age_s = 0.01});
    now.self.id = "r1";
    remote.respond(now);
    remote.respond(Situation(now).time(0.26));
  }
  const std::vector<Json> told = lines_of(folder.read("told"));
  REQUIRE(told.size() == 5);
  const Json& hello = told[0].at("hello");
  CHECK(hello.at("protocol") == 1);
  CHECK(hello.at("role") == "behavior");
  CHECK(hello.at("robot") == "r1");
  CHECK(hello.at("period") == 0.01);
  CHECK(hello.at("wheels").at("radius") == 0.02);
  const Json& sensor = hello.at("sensors").at(0);
  CHECK(sensor.at("id") == "front");
  CHECK(sensor.at("azimuth") == 0.5);
  CHECK(sensor.at("fields") == Json::parse(R"([{"name":"ranges","unit":"m","size":3}])"));
  CHECK(told[1].at("reset").is_number_integer());
  CHECK(told[2].at("time") == 0.25);
  CHECK(told[2].at("self").at("y") == 2.0);
  CHECK(told[2].at("team").at("mates").at(0).at("distance") == 1.0);
  CHECK(told[2].at("team").at("charger") == Json::parse(R"({"x":3,"y":0})"));
  CHECK(told[2].at("events") == Json::parse(R"(["collision"])"));
  CHECK(told[2].at("heard") ==
        Json::parse(R"([{"kind":"place","device":"radio","from":"r2","age":0.01,)"
                    R"("numbers":{"x":0.5,"y":1}}])"));
  CHECK(told[2].at("readings") ==
        Json::parse(R"({"front":{"kind":"lidar","age":0,"ranges":[1.5,0.1,2]}})"));
  CHECK(told[3].at("time") == 0.26);
  CHECK(told[4] == Json::parse(R"({"end":true})"));
}

TEST_CASE("Numbers are written so that they read back bit for bit") {
  const Folder folder;
  const double x = 0.1 + 0.2, y = 1e-300 / 3.0;
  {
    Remote remote(noting(folder.file("told")));
    remote.respond(Situation().at(x, y, 0));
  }
  const Json self = lines_of(folder.read("told")).at(2).at("self");
  CHECK(self.at("x").get<double>() == x);
  CHECK(self.at("y").get<double>() == y);
}

TEST_CASE("Each run of a robot begins with its seed; the program stays the same") {
  const Folder folder;
  {
    Remote remote("echo $$ >> '" + folder.file("started") + "'; " + noting(folder.file("told")));
    for (const int seed : {1, 2, 1}) {
      remote.reset(static_cast<std::uint64_t>(seed));
      remote.respond(Situation());
    }
  }
  std::vector<Json> seeds;
  for (const Json& line : lines_of(folder.read("told"))) {
    if (line.contains("reset")) seeds.push_back(line.at("reset"));
  }
  REQUIRE(seeds.size() == 3);
  CHECK(seeds[0] == seeds[2]);
  CHECK(seeds[0] != seeds[1]);
  const std::string started = folder.read("started");
  CHECK(std::count(started.begin(), started.end(), '\n') == 1);
}

TEST_CASE("A program is told again what its robot is, if that has changed") {
  const Folder folder;
  {
    Remote remote(noting(folder.file("told")));
    Situation now;
    remote.respond(now);
    remote.equip(now);  // an edit that changes nothing of this
    remote.respond(now);
    now.self.max_speed_m_s = 0.25;
    remote.equip(now);
    remote.respond(now);
  }
  std::vector<double> speeds;
  for (const Json& line : lines_of(folder.read("told"))) {
    if (line.contains("hello")) speeds.push_back(line.at("hello").at("max_speed"));
  }
  CHECK(speeds == std::vector<double>{0.5, 0.25});
}

TEST_CASE("A file is the last word of the command, or is started itself, in its folder") {
  const Folder folder;
  const std::string file =
      folder.write("drive", "#!/bin/sh\npwd > where\n" + answering(R"({"turn":2})") + "\n");
  for (const std::string command : {"sh", "env X=1 sh", ""}) {
    std::filesystem::permissions(file, std::filesystem::perms(command.empty() ? 0700 : 0600));
    testing::Behavior remote("remote", {{"command", command}, {"file", file}});
    CHECK(remote.respond(Situation()).command.turn == 2.0);
    CHECK(folder.read("where") == folder.path().string() + "\n");
  }
}

TEST_CASE("A program may run already and listen on a socket") {
  const Folder folder;
  Listener listener(folder.file("socket"), R"({"forward":0.1})");
  {
    testing::Behavior remote("remote", {{"socket", folder.file("socket")}, {"timeout", 20.0}});
    CHECK(remote.respond(Situation()).command.forward == 0.1);
  }
  const std::vector<Json> told = listener.told();
  REQUIRE(told.size() == 4);
  CHECK(told[3] == Json::parse(R"({"end":true})"));
}

TEST_CASE("A program that coordinates is told what the behaviours answer, and weighs them") {
  const Folder folder;
  Team team;
  team.member("avoid", 2, testing::active(0.5, testing::wheels(10, -10)))
      .member("seek", 1, testing::active(0.25, testing::wheels(20, 20)));
  {
    testing::Coordinator arbiter(
        "arbiter_remote", team,
        {{"command", noting(folder.file("told"), R"({"weights":[1,3],"status":"failure"})")}});
    const Motion expected = 0.25 * testing::wheels(10, -10) + 0.75 * testing::wheels(20, 20);
    CHECK(arbiter.decide() == expected);
    CHECK(arbiter->status() == Status::failure);
  }
  CHECK(team.trace("seek").weight == 3.0);
  CHECK(team.trace("seek").share == 0.75);
  const std::vector<Json> told = lines_of(folder.read("told"));
  CHECK(told.at(0).at("hello").at("role") == "coordinator");
  const Json& member = told.at(2).at("members").at(0);
  CHECK(member.at("name") == "avoid");
  CHECK(member.at("priority") == 2.0);
  CHECK(member.at("activation") == 0.5);
  CHECK(member.at("status") == "running");
  CHECK(member.at("motion").at("forward") == testing::wheels(10, -10).forward);
}

TEST_CASE("A program that coordinates may command a motion of its own") {
  Team team;
  team.member("seek", 1, testing::active(1, testing::wheels(20, 20)));
  testing::Coordinator arbiter("arbiter_remote", team,
                               {{"command", answering(R"({"forward":0.1,"weights":[2]})")}});
  CHECK(arbiter.decide() == Motion{0.1, 0, 0});
  CHECK(team.trace("seek").share == 1.0);
}

TEST_CASE("Exactly one program must be named") {
  const auto refusal = [](const testing::Settings& settings) -> std::string {
    try {
      testing::Behavior("remote", settings);
      return {};
    } catch (const plugin::PluginError& error) {
      return error.what();
    }
  };
  CHECK_THAT(refusal({}), Contains("it names no program; give it a 'command'"));
  CHECK_THAT(refusal({{"command", std::string("x")}, {"socket", std::string("y")}}),
             Contains("it has both a 'command' and a 'socket'"));
}
