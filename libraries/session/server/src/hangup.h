// Ends a process whose window is gone while a plugin does not return.
#pragma once

#include <thread>

namespace elsie::server {

class Hangup {
 public:
  /// Watches a socket in a thread of its own. Once the other end is closed, the process has three
  /// seconds to end by itself; then it is ended like a crash: the plugin is named.
  explicit Hangup(int socket);
  Hangup(const Hangup&) = delete;
  Hangup& operator=(const Hangup&) = delete;
  ~Hangup();

 private:
  int over_;  // readable when the watch is over
  std::thread thread_;
};

}  // namespace elsie::server
