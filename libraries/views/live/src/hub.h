// What the run's thread and the server's thread share: channels, clients with what waits for them,
// and what they ask for. Neither thread waits for the other longer than it takes to move a message.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "elsie/live/live_run.h"

#include "outbox.h"
#include "protocol.h"

namespace elsie::live {

using ClientId = std::uint32_t;

/// What a client asks of the run.
struct Order {
  ClientId client = 0;
  Steer steer;
};

class Hub {
 public:
  explicit Hub(ServerFacts facts) : facts_(std::move(facts)) {}

  // The run's thread.

  std::uint32_t add_channel(const std::string& topic, const std::string& schema_name,
                            const std::string& schema);
  void remove_channel(std::uint32_t channel);
  /// Whether the channels that are wanted may have changed since the last call of wanted().
  bool has_other_wishes() const { return wishes_ != seen_wishes_; }
  /// For each channel, by its id, whether a client has subscribed to it.
  std::vector<bool> wanted();
  /// Whether there are subscriptions that have not got the present state yet.
  bool has_new() const { return has_new_; }
  /// They get it now, as all others do.
  void adopt_new();
  /// From now on only new subscriptions get messages; returns the channels that they want.
  std::vector<bool> begin_repeat();
  void end_repeat();

  void publish(std::uint32_t channel, std::uint64_t time_ns, std::string_view text);
  void say_time(std::uint64_t time_ns);
  /// Tells everyone how the run goes, and those whose orders were obeyed that this is the answer.
  void say(const Playback& playback, bool did_seek, const std::vector<Order>& answered);
  void say(Level level, const std::string& sentence);
  /// The run has ended then.
  void set_end(std::uint64_t end_ns);

  bool has_orders() const { return has_orders_; }
  std::vector<Order> take_orders();
  /// Waits for orders and new subscriptions, but not longer than this.
  void wait(std::chrono::duration<double> most);

  Counts counts() const;

  // The server's thread.

  /// How many clients have joined and not left.
  std::size_t present() const;
  /// `wake` is called, in any thread, when there is something to send again, or is_flooded().
  ClientId join(Protocol protocol, std::function<void()> wake);
  void leave(ClientId client);
  void hear(ClientId client, Request request);
  /// What the client is to be sent next; none: nothing now.
  std::optional<Frame> next(ClientId client);
  /// It does not read the answers that it asks for.
  bool is_flooded(ClientId client) const;

 private:
  struct Channel {
    std::string text;
    std::map<ClientId, std::uint32_t> subscriptions{};
  };
  enum class State { fresh, repeating, current };
  struct Subscription {
    std::uint32_t channel;
    State state = State::fresh;
  };
  struct Client {
    Protocol protocol;
    std::function<void()> wake;
    Outbox outbox{};
    std::map<std::uint32_t, Subscription> subscriptions{};  // by their ids
    bool watches_parameters = false;
    bool is_idle = true;  // its sender waits for a frame, and must be woken
  };

  void push(Client& client, Frame frame);
  void push_text(Client& client, std::string text);
  void push_binary(Client& client, std::string bytes);
  void subscribe(ClientId id, Client& client, const Subscribe& request);
  void unsubscribe(ClientId id, Client& client, const Unsubscribe& request);
  void say_rest(Client& client, std::size_t refused);
  void wish();  // what is wanted has changed

  mutable std::mutex mutex_;
  std::condition_variable news_;
  ServerFacts facts_;
  Playback playback_;
  std::map<std::uint32_t, Channel> channels_;
  std::uint32_t next_channel_ = 1;
  std::map<ClientId, Client> clients_;
  ClientId next_client_ = 1;
  std::vector<Order> orders_;
  Counts counts_;
  bool is_repeating_ = false;
  std::uint64_t seen_wishes_ = 0;
  std::atomic<std::uint64_t> wishes_ = 1;
  std::atomic<bool> has_new_ = false, has_orders_ = false;
};

}  // namespace elsie::live
