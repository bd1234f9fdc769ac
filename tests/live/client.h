// A client of the live socket that sends and looks at single frames.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace elsie::test {

/// The headers of a handshake; empty ones are left out.
struct Knock {
  std::string protocols = "foxglove.sdk.v1";
  std::string host = "127.0.0.1";
  std::string origin{};
  bool upgrades = true;  // otherwise a plain request, as of a page that is opened
};

/// What the server answered.
struct Answer {
  int status = 0;  // 101: it is a web socket from now on
  std::string body;
  std::string protocol;
};
Answer knock(std::uint16_t port, const Knock& knock);

/// A connection on which nothing is said, as long as this is kept.
std::shared_ptr<void> keep_silent(std::uint16_t port);

struct Message {
  std::uint32_t subscription = 0;
  std::uint64_t time_ns = 0;
  std::string text;

  nlohmann::json json() const { return nlohmann::json::parse(text); }
};

/// `foxglove.sdk.v1`, frame 5.
struct PlaybackState {
  int status = -1;  // 0 plays, 1 is paused, 2 goes to a time, 3 has ended
  std::uint64_t time_ns = 0;
  float speed = 0.0F;
  bool did_seek = false;
  std::string request;
};

/// Every read throws std::runtime_error when nothing has come for a long time, or the connection is
/// over.
class Client {
 public:
  explicit Client(std::uint16_t port, const Knock& knock = {});
  ~Client();

  struct Frame {
    bool is_text = false;
    std::string bytes;
  };
  Frame read();
  /// Reads on until such a frame comes.
  nlohmann::json text(const std::string& op);
  Message message(std::uint32_t subscription);
  /// The answer to a request.
  PlaybackState state(const std::string& request);
  /// The first state for which `is_wanted`.
  template <class IsWanted>
  PlaybackState state_that(const IsWanted& is_wanted) {
    for (;;) {
      const auto state = state_of(read());
      if (state && is_wanted(*state)) return *state;
    }
  }
  static std::optional<Message> message_of(const Frame& frame);
  static std::optional<PlaybackState> state_of(const Frame& frame);

  void send(const nlohmann::json& json) { send_text(json.dump()); }
  void send_text(const std::string& text);
  void send_bytes(const std::string& bytes);
  /// Asks to play or pause, with a seek if there is a time.
  void steer(bool plays, float speed, std::optional<double> seek_s, const std::string& request);
  void subscribe(std::uint32_t subscription, std::uint32_t channel);

  /// Reads to the end; returns the code with which the server closed the connection, 0 for none.
  int close_code();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::test
