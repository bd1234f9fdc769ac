// Where the messages of a run go: into a file, or to those who watch it live.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace elsie::recording {

/// Takes messages in JSON, in channels that name their kind by a JSON schema.
class MessageSink {
 public:
  virtual ~MessageSink() = default;
  /// Both return an id. `name`: of the schema, such as "foxglove.SceneUpdate".
  virtual std::uint32_t add_schema(const std::string& name, const std::string& text) = 0;
  virtual std::uint32_t add_channel(const std::string& topic, std::uint32_t schema,
                                    const std::map<std::string, std::string>& metadata) = 0;
  /// The channel has no more messages.
  virtual void remove_channel(std::uint32_t) {}
  /// Whether anyone receives the messages of this channel now; otherwise none are made.
  virtual bool wants(std::uint32_t) const { return true; }
  /// `time_ns`: since the start of the run.
  virtual void write(std::uint32_t channel, std::uint64_t time_ns, std::string_view text) = 0;
};

}  // namespace elsie::recording
