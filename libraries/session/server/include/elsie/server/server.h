// A document and its run, in a process of its own, for a window at the other end.
//
// The server reads messages, edits the document, and runs the world that it describes; between two
// decisions of the robots it looks for messages again. It says where everything is by snapshots,
// and everything else by messages; docs/session.md lists them. A run in a session is the run of
// `elsie run` with the same world, seed and edits, bit for bit, whatever is watched.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace elsie::build {
class Watch;
}

namespace elsie::server {

// The descriptors that the process has got from elsie::client.
inline constexpr int kMessages =
    150;                             // a socket; plugins that close "their" descriptors begin at 3
inline constexpr int kMemory = 151;  // snapshots::SharedMemory

struct ServerOptions {
  std::vector<std::string> data_directories;
  /// The options of `elsie run` with which it has the same plugins.
  std::vector<std::string> plugin_options;
};

class Server {
 public:
  /// `plugins` must outlive the server, which takes those that change on disk. Throws base::Error
  /// when the descriptors are not there.
  Server(build::Watch& plugins, ServerOptions options);
  ~Server();

  /// Until the other end closes the connection. Throws what ends a process: base::Error.
  void serve();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::server
