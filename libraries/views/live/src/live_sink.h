// The messages of a run, on their way to the clients that have subscribed to them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "elsie/recording/message_sink.h"

#include "hub.h"

namespace elsie::live {

class LiveSink final : public recording::MessageSink {
 public:
  explicit LiveSink(Hub& hub) : hub_(hub) {}

  /// Takes note of new wishes of the clients. Between two calls, wants() stays the same.
  void look() {
    if (!is_mute_ && hub_.has_other_wishes()) wanted_ = hub_.wanted();
  }
  /// Nothing is wanted until it is called again.
  void mute(bool is_mute) {
    is_mute_ = is_mute;
    wanted_ = is_mute ? std::vector<bool>() : hub_.wanted();
  }
  /// What follows is the whole state, for new subscriptions, too.
  void begin_anew() {
    if (is_mute_) return;
    hub_.adopt_new();
    wanted_ = hub_.wanted();
  }
  /// Has the present state said to those that have not heard it.
  template <class Repeat>
  void repeat(const Repeat& repeat) {
    wanted_ = hub_.begin_repeat();
    repeat();
    hub_.end_repeat();
    wanted_ = hub_.wanted();
  }

  std::uint32_t add_schema(const std::string& name, const std::string& text) override {
    schemas_.emplace_back(name, text);
    return static_cast<std::uint32_t>(schemas_.size());
  }
  std::uint32_t add_channel(const std::string& topic, std::uint32_t schema,
                            const std::map<std::string, std::string>&) override {
    const auto& [name, text] = schemas_.at(schema - 1);
    return hub_.add_channel(topic, name, text);
  }
  void remove_channel(std::uint32_t channel) override { hub_.remove_channel(channel); }
  bool wants(std::uint32_t channel) const override {
    return channel < wanted_.size() && wanted_[channel];
  }
  void write(std::uint32_t channel, std::uint64_t time_ns, std::string_view text) override {
    hub_.publish(channel, time_ns, text);
  }

 private:
  Hub& hub_;
  std::vector<std::pair<std::string, std::string>> schemas_;  // name and text, by id - 1
  std::vector<bool> wanted_;                                  // by channel
  bool is_mute_ = false;
};

}  // namespace elsie::live
