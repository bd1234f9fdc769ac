// A document and its run, in a process of its own, for a window at the other end.
//
// The server reads messages, edits the document, and runs the world that it describes; between two
// decisions of the robots it looks for messages again. It tells where everything is by snapshots,
// and everything else by messages; docs/session.md lists them. A run in a session is the run of
// `elsie run` with the same world, seed and edits, bit for bit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"

namespace elsie::server {

// The descriptors that the process has got from elsie::client.
inline constexpr int kMessages =
    150;                             // a socket; plugins that close "their" descriptors begin at 3
inline constexpr int kMemory = 151;  // snapshots::SharedMemory

class Server {
 public:
  /// The host must outlive the server. Throws base::Error when the descriptors are not there.
  Server(const plugin::Host& host, std::vector<std::string> data_directories);
  ~Server();

  /// Until the other end closes the connection. Throws what ends a process: base::Error.
  void serve();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::server
