// Messages to and from the other end of the session.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace elsie::server {

using Json = nlohmann::ordered_json;

/// A member of an order that is a whole number from 0 to 2^64 - 1; `otherwise` without it. Throws
/// base::BadInput for any other value.
std::uint64_t whole_number(const Json& order, const char* member, std::uint64_t otherwise);

class Link {
 public:
  explicit Link(int descriptor) : descriptor_(descriptor) {}

  /// Waits until a message or the end arrives, but not longer than this. Meanwhile, sends messages
  /// that are still waiting.
  void wait(std::chrono::microseconds most);
  /// The next message; none if none has arrived. A line that is no JSON, or is nested more deeply
  /// than any order, is a discarded value.
  std::optional<Json> next();
  /// Whether the other end has closed the connection.
  bool closed() const { return closed_; }

  /// Sends a message, or keeps the part that does not fit, so that a busy window blocks nothing.
  void send(const Json& message);
  /// Whether the other end has read everything.
  bool is_idle();
  /// The number of bytes that have not been sent yet.
  std::size_t waiting_bytes() const { return unsent_.size(); }

 private:
  void flush();

  int descriptor_;
  bool closed_ = false;
  std::string received_;
  std::string unsent_;
};

}  // namespace elsie::server
