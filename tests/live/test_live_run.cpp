// Runs that are watched over the live socket, frame by frame.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <set>

#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/mcap/reader.h"
#include "elsie/recording/mcap_recorder.h"
#include "elsie/simulation/run.h"

#include "show.h"

using namespace elsie;
using namespace elsie::test;
using nlohmann::json;

namespace {

std::uint64_t plain_hash() { return Simulation(lively(), shipped(), {.seed = 3}).run().state_hash; }

constexpr double kNothing = 1e-6;  // s
double seconds(std::uint64_t time_ns) { return static_cast<double>(time_ns) * 1e-9; }

}  // namespace

TEST_CASE("A client gets the abilities of the server, the channels, and the state of the run") {
  Show show(lively());
  Client client(show.port());
  const json facts = json::parse(client.read().bytes);
  CHECK(facts.at("op") == "serverInfo");
  CHECK(facts.at("name") == "elsie test");
  const json& can = facts.at("capabilities");
  for (const char* each : {"time", "playbackControl", "parameters", "parametersSubscribe"}) {
    CHECK(std::find(can.begin(), can.end(), each) != can.end());
  }
  CHECK(facts.at("dataStartTime") == json({{"sec", 0}, {"nsec", 0}}));
  CHECK(facts.at("dataEndTime") == json({{"sec", 6}, {"nsec", 0}}));
  const auto ids = ids_of(client, {"/scene", "/tf", "/world", "/events", "/robots/r1/pose",
                                   "/robots/r1/trace", "/robots/r3/state"});
  std::set<std::uint32_t> different;
  for (const auto& [topic, id] : ids) different.insert(id);
  CHECK(different.size() == ids.size());
  const auto state = client.state("");
  CHECK(state.status == 0);
  CHECK(state.speed == static_cast<float>(kNearlyStill));
  CHECK_FALSE(state.did_seek);
}

TEST_CASE("A subscriber gets the present state at once, and nothing else") {
  Show show(lively());
  Client client(show.port());
  const auto ids = ids_of(client, {"/scene", "/robots/r1/pose"});
  client.subscribe(40, ids.at("/scene"));
  const Message scene = client.message(40);
  CHECK(scene.json().at("entities").size() > 4);
  client.subscribe(41, ids.at("/robots/r1/pose"));
  const Message pose = client.message(41);
  CHECK(pose.json().at("frame_id") == "world");
  client.send({{"op", "unsubscribe"}, {"subscriptionIds", {41}}});
  client.steer(false, 1.0F, 3.0, "there");
  for (;;) {  // a picture at 3 s, without the pose
    const auto frame = client.read();
    const auto message = Client::message_of(frame);
    if (message && message->time_ns > 2'900'000'000) CHECK(message->subscription == 40);
    const auto state = Client::state_of(frame);
    if (state && state->request == "there") break;
  }
}

TEST_CASE("What a client is shown at a time is what a recording has at that time") {
  TemporaryFile file;
  {
    const auto recorder = recording::mcap_recorder(file.path, {.rate_hz = 1000});
    simulation::Observer* const observers[] = {recorder.get()};
    Simulation(lively(), shipped(), {.seed = 3}).run(observers);
  }
  std::map<std::pair<std::string, std::uint64_t>, json> recorded;
  mcap::Reader reader(file.path);
  while (const auto message = reader.next()) {
    recorded[{reader.channels().at(message->channel).topic, message->log_time_ns}] =
        json::parse(message->data);
  }
  Show show(lively());
  Client client(show.port());
  const std::vector<std::string> topics{"/tf", "/robots/r1/pose", "/robots/r1/state",
                                        "/robots/r1/readings", "/robots/r2/command"};
  const auto ids = ids_of(client, topics);
  for (std::uint32_t i = 0; i < topics.size(); ++i) client.subscribe(i, ids.at(topics[i]));
  for (const double time_s : {2.0, 4.0, 1.0, 3.0}) {  // on, back, and on in the past
    const std::string request = "to " + std::to_string(time_s);
    std::map<std::string, json> shown;
    client.steer(false, 1.0F, time_s, request);
    for (bool is_there = false; !is_there;) {
      const auto frame = client.read();
      if (const auto message = Client::message_of(frame)) {
        if (std::abs(seconds(message->time_ns) - time_s) > kNothing) continue;
        const std::string& topic = topics.at(message->subscription);
        shown[topic] = message->json();
        CAPTURE(topic, time_s);
        CHECK((shown[topic] == recorded.at({topic, message->time_ns})));
      }
      const auto state = Client::state_of(frame);
      if (!state || state->request != request) continue;
      is_there = true;
      CHECK(state->status == 1);
      CHECK(state->did_seek);
      CHECK(std::abs(seconds(state->time_ns) - time_s) < kNothing);
    }
    CHECK(shown.size() == topics.size());
  }
}

TEST_CASE("Paused, played at any speed and sought, watched or not, the run is the same") {
  TemporaryFile file;
  const auto recorder = recording::mcap_recorder(file.path);
  Show show(lively(), kNearlyStill, shipped(), {}, {recorder.get()});
  Client client(show.port()), other(show.port(), {.protocols = "foxglove.websocket.v1"});
  const auto ids = ids_of(client, {"/tf", "/scene"});
  client.subscribe(1, ids.at("/tf"));
  client.subscribe(2, ids.at("/scene"));
  client.steer(false, 2.0F, std::nullopt, "pause");
  const auto paused = client.state("pause");
  CHECK(paused.status == 1);
  CHECK(paused.speed == 2.0F);
  client.steer(false, 2.0F, 3.5, "on");
  CHECK(client.state("on").time_ns == 3'500'000'000);
  client.steer(false, 2.0F, 1.5, "back");
  CHECK(client.state("back").time_ns == 1'500'000'000);
  client.steer(true, 1000.0F, std::nullopt, "play");  // through the past, and on
  CHECK(client.state("play").status == 0);
  const auto ended = client.state_that([](const auto& state) { return state.status == 3; });
  CHECK(ended.time_ns == 6'000'000'000);
  CHECK(show.result().state_hash == plain_hash());
  CHECK(show.warnings.empty());

  INFO("After its end");
  client.steer(false, 1.0F, 0.0, "start");
  CHECK(client.state("start").time_ns == 0);
  client.steer(true, 1000.0F, 5.0, "again");
  CHECK(client.state("again").status == 0);
  client.state_that([](const auto& state) { return state.status == 3; });
  show.finish();
  CHECK(show.warnings.empty());

  INFO("The recording is that of the run alone");
  TemporaryFile alone;
  {
    const auto plain = recording::mcap_recorder(alone.path);
    simulation::Observer* const observers[] = {plain.get()};
    Simulation(lively(), shipped(), {.seed = 3}).run(observers);
  }
  const auto bytes = [](const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  CHECK((bytes(file.path) == bytes(alone.path)));
}

TEST_CASE("Where the past reaches the run, nothing is said twice") {
  const world::World world = world::parse_world(R"(<world format="1">
  <arena length="4" width="4"/>
  <obstacles><static_box x="1"/></obstacles>
  <robots><robot id="r1" x="0.4"><behaviors><go_to_point x="1.95"/></behaviors>
    <coordinator><arbiter_suppression/></coordinator></robot></robots>
  <limits time="6"/>
</world>)",
                                                "bump.xml", shipped());
  Simulation alone(world, shipped(), {.seed = 3});
  alone.run();
  const auto all = alone.events().size();
  REQUIRE(all > 0);
  REQUIRE(alone.events().front().time_s > 0.1);
  REQUIRE(alone.events().front().time_s < 4.0);

  Show show(world);
  Client client(show.port());
  client.subscribe(1, ids_of(client, {"/events"}).at("/events"));
  client.steer(false, 1.0F, 4.0, "on");
  client.state("on");
  client.steer(false, 1.0F, 0.1, "back");
  client.state("back");
  client.steer(true, 1000.0F, std::nullopt, "play");
  std::size_t said = 0;
  for (bool is_over = false; !is_over;) {
    const auto frame = client.read();
    if (Client::message_of(frame)) ++said;
    const auto state = Client::state_of(frame);
    is_over = state && state->status == 3;
  }
  CHECK(said == all);
}

TEST_CASE("A request that follows a seek at once does not undo it") {
  Show show(lively());
  Client client(show.port());
  for (const double time_s : {5.0, 1.0}) {
    const auto slowly = static_cast<float>(kNearlyStill);
    client.steer(true, slowly, time_s, "seek");
    client.steer(false, slowly, std::nullopt, "hold");
    CHECK(seconds(client.state("seek").time_ns) == Approx(time_s));
    const auto held = client.state("hold");
    CHECK(seconds(held.time_ns) == Approx(time_s).margin(0.02));
    CHECK(held.status == 1);
  }
}

TEST_CASE("A run that a viewer has made almost stand still goes on when one wants it") {
  world::World world = lively();
  world.physics.control_steps = 10;  // decisions are rare, and orders are obeyed after them
  Show show(world, 1.0);
  Client client(show.port());
  client.steer(true, 1e-30F, std::nullopt, "slow");
  CHECK(client.state("slow").status == 0);
  client.steer(true, 1000.0F, std::nullopt, "quick");
  CHECK(client.state("quick").speed == 1000.0F);
  client.steer(true, 1e30F, std::nullopt, "quicker");  // and no speed is too high
  client.state_that([](const auto& state) { return state.status == 3; });
}

TEST_CASE("The older protocol holds a run by parameters") {
  Show show(lively());
  Client client(show.port(), {.protocols = "foxglove.websocket.v1"});
  const json facts = client.text("serverInfo");
  CHECK_FALSE(facts.contains("dataEndTime"));
  const auto values = [&](const char* id) {
    for (;;) {
      const json answer = client.text("parameterValues");
      if (answer.value("id", "") != id) continue;
      std::map<std::string, json> found;
      for (const json& each : answer.at("parameters")) found[each.at("name")] = each.at("value");
      return found;
    }
  };
  std::map<std::string, json> all;
  do {  // until the run has begun, and said its speed
    client.send({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "all"}});
    all = values("all");
  } while (all.at("speed") != kNearlyStill);
  CHECK(all.at("paused") == false);
  client.send({{"op", "setParameters"},
               {"id", "hold"},
               {"parameters",
                {{{"name", "paused"}, {"value", true}}, {{"name", "time_s"}, {"value", 2.5}}}}});
  const auto held = values("hold");
  CHECK(held.at("paused") == true);
  CHECK(held.at("time_s") == 2.5);
  client.send({{"op", "setParameters"}, {"parameters", {{{"name", "speed"}, {"value", -1}}}}});
  CHECK_THAT(client.text("status").at("message").get<std::string>(),
             Catch::Contains("the speed is no number above 0"));
}

TEST_CASE("A client that does not read loses pictures, and the run nothing") {
  // It decides otherwise in every step, so that there is much to say.
  ScriptedHost restless([](const Perception& now) {
    const bool is_even = std::lround(now.time_s() * 100) % 2 == 0;
    return Response(Motion{is_even ? 0.1 : 0.05, 0.0, 0.1});
  });
  world::World world = one_robot();
  world.limits.time = 60;
  const std::uint64_t end_ns = 60'000'000'000;
  std::unique_ptr<Client> stuck;  // never reads, and outlives the show, whose end does not wait
  Show show(world, 1e6, restless.host);
  stuck = std::make_unique<Client>(show.port());
  Client slow(show.port()), driver(show.port());
  const auto ids = ids_of(slow, {"/tf", "/robots/r1/trace"});
  for (Client* const client : {stuck.get(), &slow}) {
    client->subscribe(1, ids.at("/tf"));
    client->subscribe(2, ids.at("/robots/r1/trace"));
  }
  show.result();
  // From the start again and again, until neither sockets nor queue have room for more.
  for (int i = 0; show.counts().dropped == 0; ++i) {
    const std::string again = "again " + std::to_string(i);
    driver.steer(true, 1e6F, 0.0, again);
    driver.state(again);
    driver.state_that([](const auto& state) { return state.status == 3; });
  }
  INFO("What it reads at last is the present state");
  while (slow.message(1).time_ns != end_ns) {
  }
  CHECK(show.result().state_hash == Simulation(world, restless.host, {.seed = 3}).run().state_hash);
}

TEST_CASE("Messages that nobody has subscribed to are not made") {
  static std::atomic<int> drawn = 0;
  class Drawing final : public Behavior {
    Response respond(const Perception& /*now*/) override { return Response(Motion{0.1, 0.0, 0.0}); }
    void sketch(Sketch& sketch) const override {
      ++drawn;
      sketch.point(SketchRole::hit, {0, 0, 0});
    }
  };
  plugin::Host host{shipped_directory()};
  host.add(
      declaration_of(PluginKind::behavior, "drawing", [] { return std::make_unique<Drawing>(); }));
  world::World world = one_robot(behavior("drawing"));
  world.limits.time = 5;
  drawn = 0;
  Show show(world, 1e6, host);
  show.result();
  CHECK(drawn == 1);  // to know that there is something to subscribe to
  CHECK(show.counts().messages == 0);
  Client client(show.port());
  client.subscribe(1, ids_of(client, {"/robots/r1/sketches"}).at("/robots/r1/sketches"));
  CHECK(client.message(1).json().at("entities").size() == 1);
  CHECK(drawn > 1);
}

TEST_CASE("Robots that an edit adds or removes are announced, on the way there and back") {
  const std::vector<simulation::TimedEdit> edits{
      {2.0, {"robot[+]", R"(<robot id="late" x="2" y="0"/>)"}},
      {4.0, {"robot[r3]/@remove", "true"}}};
  Show show(lively(), kNearlyStill, shipped(), edits);
  Client client(show.port());
  const auto ids = ids_of(client, {"/robots/r3/pose"});
  CHECK_FALSE(ids.contains("/robots/late/pose"));
  client.steer(false, 1.0F, 3.0, "on");
  const auto later = ids_of(client, {"/robots/late/pose"});
  client.steer(false, 1.0F, 5.0, "further");
  CHECK(client.text("unadvertise").at("channelIds").size() == 1);
  client.steer(false, 1.0F, 1.0, "back");
  const auto again = ids_of(client, {"/robots/r3/pose"});
  client.subscribe(1, again.at("/robots/r3/pose"));
  CHECK(client.message(1).time_ns == 1'000'000'000);
}

TEST_CASE("Viewers are told the fault that ends a run") {
  ScriptedHost scripted([](const Perception& now) -> Response {
    if (now.time_s() > 0.5) throw std::runtime_error("enough");
    return Motion{0.1, 0, 0};
  });
  Simulation simulation(one_robot(), scripted.host, {.seed = 3});
  live::LiveRun live(live::Address{.port = 0}, {.speed = 1.0});
  live.open(simulation, {});
  Client client(live.address().port);
  client.text("serverInfo");
  simulation::Observer* const observers[] = {&live};
  CHECK_THROWS_AS(simulation.run(observers), simulation::PluginFault);
  CHECK_THAT(client.text("status").at("message").get<std::string>(), Catch::EndsWith(": enough"));
}

TEST_CASE("A seek that cannot be made is answered with a sentence") {
  Simulation simulation(lively(), shipped(), {.seed = 3});
  std::atomic<bool> is_over = false;
  live::LiveRun live(live::Address{.port = 0},
                     {.speed = kNearlyStill, .is_interrupted = [&] { return is_over.load(); }});
  live.open(simulation, {.reason = "this run cannot go back"});
  std::thread thread([&] {
    simulation::Observer* const observers[] = {&live};
    simulation::Run run(simulation, observers);
    while (!is_over && run.step()) {
    }
  });
  {
    Client client(live.address().port);
    client.steer(false, 1.0F, 2.0, "on");
    CHECK(client.state("on").did_seek);
    client.steer(false, 1.0F, 1.0, "back");
    CHECK(client.text("status").at("message") == "this run cannot go back");
    const auto state = client.state("back");
    CHECK_FALSE(state.did_seek);
    CHECK(state.time_ns == 2'000'000'000);
  }
  is_over = true;
  thread.join();
}

TEST_CASE("Foreign pages, foreign names and unknown protocols get a sentence and no run") {
  Show show(lively());
  CHECK(knock(show.port(), {}).status == 101);
  CHECK(knock(show.port(), {.protocols = "foxglove.websocket.v1, foxglove.sdk.v1"}).protocol ==
        "foxglove.sdk.v1");
  CHECK(knock(show.port(), {.origin = "https://app.foxglove.dev"}).status == 101);
  CHECK(knock(show.port(), {.origin = "https://viewer.example.org"}).status == 101);
  const Answer foreign = knock(show.port(), {.origin = "https://evil.example"});
  CHECK(foreign.status == 403);
  CHECK_THAT(foreign.body, Catch::Contains("pages of 'https://evil.example' may not watch"));
  const Answer rebound = knock(show.port(), {.host = "evil.example:8765"});
  CHECK(rebound.status == 403);
  CHECK_THAT(rebound.body, Catch::Contains("'evil.example:8765' is no numeric address"));
  CHECK(knock(show.port(), {.protocols = "chat"}).status == 400);
  CHECK(knock(show.port(), {.protocols = ""}).status == 400);
  const Answer opened = knock(show.port(), {.upgrades = false});
  CHECK(opened.status == 426);
  CHECK_THAT(opened.body, Catch::Contains("open this address in Foxglove"));
}

TEST_CASE("Frames that mean nothing are answered, and too large ones end their connection alone") {
  Show show(lively());
  Client client(show.port()), large(show.port());
  client.send_text("hello");
  CHECK(client.text("status").at("level") == 2);
  client.send_bytes("\xff\xff");
  CHECK_THAT(client.text("status").at("message").get<std::string>(),
             Catch::Contains("kind is 255"));
  client.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", 100'000}}}}});
  CHECK_THAT(client.text("status").at("message").get<std::string>(),
             Catch::Contains("the channel 100000, which does not exist"));
  INFO("A request that is wrong a thousand times gets ten sentences, and one about the rest");
  json all = json::array();
  for (int i = 0; i < 1000; ++i) all.push_back(i);
  client.send({{"op", "unsubscribe"}, {"subscriptionIds", all}});
  for (int i = 0; i < 10; ++i) {
    CHECK(client.text("status").at("message") == "there is no subscription " + std::to_string(i));
  }
  CHECK_THAT(client.text("status").at("message").get<std::string>(),
             Catch::StartsWith("990 more subscriptions"));
  // The server closes before all of it is sent: the code may be lost on the way.
  try {
    large.send_text(std::string(2U << 20U, 'x'));
  } catch (const std::exception& error) {
    INFO(error.what());
  }
  const int code = large.close_code();
  CHECK((code == 1009 || code == 0));
  client.steer(false, 1.0F, std::nullopt, "still there");
  CHECK(client.state("still there").status == 1);
}

TEST_CASE("There is room for 32 clients; one that leaves makes room") {
  Show show(lively());
  std::vector<std::unique_ptr<Client>> clients;
  while (clients.size() < 32) {
    clients.push_back(std::make_unique<Client>(show.port()));
    clients.back()->text("serverInfo");
  }
  CHECK(knock(show.port(), {}).status == 503);
  clients.clear();
  int status = 503;
  while (status == 503) status = knock(show.port(), {}).status;
  CHECK(status == 101);
}

TEST_CASE("Connections that say nothing take nobody's place") {
  Show show(lively());
  std::vector<std::shared_ptr<void>> silent;
  for (int i = 0; i < 40; ++i) silent.push_back(keep_silent(show.port()));
  CHECK(knock(show.port(), {}).status == 101);
}

TEST_CASE("A server that ends says good-bye") {
  auto show = std::make_unique<Show>(lively());
  Client client(show->port());
  std::thread ending([&] { show.reset(); });
  CHECK(client.close_code() == 1001);
  ending.join();
}

TEST_CASE("A port that another program uses is refused with a sentence") {
  Show show(lively());
  CHECK_THROWS_MATCHES(
      live::LiveRun(live::Address{.port = show.port()}, {}), base::BadInput,
      Catch::Message("--live: cannot listen on ws://127.0.0.1:" + std::to_string(show.port()) +
                     ": the port is in use by another program; choose another one, or 0 for any "
                     "free one: --live 0"));
}
