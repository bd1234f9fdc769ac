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

  /// Waits until a message or the end has come, for no longer than this; sends meanwhile what has
  /// not left yet.
  void wait(std::chrono::microseconds most);
  /// The next message; none if none is there.
  std::optional<Json> next();
  /// Whether the other end has closed the connection.
  bool closed() const { return closed_; }

  /// Sends a message, or keeps what does not fit: a window that is busy holds nothing up.
  void send(const Json& message);
  /// Whether the other end has read everything.
  bool is_idle();
  /// What has not left yet.
  std::size_t waiting_bytes() const { return unsent_.size(); }

 private:
  void flush();

  int descriptor_;
  bool closed_ = false;
  std::string received_;
  std::string unsent_;
};

}  // namespace elsie::server
