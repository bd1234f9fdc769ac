// The other end of a session: a process of its own that has the document and its run, so that
// plugins which crash, loop or wait do so there.
//
// Messages are objects of JSON, one a line; docs/session.md lists them. Nothing here waits for the
// other process, but for the destructor.
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

/// How the process ended.
struct SessionEnd {
  int exit_code = 0;   // or 128 and the number of the signal
  std::string report;  // what it wrote last on its standard output and error
};

class Connection {
 public:
  /// Starts `program`, which is `elsie`, with these options: those of plugins. `most_bytes`: of a
  /// snapshot. Throws base::Error.
  Connection(const std::string& program, const std::vector<std::string>& arguments = {},
             std::size_t most_bytes = std::size_t{256} << 20);
  /// Ends the process: by closing the connection, and by force when it is still there a moment
  /// later.
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Can be read when messages wait, or the process has ended.
  int descriptor() const;
  /// Sends a message, or keeps what does not fit for the next call of send() or receive().
  void send(const Json& message);
  /// The messages that have come.
  std::vector<Json> receive();
  /// Once it has ended, and all its messages have been received. A process that has closed the
  /// connection but lives on for a second is ended.
  std::optional<SessionEnd> ended();
  /// Closes the connection, at which the process ends by itself. Nothing is received after that;
  /// ended() says when it has ended, and ends one that is still there a second later.
  void close();
  /// Tells the process to report which plugin is at work, and to end.
  void quit();
  /// Ends the process at once.
  void kill();

  snapshots::Reader& snapshots();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::client
