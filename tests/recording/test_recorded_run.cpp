#include <random>

#include <catch2/catch.hpp>

#include "recorded.h"

using namespace elsie;
using namespace elsie::test;
using recording::read_recorded_run;
using simulation::Simulation;

namespace {

/// A file with the head of a recording and one message, which may be wrong.
void write_message(const std::filesystem::path& file, const std::string& topic,
                   const std::string& message) {
  mcap::Writer writer(file);
  writer.write(mcap::Metadata{"elsie.run", {{"step_s", "0.01"}, {"sample_steps", "10"}}});
  const auto channel = writer.add_channel(topic, 0, "json", {{"robot", "r1"}});
  writer.write(channel, 100'000'000, message);
  writer.close();
}

}  // namespace

TEST_CASE("A recording tells what ran, how it ended, and what is in which channel") {
  McapFile file;
  Simulation simulation(shipped_world("train.xml", 2), shipped(), {.seed = 5});
  const auto result = record(simulation, file.path, {.program = "elsie 0.0.0"});
  const auto run = read_recorded_run(file.path);
  CHECK(run.of_elsie);
  CHECK(run.library == "elsie 0.0.0");
  CHECK(run.world == simulation.world().name);
  CHECK(run.seed == 5);
  CHECK(run.step_s == 0.01);
  CHECK(run.period_s == Approx(0.1));
  CHECK(run.end_s == Approx(2.0));
  CHECK(run.missing_end.empty());
  REQUIRE(run.result);
  CHECK(run.result->outcome == to_string(result.outcome));
  CHECK(run.result->reason == result.reason);
  CHECK(run.result->steps == 200);
  std::uint64_t messages = 0;
  for (const auto& channel : run.channels) {
    messages += channel.messages;
    CHECK(!channel.schema.empty());
  }
  CHECK(messages == run.messages);
  REQUIRE(run.robots.size() == 1);
  CHECK(run.robots[0].path.size() == 21);
  CHECK(run.robots[0].now == result.robots[0].pose);
  REQUIRE(run.robots[0].segments.size() == simulation.world().robots[0].segments.size());
  for (std::size_t i = 0; i < run.robots[0].segments.size(); ++i) {
    CHECK(run.robots[0].segments[i] == simulation.segment(0, i).pose);
  }
}

TEST_CASE("The world in a recording runs again as it ran, whatever ended the run") {
  McapFile file;
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  const auto read = [&](const std::string& text) {
    return world::parse_world(text, source_path("worlds/again.xml"), shipped(), options);
  };
  const world::World endures = read(R"(<world format="1">
      <robots><robot id="r1" template="robots/scout.xml"/></robots>
      <goals><endure time="20"/></goals><limits time="30"/></world>)");
  Simulation first(endures, shipped(), {.seed = 7, .time_limit_s = 1.5});
  const auto result = record(first, file.path);
  CHECK(result.outcome == simulation::Outcome::time_limit);
  CHECK(result.simulated_s == Approx(1.5));
  const auto run = read_recorded_run(file.path);
  CHECK(run.time_limit_s == 1.5);
  Simulation again(read(run.world_xml), shipped(),
                   {.seed = run.seed, .time_limit_s = run.time_limit_s});
  CHECK(again.world().limits.time == 30.0);
  CHECK(again.run().state_hash == result.state_hash);
}

TEST_CASE("What was there at a time is what was sampled until then") {
  const RecordedFile file(shipped_world("open_arena.xml", 2), shipped());
  const auto whole = read_recorded_run(file.path);
  const auto half = read_recorded_run(file.path, 1.05);
  REQUIRE(half.robots.size() == 1);
  CHECK(half.shown_s == Approx(1.0));
  CHECK(half.robots[0].path.size() == 11);
  CHECK(half.robots[0].now == whole.robots[0].path[10]);
  CHECK(half.messages == whole.messages);  // of the file
  CHECK(read_recorded_run(file.path, 0.0).robots[0].path.size() == 1);
  CHECK(read_recorded_run(file.path, 0.3).robots[0].path.size() == 4);
}

TEST_CASE("A recording that breaks off is read up to there, at every length") {
  const RecordedFile file(shipped_world("open_arena.xml", 4), shipped());
  const std::string bytes = file.bytes();
  McapFile cut;
  std::size_t read = 0;
  for (std::size_t length = 200; length < bytes.size(); length += 97) {
    cut.set(bytes.substr(0, length));
    const auto run = read_recorded_run(cut.path);
    CHECK(!run.missing_end.empty());
    if (!run.robots.empty()) {
      CHECK(run.robots[0].path.size() >= read);
      read = run.robots[0].path.size();
    }
  }
  CHECK(read == 41);
}

TEST_CASE("Of an MCAP file that is not from Elsie only the channels are listed") {
  McapFile file;
  write_small(file.path, 2);
  const auto run = read_recorded_run(file.path);
  CHECK(!run.of_elsie);
  REQUIRE(run.channels.size() == 2);
  CHECK(run.channels[0].topic == "/fast");
  CHECK(run.channels[0].schema == "example.Point");
  CHECK(run.channels[0].messages == 4);
  CHECK(run.channels[1].schema.empty());
}

TEST_CASE("A message that is not as Elsie writes it is an error that names channel and time") {
  McapFile file;
  for (const auto& [topic, message] :
       {std::pair{"/robots/r1/state", R"({"x_m": "here"})"},
        {"/robots/r1/state", "{"},
        {"/robots/r1/state", R"({"x_m": 1e999, "y_m": 0, "heading_rad": 0})"},
        {"/robots/r1/sketches", R"({"entities": [{"id": "r1/eye"}]})"},
        {"/tf", "[]"},
        {"/scene", R"({"a": 1})"},
        {"/events", R"({"name": 7})"},
        {"/world", R"({"xml": null})"}}) {
    write_message(file.path, topic, message);
    INFO(topic << ' ' << message);
    CHECK_THROWS_WITH(read_recorded_run(file.path),
                      Catch::Contains(std::string("a message on ") + topic + " at 0.100000 s"));
  }
}

TEST_CASE("Whatever messages say, reading them and drawing them ends") {
  McapFile source;
  world::World world = shipped_world("pushing.xml", 1);
  Simulation simulation(world, shipped());
  record(simulation, source.path, {.rate_hz = 2});
  // The same messages, some of them changed, in a file that is sound as a file.
  std::mt19937 random(1);
  McapFile file;
  TemporaryFile picture;
  const std::filesystem::path png = picture.path.string() + ".png";
  for (int round = 0; round < 200; ++round) {
    {
      mcap::Reader reader(source.path);
      mcap::Writer writer(file.path);
      std::map<std::uint16_t, std::uint16_t> ids;
      bool head = false;
      while (const auto message = reader.next()) {
        if (!std::exchange(head, true)) {
          writer.write(reader.metadata().front());
        }
        const auto& channel = reader.channels().at(message->channel);
        if (!ids.contains(channel.id)) {
          ids[channel.id] = writer.add_channel(channel.topic, 0, "json", channel.metadata);
        }
        std::string data(message->data);
        if (random() % 8 == 0) {
          data[random() % data.size()] = "09-e{}[],:\"xn."[random() % 14];
        }
        writer.write(ids[channel.id], message->log_time_ns, data);
      }
      writer.close();
    }
    try {
      recording::read_trace(file.path);
    } catch (const mcap::McapError& error) {
      CHECK(std::string(error.what()).size() > 10);
    }
    try {
      recording::save_picture(read_recorded_run(file.path), shipped(), {"changed"}, png, {300, 0});
    } catch (const std::exception& error) {
      CHECK(std::string(error.what()).size() > 10);
    }
  }
  std::filesystem::remove(png);
}
