// What waits to be sent to one client.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace elsie::live {

struct Frame {
  bool is_text = false;
  std::string head;                           // the whole text, or what comes before the body
  std::shared_ptr<const std::string> body{};  // that several clients share
  std::optional<std::uint64_t> stream{};      // what it is the news of; none: it must not get lost

  std::size_t size() const { return head.size() + (body ? body->size() : 0); }
};

/// A queue that stays small: if a client reads too slowly, the oldest messages of a stream make
/// room for newer ones. The newest message of each is kept, so that a scene that is sent once
/// arrives, too. A subscription is a stream.
class Outbox {
 public:
  static constexpr std::size_t kMostBytes = 4U << 20U;     // of messages; one of each may exceed it
  static constexpr std::size_t kMostAnswers = 64U << 20U;  // bytes of what must not get lost

  void push(Frame frame);
  /// The next frame to send; none: all are.
  std::optional<Frame> pop();
  /// Forgets the messages of a stream that has ended.
  void forget(std::uint64_t stream);

  bool empty() const { return frames_.empty(); }
  /// A client that asks without reading the answers; it gets no more.
  bool is_flooded() const { return answer_bytes_ > kMostAnswers; }
  /// Messages that had to make room.
  std::uint64_t dropped() const { return dropped_; }

 private:
  void remove(const std::deque<Frame>::iterator& at);

  std::deque<Frame> frames_;
  std::map<std::uint64_t, std::size_t> waiting_;  // messages, by stream
  std::size_t message_bytes_ = 0, answer_bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace elsie::live
