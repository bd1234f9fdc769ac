// Reading a file that mcap_recorder() wrote, message by message.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "elsie/api/simulator_events.h"
#include "elsie/mcap/records.h"
#include "elsie/recording/recorded_run.h"

#include "format.h"

namespace elsie::recording {

constexpr double kSecondNs = 1e9;

/// A channel or message that the recorder does not write; what() says what is wrong with it.
class Unexpected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Robot and kind of a channel "/robots/ROBOT/KIND"; both empty for others.
std::pair<std::string, std::string> robot_and_kind(const mcap::Channel& channel);

/// The edit of an event `changed`; none for other events.
std::optional<events::Changed> edit_of(const Json& event);

/// Takes what it needs from a file. Json::exception and Unexpected become errors of the file.
class Visitor {
 public:
  virtual void channel(const mcap::Channel&) {}  // before its messages
  virtual void message(const mcap::Channel& channel, const mcap::Message& message) = 0;

 protected:
  ~Visitor() = default;
};

/// Reads a file to its end. Fills in the members of RecordedRun about the whole file, and passes
/// the rest to the visitor if Elsie recorded it. Throws mcap::McapError for a file that cannot be
/// read or is damaged.
void read_file(const std::filesystem::path& file, RecordedRun& run, Visitor& visitor);

}  // namespace elsie::recording
