#include "protocol.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace elsie::live {
namespace {

static_assert(std::endian::native == std::endian::little, "the order of bytes in frames");

constexpr std::uint64_t kSecond = 1'000'000'000;

// Binary frames of the server.
constexpr char kMessage = 1, kTime = 2, kPlaybackState = 5;
// Binary frames of a client.
constexpr char kPlaybackRequest = 3;

constexpr std::size_t kLongestId = 256;
constexpr const char* kTooLongId = "the id of a request is longer than 256 bytes";

constexpr const char *kPaused = "paused", *kSpeed = "speed", *kTimeS = "time_s";

template <class Number>
void add(std::string& bytes, Number number) {
  const std::size_t begin = bytes.size();
  bytes.resize(begin + sizeof(number));
  std::memcpy(bytes.data() + begin, &number, sizeof(number));
}

/// Takes the next number; none: the bytes have ended.
template <class Number>
std::optional<Number> take(std::string_view& bytes) {
  if (bytes.size() < sizeof(Number)) return std::nullopt;
  Number number;
  std::memcpy(&number, bytes.data(), sizeof(number));
  bytes.remove_prefix(sizeof(number));
  return number;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json time_json(std::uint64_t time_ns) {
  return {{"sec", time_ns / kSecond}, {"nsec", time_ns % kSecond}};
}

/// Thrown while a request is read; what() is the sentence.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const Json& member(const Json& json, const char* name) {
  const auto found = json.is_object() ? json.find(name) : json.end();
  if (!json.is_object() || found == json.end()) {
    throw Wrong(std::string("it has no '") + name + "'");
  }
  return *found;
}

const Json& list(const Json& json, const char* name) {
  const Json& all = member(json, name);
  if (!all.is_array()) throw Wrong(std::string("'") + name + "' is no list");
  return all;
}

std::uint32_t id_of(const Json& json, const char* name) {
  if (!json.is_number_unsigned() ||
      json.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
    throw Wrong(std::string("'") + name + "' is no whole number from 0 to 4294967295");
  }
  return json.get<std::uint32_t>();
}

std::string word(const Json& json, const char* name) {
  if (!json.is_string()) throw Wrong(std::string("'") + name + "' is no text");
  return json.get<std::string>();
}

/// The id of a request about parameters, which it need not have.
std::string request_id(const Json& json) {
  std::string id = json.contains("id") ? word(json.at("id"), "id") : std::string();
  if (id.size() > kLongestId) throw Wrong(kTooLongId);
  return id;
}

double number_of(const Json& json, const char* name, const char* expected) {
  if (!json.is_number() || !std::isfinite(json.get<double>())) {
    throw Wrong(std::string("'") + name + "' is no number; expected " + expected);
  }
  return json.get<double>();
}

double speed_of(double speed) {
  if (!std::isfinite(speed) || speed <= 0.0) {
    throw Wrong("the speed is no number above 0; expected simulated seconds per second, such as 1");
  }
  return speed;
}

std::uint64_t time_of(double time_s) {
  constexpr double kMost = 9e9;  // s: longer than any run, and its nanoseconds fit
  if (time_s < 0.0) throw Wrong("'time_s' is below 0; expected a time in seconds");
  return static_cast<std::uint64_t>(std::llround(std::min(time_s, kMost) * 1e9));
}

Steer steer_of(const Json& json) {
  Steer steer{.id = request_id(json), .is_by_parameter = true};
  for (const Json& parameter : list(json, "parameters")) {
    const std::string name = word(member(parameter, "name"), "name");
    const Json& value = member(parameter, "value");
    if (name == kPaused) {
      if (!value.is_boolean()) throw Wrong("'paused' is neither true nor false");
      steer.plays = !value.get<bool>();
    } else if (name == kSpeed) {
      steer.speed = speed_of(number_of(value, kSpeed, "simulated seconds per second"));
    } else if (name == kTimeS) {
      steer.seek_ns = time_of(number_of(value, kTimeS, "a time in seconds"));
    } else {
      throw Wrong("there is no parameter '" + name + "'; expected paused, speed or time_s");
    }
  }
  return steer;
}

Request request_of(const Json& json) {
  const std::string op = word(member(json, "op"), "op");
  if (op == "subscribe") {
    Subscribe subscribe;
    for (const Json& each : list(json, "subscriptions")) {
      const std::uint32_t id = id_of(member(each, "id"), "id");
      subscribe.channels.emplace_back(id, id_of(member(each, "channelId"), "channelId"));
    }
    return subscribe;
  }
  if (op == "unsubscribe") {
    Unsubscribe unsubscribe;
    for (const Json& each : list(json, "subscriptionIds")) {
      unsubscribe.subscriptions.push_back(id_of(each, "subscriptionIds"));
    }
    return unsubscribe;
  }
  if (op == "getParameters") {
    GetParameters get{.names = {}, .id = request_id(json)};
    for (const Json& each : list(json, "parameterNames")) {
      get.names.push_back(word(each, "parameterNames"));
    }
    return get;
  }
  if (op == "setParameters") return steer_of(json);
  if (op == "subscribeParameterUpdates") return WatchParameters{true};
  if (op == "unsubscribeParameterUpdates") return WatchParameters{false};
  throw Wrong("the operation '" + op + "' is not offered; this server shows a run, and takes " +
              "subscribe, unsubscribe, and what sets and gets parameters");
}

}  // namespace

std::string server_info(const ServerFacts& facts, Protocol protocol) {
  Json info{{"op", "serverInfo"},
            {"name", facts.program},
            {"capabilities", {"time", "parameters", "parametersSubscribe"}},
            {"supportedEncodings", {"json"}},
            {"metadata", facts.metadata},
            {"sessionId", facts.session}};
  if (protocol == Protocol::sdk) {
    info["capabilities"].push_back("playbackControl");
    info["dataStartTime"] = time_json(0);
    info["dataEndTime"] = time_json(facts.end_ns);
  }
  return text_of(info);
}

std::string channel_text(std::uint32_t id, const std::string& topic, const std::string& schema_name,
                         const std::string& schema) {
  return text_of({{"id", id},
                  {"topic", topic},
                  {"encoding", "json"},
                  {"schemaName", schema_name},
                  {"schema", schema},
                  {"schemaEncoding", "jsonschema"}});
}

std::string advertisement(const std::vector<std::string_view>& channels) {
  std::string text = R"({"op":"advertise","channels":[)";
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (i > 0) text += ',';
    text += channels[i];
  }
  return text += "]}";
}

std::string unadvertisement(const std::vector<std::uint32_t>& channels) {
  return text_of({{"op", "unadvertise"}, {"channelIds", channels}});
}

std::string status(Level level, const std::string& sentence) {
  return text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", sentence}});
}

std::string message_head(std::uint32_t subscription, std::uint64_t time_ns) {
  std::string bytes(1, kMessage);
  add(bytes, subscription);
  add(bytes, time_ns);
  return bytes;
}

std::string time_frame(std::uint64_t time_ns) {
  std::string bytes(1, kTime);
  add(bytes, time_ns);
  return bytes;
}

std::string playback_frame(const Playback& playback, bool did_seek, std::string_view request) {
  std::string bytes(1, kPlaybackState);
  add(bytes, static_cast<std::uint8_t>(playback.phase));
  add(bytes, playback.time_ns);
  add(bytes, static_cast<float>(playback.speed));
  add(bytes, static_cast<std::uint8_t>(did_seek));
  add(bytes, static_cast<std::uint32_t>(request.size()));
  return bytes += request;
}

std::string parameter_values(const Playback& playback, const std::vector<std::string>& names,
                             const std::string& id) {
  Json values = Json::array();
  const auto add = [&](const char* name, const Json& value, bool is_number) {
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) return;
    values.push_back({{"name", name}, {"value", value}});
    if (is_number) values.back()["type"] = "float64";
  };
  add(kPaused, playback.phase != Phase::playing && playback.phase != Phase::seeking, false);
  add(kSpeed, playback.speed, true);
  add(kTimeS, static_cast<double>(playback.time_ns) * 1e-9, true);
  Json message{{"op", "parameterValues"}, {"parameters", std::move(values)}};
  if (!id.empty()) message["id"] = id;
  return text_of(message);
}

Request request_of_text(std::string_view text) {
  constexpr int kDeepest = 8;
  bool is_deep = false;
  const auto callback = [&](int depth, Json::parse_event_t, Json&) {
    is_deep |= depth > kDeepest;
    return depth <= kDeepest;
  };
  const Json json = Json::parse(text, callback, false);
  if (json.is_discarded() || is_deep) {
    return Refused{is_deep ? "a message is nested too deeply" : "a message is no JSON"};
  }
  try {
    return request_of(json);
  } catch (const Wrong& wrong) {
    return Refused{std::string("a message cannot be used: ") + wrong.what()};
  }
}

Request request_of_bytes(std::string_view bytes) {
  const std::string op =
      bytes.empty() ? "none" : std::to_string(static_cast<unsigned char>(bytes[0]));
  if (bytes.empty() || bytes[0] != kPlaybackRequest) {
    return Refused{"a binary message cannot be used: its kind is " + op +
                   "; expected 3, control of playback"};
  }
  bytes.remove_prefix(1);
  const auto command = take<std::uint8_t>(bytes);
  const auto speed = take<float>(bytes);
  const auto seeks = take<std::uint8_t>(bytes);
  const auto seek_ns = take<std::uint64_t>(bytes);
  const auto length = take<std::uint32_t>(bytes);
  if (!length || bytes.size() < *length) {
    return Refused{"a binary message cannot be used: it ends too early"};
  }
  if (*length > kLongestId) return Refused{kTooLongId};
  if (*command > 1) {
    return Refused{"control of playback: the command is " + std::to_string(*command) +
                   "; expected 0, play, or 1, pause"};
  }
  try {
    Steer steer{.plays = *command == 0,
                .speed = speed_of(static_cast<double>(*speed)),
                .id = std::string(bytes.substr(0, *length))};
    if (*seeks != 0) steer.seek_ns = *seek_ns;
    return steer;
  } catch (const Wrong& wrong) {
    return Refused{std::string("control of playback: ") + wrong.what()};
  }
}

}  // namespace elsie::live
