#include "hangup.h"

#include <csignal>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/process/process_end.h"

namespace elsie::server {
namespace {

constexpr int kPatience_ms = 3000;

void watch(int socket, int over) {
  pollfd both[] = {{over, POLLIN, 0}, {socket, POLLRDHUP, 0}};
  while (poll(both, 2, -1) < 0) {
  }
  if (both[0].revents == 0 && poll(both, 1, kPatience_ms) == 0) {
    kill(getpid(), SIGQUIT);  // the thread that serves names the plugin, unless it ignores this
    poll(both, 1, kPatience_ms);
    process::end_with(base::kPluginFailed);
  }
}

}  // namespace

Hangup::Hangup(int socket) : over_(eventfd(0, EFD_CLOEXEC)) {
  sigset_t all, before;  // signals are for the thread that serves
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread(watch, socket, over_);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Hangup::~Hangup() {
  eventfd_write(over_, 1);
  thread_.join();
  close(over_);
}

}  // namespace elsie::server
