// Frames of clients, as they may come from anyone.
#include <catch2/catch.hpp>

#include "protocol.h"

using namespace elsie::live;
using namespace std::string_literals;

namespace {

std::string refusal(const Request& request) {
  const auto* const refused = std::get_if<Refused>(&request);
  return refused ? refused->sentence : "";
}

}  // namespace

TEST_CASE("Requests in JSON are read") {
  const auto subscribe = std::get<Subscribe>(request_of_text(
      R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},
          {"id":4294967295,"channelId":1}]})"));
  CHECK(subscribe.channels ==
        std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 3}, {4294967295, 1}});
  CHECK(std::get<Unsubscribe>(request_of_text(R"({"op":"unsubscribe","subscriptionIds":[7]})"))
            .subscriptions == std::vector<std::uint32_t>{7});
  const auto steer = std::get<Steer>(request_of_text(
      R"({"op":"setParameters","id":"x","parameters":[{"name":"paused","value":true},
          {"name":"speed","value":2,"type":"float64"},{"name":"time_s","value":1.5}]})"));
  CHECK(steer.plays == false);
  CHECK(steer.speed == 2.0);
  CHECK(steer.seek_ns == 1'500'000'000);
  CHECK(steer.id == "x");
}

TEST_CASE("Control of playback is read byte by byte") {
  const auto steer = std::get<Steer>(request_of_bytes(
      "\x03\x01\x00\x00\x80\x3f\x01\x00\x94\x35\x77\x00\x00\x00\x00\x02\x00\x00\x00me"s));
  CHECK(steer.plays == false);
  CHECK(steer.speed == 1.0);
  CHECK(steer.seek_ns == 2'000'000'000);
  CHECK(steer.id == "me");
  CHECK_FALSE(steer.is_by_parameter);
}

TEST_CASE("What cannot be used is refused with a sentence") {
  const std::pair<std::string, const char*> texts[] = {
      {"", "no JSON"},
      {"{", "no JSON"},
      {"[]", "no 'op'"},
      {"7", "no 'op'"},
      {R"({"op":7})", "'op' is no text"},
      {R"({"op":"dance"})", "'dance' is not offered"},
      {R"({"op":"advertise","channels":[]})", "'advertise' is not offered"},
      {R"({"op":"subscribe"})", "no 'subscriptions'"},
      {R"({"op":"subscribe","subscriptions":{}})", "is no list"},
      {R"({"op":"subscribe","subscriptions":[3]})", "no 'id'"},
      {R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})", "no whole number"},
      {R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})",
       "no whole number"},
      {R"({"op":"setParameters","parameters":[{"name":"speed","value":0}]})", "no number above 0"},
      {R"({"op":"setParameters","parameters":[{"name":"speed","value":"fast"}]})", "no number"},
      {R"({"op":"setParameters","parameters":[{"name":"paused","value":1}]})", "neither true"},
      {R"({"op":"setParameters","parameters":[{"name":"time_s","value":-1}]})", "below 0"},
      {R"({"op":"setParameters","parameters":[{"name":"colour","value":1}]})", "'colour'"},
      {R"({"op":"getParameters","parameterNames":[],"id":")" + std::string(257, 'x') + R"("})",
       "longer than 256"},
      {std::string(100'000, '['), "too deeply"}};
  for (const auto& [text, part] : texts) {
    CAPTURE(text.substr(0, 100));
    CHECK_THAT(refusal(request_of_text(text)), Catch::Contains(part));
  }
  const std::pair<std::string, const char*> frames[] = {
      {"", "kind is none"},
      {"\x01xxxx", "kind is 1"},
      {"\xff", "kind is 255"},
      {"\x03", "ends too early"},
      {"\x03\x01\x00\x00\x80\x3f\x01\x00\x94\x35\x77\x00\x00\x00\x00\xff\xff\xff\xffme"s,
       "ends too early"},
      {"\x03\x02\x00\x00\x80\x3f\x00"s + std::string(12, '\0'), "the command is 2"},
      {"\x03\x00\x00\x00\x00\x00\x00"s + std::string(12, '\0'), "no number above 0"},
      {"\x03\x00\x00\x00\xc0\x7f\x00"s + std::string(12, '\0'), "no number above 0"}};
  for (const auto& [bytes, part] : frames) {
    CAPTURE(bytes);
    CHECK_THAT(refusal(request_of_bytes(bytes)), Catch::Contains(part));
  }
}

TEST_CASE("What the server says has the layout of the protocol") {
  CHECK(message_head(258, 3) == "\x01\x02\x01\x00\x00\x03\x00\x00\x00\x00\x00\x00\x00"s);
  CHECK(time_frame(1) == "\x02\x01\x00\x00\x00\x00\x00\x00\x00"s);
  CHECK(playback_frame({Phase::ended, 5, 1.0}, true, "me") ==
        "\x05\x03\x05\x00\x00\x00\x00\x00\x00\x00\x00\x00\x80\x3f\x01\x02\x00\x00\x00me"s);
  const auto facts = Json::parse(server_info({"elsie", "7", 2'500'000'000}, Protocol::sdk));
  CHECK(facts.at("dataEndTime") == Json({{"sec", 2}, {"nsec", 500'000'000}}));
  CHECK_FALSE(
      Json::parse(server_info({"elsie", "7", 1}, Protocol::websocket)).contains("dataEndTime"));
}
