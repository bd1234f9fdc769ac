// Holds a document and its run in a process of its own, for a window in another process.
//
// The server reads messages, edits the document, and runs the world that it describes. Between two
// decisions of the robots it reads messages again. It sends positions as snapshots and all other
// data as messages; docs/internals/session.md lists them. A run in a session equals, bit for bit,
// that of `elsie run` with the same world, seed and edits, whatever is watched.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace elsie::build {
class Watch;
}

namespace elsie::server {

// The descriptors that the process inherits from elsie::client.
inline constexpr int kMessages =
    150;                             // a socket; plugins that close "their" descriptors begin at 3
inline constexpr int kMemory = 151;  // snapshots::SharedMemory

struct ServerOptions {
  std::vector<std::string> data_directories;
  /// The options with which `elsie run` loads the same plugins.
  std::vector<std::string> plugin_options;
};

class Server {
 public:
  /// `plugins` must outlive the server, which loads plugins that change on disk. Throws base::Error
  /// when the descriptors do not exist.
  Server(build::Watch& plugins, ServerOptions options);
  ~Server();

  /// Serves until the other end closes the connection; a plugin that does not return then is named,
  /// and the process ends after three seconds. Throws base::Error for fatal errors.
  void serve();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::server
