// A connection to the process of a session, which holds the document and its run. Plugins that
// crash, loop or wait only affect that process.
//
// Messages are JSON objects, one per line; docs/internals/session.md lists them. Only the
// destructor waits for the other process.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "elsie/snapshots/snapshots.h"

namespace elsie::client {

using Json = nlohmann::ordered_json;

/// The end of the process.
struct SessionEnd {
  int exit_code = 0;   // or 128 and the number of the signal
  std::string report;  // the last text that it wrote to its standard output and error
};

class Connection {
 public:
  /// Starts `program`, which must be `elsie`, with these options for plugins. `most_bytes` is the
  /// largest size of a snapshot. Throws base::Error.
  Connection(const std::string& program, const std::vector<std::string>& arguments = {},
             std::size_t most_bytes = std::size_t{256} << 20);
  /// Ends the process by closing the connection; kills it if it is still running a moment later.
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Becomes readable when messages arrive, and when the process has ended.
  int descriptor() const;
  /// Sends a message, or keeps what does not fit for the next call of send() or receive().
  void send(const Json& message);
  /// The messages that have arrived since the last call.
  std::vector<Json> receive();
  /// The end of the process, once it has ended and all its messages have been received. Kills a
  /// process that still runs three seconds after it closed the connection.
  std::optional<SessionEnd> ended();
  /// Closes the connection, so that the process ends. No messages are received after that. ended()
  /// reports the end of the process, and kills it if it still runs one second later.
  void close();
  /// Makes the process report which plugin is active, and end.
  void quit();
  /// Ends the process at once.
  void kill();

  snapshots::Reader& snapshots();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::client
