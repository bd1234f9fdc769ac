// Messages to and from the other end of the session.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace elsie::server {

using Json = nlohmann::ordered_json;

class Link {
 public:
  explicit Link(int descriptor) : descriptor_(descriptor) {}

  /// Waits until a message or the end has come.
  void wait();
  /// The same, for no longer than this.
  void wait(std::chrono::microseconds most);
  /// The next message; none if none is there.
  std::optional<Json> next();
  /// Whether the other end has closed the connection.
  bool closed() const { return closed_; }

  void send(const Json& message);

 private:
  bool poll(int timeout_ms);

  int descriptor_;
  bool closed_ = false;
  std::string received_;
};

}  // namespace elsie::server
