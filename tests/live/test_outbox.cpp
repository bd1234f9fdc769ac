// What waits for a client that reads too slowly.
#include <catch2/catch.hpp>

#include "hub.h"
#include "outbox.h"

namespace live = elsie::live;
using elsie::live::Outbox;

namespace {

live::Frame message(std::uint64_t stream, const std::string& head, std::size_t bytes) {
  return {false, head, std::make_shared<const std::string>(bytes, 'x'), stream};
}

std::vector<std::string> all_of(Outbox& outbox) {
  std::vector<std::string> heads;
  while (const auto frame = outbox.pop()) heads.push_back(frame->head);
  return heads;
}

constexpr std::size_t kThird = Outbox::kMostBytes / 3 - 100;  // with its head

}  // namespace

TEST_CASE("What fits is sent in its order") {
  Outbox outbox;
  outbox.push({true, "facts"});
  outbox.push(message(1, "a1", 10));
  outbox.push(message(2, "b1", 10));
  outbox.push(message(1, "a2", 10));
  CHECK(all_of(outbox) == std::vector<std::string>{"facts", "a1", "b1", "a2"});
  CHECK(outbox.dropped() == 0);
  CHECK(outbox.empty());
}

TEST_CASE("Where there is no room, the oldest of a stream make room, and the newest of each stay") {
  Outbox outbox;
  outbox.push(message(7, "scene", 100));
  outbox.push({true, "answer"});
  for (const char* head : {"a1", "a2", "a3", "a4", "a5"}) outbox.push(message(1, head, kThird));
  CHECK(outbox.dropped() == 2);
  CHECK(all_of(outbox) == std::vector<std::string>{"scene", "answer", "a3", "a4", "a5"});
}

TEST_CASE("A message that is larger than the room for all is sent") {
  Outbox outbox;
  outbox.push(message(1, "large", 2 * Outbox::kMostBytes));
  outbox.push(message(1, "larger", 3 * Outbox::kMostBytes));
  CHECK(all_of(outbox) == std::vector<std::string>{"larger"});
}

TEST_CASE("A stream that has ended has no more messages, and no part in the room") {
  Outbox outbox;
  outbox.push(message(1, "a1", kThird));
  outbox.push(message(2, "b1", kThird));
  outbox.forget(1);
  outbox.push(message(2, "b2", kThird));
  outbox.push(message(2, "b3", kThird));
  CHECK(all_of(outbox) == std::vector<std::string>{"b1", "b2", "b3"});
}

TEST_CASE("Answers that nobody reads end somewhere") {
  Outbox outbox;
  const std::string answer(1U << 20U, 'x');
  for (int i = 0; i < 70; ++i) outbox.push({true, answer});
  CHECK(outbox.is_flooded());
}

TEST_CASE("Who reads nothing is sent away when that is full, also while a frame is on its way") {
  live::Hub hub({});
  int calls = 0;
  const live::ClientId deaf = hub.join(live::Protocol::websocket, [&] { ++calls; });
  REQUIRE(hub.next(deaf));  // which never arrives
  calls = 0;
  const std::string long_id(250, 'x');
  while (!hub.is_flooded(deaf)) hub.hear(deaf, live::GetParameters{{}, long_id});
  CHECK(calls == 1);
  CHECK_FALSE(hub.next(deaf));
}
