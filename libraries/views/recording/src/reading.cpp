#include "reading.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/mcap/reader.h"

namespace elsie::recording {
namespace {

/// A number in metadata; zero if it is not a number.
template <class Number>
Number number(const std::map<std::string, std::string>& values, const char* name) {
  Number value{};
  if (const auto at = values.find(name); at != values.end()) {
    std::from_chars(at->second.data(), at->second.data() + at->second.size(), value);
  }
  return value;
}

std::string text(const std::map<std::string, std::string>& values, const char* name) {
  const auto at = values.find(name);
  return at == values.end() ? "" : at->second;
}

void take(RecordedRun& run, const mcap::Metadata& metadata) {
  const auto& values = metadata.values;
  if (metadata.name == kRunMetadata) {
    run.of_elsie = true;
    run.world = text(values, "world");
    run.world_file = text(values, "file");
    run.seed = number<std::uint64_t>(values, "seed");
    run.time_limit_s = number<double>(values, "time_limit_s");
    run.step_s = number<double>(values, "step_s");
    run.control_steps = number<std::uint64_t>(values, "control_steps");
    run.sample_steps = number<std::uint64_t>(values, "sample_steps");
    run.period_s = run.step_s * static_cast<double>(run.sample_steps);
  } else if (metadata.name == kResultMetadata) {
    run.result =
        RecordedResult{text(values, "outcome"),          text(values, "reason"),
                       number<double>(values, kEndTime), number<std::uint64_t>(values, "steps"),
                       text(values, "state_hash"),       {}};
  } else if (metadata.name == kMeasuresMetadata && run.result) {
    for (const auto& [name, value] : values) {
      run.result->measures[name] = number<double>(values, name.c_str());
    }
  }
}

}  // namespace

std::pair<std::string, std::string> robot_and_kind(const mcap::Channel& channel) {
  const auto robot = channel.metadata.find("robot");
  if (robot == channel.metadata.end()) {
    return {};
  }
  const std::string start = robot_topic(robot->second, "");
  return channel.topic.starts_with(start)
             ? std::pair(robot->second, channel.topic.substr(start.size()))
             : std::pair<std::string, std::string>();
}

std::optional<events::Changed> edit_of(const Json& event) {
  if (event.at("event") != events::Changed::kFacts.name) return std::nullopt;
  return events::Changed{event.at("element"), event.at("attribute"), event.at("value"),
                         event.value("rule", "")};
}

void read_file(const std::filesystem::path& file, RecordedRun& run, Visitor& visitor) {
  mcap::Reader reader(file);
  std::map<std::uint16_t, std::uint64_t> counts;  // of messages, by channel
  std::size_t metadata = 0;
  const auto checked = [&](const std::string& what, const auto& look) {
    const auto refuse = [&](const std::exception& error) {
      throw mcap::McapError("recording '" + file.string() + "': " + what +
                            " is not as Elsie writes it: " + error.what());
    };
    try {
      look();
    } catch (const Json::exception& error) {
      refuse(error);
    } catch (const Unexpected& error) {
      refuse(error);
    }
  };
  const auto catch_up = [&] {
    for (; metadata < reader.metadata().size(); ++metadata) {
      take(run, reader.metadata()[metadata]);
    }
    const auto& channels = reader.channels();
    for (auto next = counts.empty() ? channels.begin()
                                    : channels.upper_bound(counts.rbegin()->first);
         next != channels.end(); ++next) {
      counts[next->first] = 0;
      if (run.of_elsie) {
        checked("the channel " + next->second.topic, [&] { visitor.channel(next->second); });
      }
    }
  };
  while (const auto message = reader.next()) {
    catch_up();
    ++run.messages;
    ++counts[message->channel];
    const double time_s = static_cast<double>(message->log_time_ns) / kSecondNs;
    run.end_s = std::max(run.end_s, time_s);
    if (run.of_elsie) {
      const mcap::Channel& channel = reader.channels().at(message->channel);
      checked("a message on " + channel.topic + " at " + std::to_string(time_s) + " s",
              [&] { visitor.message(channel, *message); });
    }
  }
  catch_up();
  run.library = reader.header().library;
  for (const auto& [id, channel] : reader.channels()) {
    const auto schema = reader.schemas().find(channel.schema);
    run.channels.push_back(
        {channel.topic, schema == reader.schemas().end() ? "" : schema->second.name, counts[id]});
  }
  run.missing_end = reader.missing_end();
}

}  // namespace elsie::recording
