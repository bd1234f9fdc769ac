// Messages to and from the other end of the session.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace elsie::server {

using Json = nlohmann::ordered_json;

class Link {
 public:
  explicit Link(int descriptor) : descriptor_(descriptor) {}

  /// Waits until a message or the end arrives, but not longer than this. Meanwhile, sends messages
  /// that are still waiting.
  void wait(std::chrono::microseconds most);
  /// The next message; none if none has arrived.
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
