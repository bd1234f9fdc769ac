// The server: connections, handshakes, frames. All of Boost.Beast is behind it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/live/address.h"

namespace elsie::live {

class Hub;

class Server {
 public:
  /// Listens; clients that come wait for start(). Throws base::BadInput when that is not possible.
  explicit Server(const Address& address);
  /// Says good-bye to the clients.
  ~Server();

  /// With the port that is used.
  const Address& address() const;
  /// Serves the clients of this hub, in a thread of its own. `origins`: see gate.h.
  void start(Hub& hub, std::vector<std::string> origins);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::live
