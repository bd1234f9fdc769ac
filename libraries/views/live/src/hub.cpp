#include "hub.h"

#include <utility>

namespace elsie::live {
namespace {

constexpr std::size_t kMostOrders = 1000;                       // that wait for the run
constexpr std::size_t kMostRefusals = 10;                       // sentences about one request
constexpr std::uint64_t kTimeStream = std::uint64_t{1} << 32U;  // no subscription has this id

template <class... Each>
struct Overloaded : Each... {
  using Each::operator()...;
};
template <class... Each>
Overloaded(Each...) -> Overloaded<Each...>;

}  // namespace

std::uint32_t Hub::add_channel(const std::string& topic, const std::string& schema_name,
                               const std::string& schema) {
  const std::uint32_t id = next_channel_++;  // only this thread counts them
  std::string text = channel_text(id, topic, schema_name, schema);
  const std::lock_guard lock(mutex_);
  for (auto& [client_id, client] : clients_) push_text(client, advertisement({text}));
  channels_.emplace(id, Channel{std::move(text)});
  return id;
}

void Hub::remove_channel(std::uint32_t channel) {
  const std::lock_guard lock(mutex_);
  const auto found = channels_.find(channel);
  if (found == channels_.end()) return;
  for (const auto& [client, subscription] : found->second.subscriptions) {
    clients_.at(client).subscriptions.erase(subscription);
    clients_.at(client).outbox.forget(subscription);
  }
  channels_.erase(found);
  for (auto& [id, client] : clients_) push_text(client, unadvertisement({channel}));
  wish();
}

std::vector<bool> Hub::wanted() {
  const std::lock_guard lock(mutex_);
  seen_wishes_ = wishes_;
  std::vector<bool> wanted(next_channel_);
  for (const auto& [id, channel] : channels_) wanted[id] = !channel.subscriptions.empty();
  return wanted;
}

void Hub::adopt_new() {
  const std::lock_guard lock(mutex_);
  has_new_ = false;
  for (auto& [id, client] : clients_) {
    for (auto& [subscription, facts] : client.subscriptions) facts.state = State::current;
  }
}

std::vector<bool> Hub::begin_repeat() {
  const std::lock_guard lock(mutex_);
  std::vector<bool> wanted(next_channel_);
  for (auto& [id, client] : clients_) {
    for (auto& [subscription, facts] : client.subscriptions) {
      if (facts.state != State::fresh) continue;
      facts.state = State::repeating;
      wanted[facts.channel] = true;
    }
  }
  has_new_ = false;
  is_repeating_ = true;
  return wanted;
}

void Hub::end_repeat() {
  const std::lock_guard lock(mutex_);
  is_repeating_ = false;
  for (auto& [id, client] : clients_) {
    for (auto& [subscription, facts] : client.subscriptions) {
      if (facts.state == State::repeating) facts.state = State::current;
    }
  }
}

void Hub::publish(std::uint32_t channel, std::uint64_t time_ns, std::string_view text) {
  const auto body = std::make_shared<const std::string>(text);
  const std::lock_guard lock(mutex_);
  const auto found = channels_.find(channel);
  if (found == channels_.end()) return;
  for (const auto& [id, subscription] : found->second.subscriptions) {
    Client& client = clients_.at(id);
    const State state = client.subscriptions.at(subscription).state;
    if (is_repeating_ ? state != State::repeating : state == State::fresh) continue;
    ++counts_.messages;
    push(client, {false, message_head(subscription, time_ns), body, subscription});
  }
}

void Hub::say_time(std::uint64_t time_ns) {
  const std::lock_guard lock(mutex_);
  playback_.time_ns = time_ns;
  for (auto& [id, client] : clients_) {
    push(client, {false, time_frame(time_ns), nullptr, kTimeStream});
  }
}

void Hub::say(const Playback& playback, bool did_seek, const std::vector<Order>& answered) {
  const std::lock_guard lock(mutex_);
  const bool is_news = did_seek || !(playback == playback_);
  playback_ = playback;
  for (auto& [id, client] : clients_) {
    bool is_answered = false;
    for (const Order& order : answered) {
      if (order.client != id) continue;
      if (order.steer.is_by_parameter) {
        if (order.steer.id.empty() && client.watches_parameters) continue;  // it gets them below
        push_text(client, parameter_values(playback, {}, order.steer.id));
      } else if (client.protocol == Protocol::sdk) {
        push_binary(client, playback_frame(playback, did_seek, order.steer.id));
        is_answered = true;
      }
    }
    if (client.protocol == Protocol::sdk && is_news && !is_answered) {
      push_binary(client, playback_frame(playback, did_seek, ""));
    }
    if (client.watches_parameters) push_text(client, parameter_values(playback, {}, ""));
  }
}

void Hub::say(Level level, const std::string& sentence) {
  const std::lock_guard lock(mutex_);
  for (auto& [id, client] : clients_) push_text(client, status(level, sentence));
}

void Hub::set_end(std::uint64_t end_ns) {
  const std::lock_guard lock(mutex_);
  if (facts_.end_ns == end_ns) return;
  facts_.end_ns = end_ns;
  for (auto& [id, client] : clients_) push_text(client, server_info(facts_, client.protocol));
}

std::vector<Order> Hub::take_orders() {
  if (!has_orders_) return {};
  const std::lock_guard lock(mutex_);
  has_orders_ = false;
  return std::exchange(orders_, {});
}

void Hub::wait(std::chrono::duration<double> most) {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, most, [&] { return has_orders_ || has_new_; });
}

Counts Hub::counts() const {
  const std::lock_guard lock(mutex_);
  Counts counts = counts_;
  for (const auto& [id, client] : clients_) counts.dropped += client.outbox.dropped();
  return counts;
}

std::size_t Hub::present() const {
  const std::lock_guard lock(mutex_);
  return clients_.size();
}

ClientId Hub::join(Protocol protocol, std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  const ClientId id = next_client_++;
  Client& client = clients_.emplace(id, Client{protocol, std::move(wake)}).first->second;
  ++counts_.clients;
  push_text(client, server_info(facts_, protocol));
  std::vector<std::string_view> texts;
  for (const auto& [channel, facts] : channels_) texts.push_back(facts.text);
  if (!texts.empty()) push_text(client, advertisement(texts));
  push(client, {false, time_frame(playback_.time_ns), nullptr, kTimeStream});
  if (protocol == Protocol::sdk) push_binary(client, playback_frame(playback_, false, ""));
  return id;
}

void Hub::leave(ClientId id) {
  const std::lock_guard lock(mutex_);
  const auto client = clients_.find(id);
  if (client == clients_.end()) return;
  for (const auto& [subscription, facts] : client->second.subscriptions) {
    channels_.at(facts.channel).subscriptions.erase(id);
  }
  counts_.dropped += client->second.outbox.dropped();
  clients_.erase(client);
  wish();
}

void Hub::hear(ClientId id, Request request) {
  const std::lock_guard lock(mutex_);
  Client& client = clients_.at(id);
  std::visit(Overloaded{[&](const Subscribe& subscribe) { this->subscribe(id, client, subscribe); },
                        [&](const Unsubscribe& unsubscribe) {
                          this->unsubscribe(id, client, unsubscribe);
                        },
                        [&](const GetParameters& get) {
                          push_text(client, parameter_values(playback_, get.names, get.id));
                        },
                        [&](const WatchParameters& watch) { client.watches_parameters = watch.on; },
                        [&](Steer& steer) {
                          if (orders_.size() >= kMostOrders) {
                            push_text(client, status(Level::error, "too many requests at once"));
                            return;
                          }
                          orders_.push_back({id, std::move(steer)});
                          has_orders_ = true;
                          news_.notify_all();
                        },
                        [&](const Refused& refused) {
                          push_text(client, status(Level::error, refused.sentence));
                        }},
             request);
}

std::optional<Frame> Hub::next(ClientId id) {
  const std::lock_guard lock(mutex_);
  const auto client = clients_.find(id);
  if (client == clients_.end() || client->second.outbox.is_flooded()) return std::nullopt;
  std::optional<Frame> frame = client->second.outbox.pop();
  client->second.is_idle = !frame;
  return frame;
}

bool Hub::is_flooded(ClientId id) const {
  const std::lock_guard lock(mutex_);
  const auto client = clients_.find(id);
  return client != clients_.end() && client->second.outbox.is_flooded();
}

void Hub::push(Client& client, Frame frame) {
  client.outbox.push(std::move(frame));
  const bool was_idle = std::exchange(client.is_idle, false);
  if (was_idle || client.outbox.is_flooded()) client.wake();
}

void Hub::push_text(Client& client, std::string text) {
  push(client, {.is_text = true, .head = std::move(text)});
}

void Hub::push_binary(Client& client, std::string bytes) {
  push(client, {.is_text = false, .head = std::move(bytes)});
}

void Hub::subscribe(ClientId id, Client& client, const Subscribe& request) {
  std::size_t refused = 0;
  const auto refuse = [&](Level level, std::uint32_t subscription, const std::string& why) {
    if (++refused > kMostRefusals) return;
    push_text(client, status(level, "the subscription " + std::to_string(subscription) + why));
  };
  for (const auto& [subscription, channel] : request.channels) {
    const auto found = channels_.find(channel);
    if (found == channels_.end()) {
      refuse(Level::warning, subscription,
             " is to the channel " + std::to_string(channel) + ", which does not exist (any more)");
    } else if (client.subscriptions.contains(subscription)) {
      refuse(Level::error, subscription, " exists already");
    } else if (found->second.subscriptions.contains(id)) {
      refuse(Level::error, subscription,
             " is to the channel " + std::to_string(channel) + ", to which there is one already");
    } else {
      found->second.subscriptions.emplace(id, subscription);
      client.subscriptions.emplace(subscription, Subscription{channel});
      has_new_ = true;
    }
  }
  say_rest(client, refused);
  wish();
  news_.notify_all();
}

void Hub::unsubscribe(ClientId id, Client& client, const Unsubscribe& request) {
  std::size_t refused = 0;
  for (const std::uint32_t subscription : request.subscriptions) {
    const auto found = client.subscriptions.find(subscription);
    if (found == client.subscriptions.end()) {
      if (++refused > kMostRefusals) continue;
      push_text(client,
                status(Level::warning, "there is no subscription " + std::to_string(subscription)));
      continue;
    }
    channels_.at(found->second.channel).subscriptions.erase(id);
    client.subscriptions.erase(found);
    client.outbox.forget(subscription);
  }
  say_rest(client, refused);
  wish();
}

/// A request may name half a million subscriptions, and the run waits while it is answered.
void Hub::say_rest(Client& client, std::size_t refused) {
  if (refused <= kMostRefusals) return;
  push_text(client,
            status(Level::warning, std::to_string(refused - kMostRefusals) +
                                       " more subscriptions of this request are refused likewise"));
}

void Hub::wish() { ++wishes_; }

}  // namespace elsie::live
