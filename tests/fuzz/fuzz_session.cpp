// The orders of a session: every line has one answer, and none ends the session.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <thread>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/socket.h>
#include <unistd.h>

#include "elsie/build/watch.h"
#include "elsie/server/server.h"
#include "elsie/simulation/fault.h"
#include "elsie/snapshots/snapshots.h"

#include "fuzz.h"

namespace {

/// Orders that write files where the input says; what they answer is tested elsewhere.
bool writes_files(const std::string& orders) {
  return orders.find("record") != std::string::npos || orders.find("\\u") != std::string::npos;
}

/// The window: sends the orders, and hangs up when each line has its answer. Returns how many there
/// were.
std::ptrdiff_t answers_to(const std::string& orders, int socket) {
  const std::ptrdiff_t lines = std::count(orders.begin(), orders.end(), '\n');
  std::thread sender([&] {
    for (std::size_t sent = 0; sent < orders.size();) {
      const ssize_t count = send(socket, orders.data() + sent, orders.size() - sent, MSG_NOSIGNAL);
      if (count < 0) {
        break;
      }
      sent += static_cast<std::size_t>(count);
    }
  });
  std::ptrdiff_t answers = 0;
  std::string received;
  char some[65'536];
  for (ssize_t count; answers < lines && (count = read(socket, some, sizeof(some))) > 0;) {
    received.append(some, static_cast<std::size_t>(count));
    std::size_t begin = 0;
    for (std::size_t end; (end = received.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      const auto message = nlohmann::json::parse(received.substr(begin, end - begin));
      answers += message.contains("answer") ? 1 : 0;
    }
    received.erase(0, begin);
  }
  shutdown(socket, SHUT_RDWR);
  sender.join();
  return answers;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static elsie::build::Watch plugins({{elsie::fuzz::plugin_folder(), "the build tree"}});
  static const auto memory = elsie::snapshots::SharedMemory::create(1 << 20);
  std::string orders(elsie::fuzz::text_of(data, size));
  if (writes_files(orders)) {
    return 0;
  }
  orders += '\n';
  const std::ptrdiff_t lines = std::count(orders.begin(), orders.end(), '\n');
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 ||
      dup2(ends[1], elsie::server::kMessages) < 0 ||
      dup2(memory.descriptor(), elsie::server::kMemory) < 0) {
    std::abort();
  }
  close(ends[1]);
  std::ptrdiff_t answers = 0;
  std::thread window([&] { answers = answers_to(orders, ends[0]); });
  bool has_failed = false;
  try {
    elsie::server::Server server(plugins, {{elsie::fuzz::source_folder()}, {}});
    server.serve();
  } catch (const elsie::simulation::PluginFault&) {  // a plugin of the world, not the session
    has_failed = true;
  }
  shutdown(elsie::server::kMessages, SHUT_RDWR);
  window.join();
  close(ends[0]);
  close(elsie::server::kMessages);
  if (answers != lines && !has_failed) {
    std::abort();
  }
  return 0;
}
