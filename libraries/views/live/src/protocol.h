// The frames of Foxglove's live protocol: JSON in text frames, and binary ones whose numbers are
// little-endian (https://github.com/foxglove/ws-protocol, docs/spec.md). `foxglove.sdk.v1` is the
// same with control of playback added.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "gate.h"

namespace elsie::live {

using Json = nlohmann::ordered_json;

enum class Level { info, warning, error };

/// How the run goes; its numbers are those of the protocol.
enum class Phase : std::uint8_t { playing, paused, seeking, ended };
struct Playback {
  Phase phase = Phase::playing;
  std::uint64_t time_ns = 0;
  double speed = 1.0;  // simulated seconds per second

  bool operator==(const Playback&) const = default;
};

// What the server says.

struct ServerFacts {
  std::string program;       // "elsie 0.1.0"
  std::string session;       // differs from that of any other run
  std::uint64_t end_ns = 0;  // of the run, or its limit
  std::map<std::string, std::string> metadata{};
};
std::string server_info(const ServerFacts& facts, Protocol protocol);
/// One channel of an advertisement.
std::string channel_text(std::uint32_t id, const std::string& topic, const std::string& schema_name,
                         const std::string& schema);
std::string advertisement(const std::vector<std::string_view>& channels);
std::string unadvertisement(const std::vector<std::uint32_t>& channels);
std::string status(Level level, const std::string& sentence);
/// What comes before the payload of a message.
std::string message_head(std::uint32_t subscription, std::uint64_t time_ns);
std::string time_frame(std::uint64_t time_ns);
/// `request`: the id of the request that it answers; empty: none.
std::string playback_frame(const Playback& playback, bool did_seek, std::string_view request);
/// The values of the parameters of these names; none: of all.
std::string parameter_values(const Playback& playback, const std::vector<std::string>& names,
                             const std::string& id);

// What a client asks.

struct Subscribe {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> channels;  // each with its subscription
};
struct Unsubscribe {
  std::vector<std::uint32_t> subscriptions;
};
struct GetParameters {
  std::vector<std::string> names;
  std::string id;
};
struct WatchParameters {
  bool on = true;
};
/// To play, pause, or go to a time; what is not there stays as it is.
struct Steer {
  std::optional<bool> plays{};
  std::optional<double> speed{};
  std::optional<std::uint64_t> seek_ns{};
  std::string id{};              // of the request
  bool is_by_parameter = false;  // otherwise by the control of playback
};
/// A frame that cannot be used, and why.
struct Refused {
  std::string sentence;
};
using Request =
    std::variant<Subscribe, Unsubscribe, GetParameters, WatchParameters, Steer, Refused>;

/// Both take anything.
Request request_of_text(std::string_view text);
Request request_of_bytes(std::string_view bytes);

}  // namespace elsie::live
