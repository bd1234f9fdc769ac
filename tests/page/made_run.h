// Recordings of small runs, for the tests of pages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "elsie/mcap/writer.h"

#include "recorded.h"

namespace elsie::test {

/// Text that would run a script where a page forgot to escape it.
inline const std::string kHostileText =
    "</script><script>window.hacked=1</script><img src=x onerror=\"window.hacked=1\"> {{data}} "
    "'\"&";

/// Two robots of two teams, r1 and r2, that wander.
inline world::World two_robots() {
  world::World world = shipped_world("open_arena.xml", 20);
  world.arena.length = world.arena.width = 6.0;
  REQUIRE_FALSE(world.robots.empty());
  world::Robot robot = world.robots[0];
  world.robots = {robot, robot};
  world.robots[0].id = "r1";
  world.robots[0].team = "red";
  world.robots[1].id = "r2";
  world.robots[1].team = "blue";
  world.robots[0].x = -1.5;
  world.robots[1].x = 1.5;
  world.robots[0].y = world.robots[1].y = 0.0;
  world.robots[1].heading_deg = 90.0;
  return world;
}

/// Copies a recording as one that means harm would write it: wherever a text may be anything, it is
/// kHostileText.
inline void write_hostile(const std::filesystem::path& recording,
                          const std::filesystem::path& file) {
  mcap::Reader reader(recording);
  mcap::Writer writer(file, {.library = reader.header().library});
  std::map<std::uint16_t, std::uint16_t> channels;
  std::size_t taken = 0;
  const auto take_metadata = [&] {
    for (; taken < reader.metadata().size(); ++taken) {
      mcap::Metadata metadata = reader.metadata()[taken];
      for (const char* const name : {"world", "file", "reason"}) {
        if (metadata.values.contains(name)) metadata.values[name] = kHostileText;
      }
      if (metadata.name == "elsie.measures") metadata.values[kHostileText] = "1";
      writer.write(metadata);
    }
  };
  while (const auto message = reader.next()) {
    take_metadata();
    const mcap::Channel& channel = reader.channels().at(message->channel);
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(message->data);
    if (!channels.contains(channel.id)) {
      channels[channel.id] = writer.add_channel(channel.topic, 0, "json", channel.metadata);
      if (channel.topic == "/robots/r1/trace") {
        const auto events = writer.add_channel("/events", 0, "json");
        const nlohmann::json event{
            {"level", 3}, {"name", "r1"}, {"event", kHostileText}, {"detail", kHostileText}};
        writer.write(events, message->log_time_ns, event.dump());
      }
    }
    if (channel.topic.ends_with("/trace")) {
      for (auto& row : json.at("behaviors")) row["reason"] = kHostileText;
    }
    writer.write(channels[channel.id], message->log_time_ns, json.dump());
  }
  take_metadata();
  writer.close();
}

}  // namespace elsie::test
