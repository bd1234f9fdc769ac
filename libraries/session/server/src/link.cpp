#include "link.h"

#include <array>
#include <cerrno>

#include <poll.h>
#include <sys/socket.h>

namespace elsie::server {

bool Link::poll(int timeout_ms) {
  pollfd waiting{descriptor_, POLLIN, 0};
  return received_.find('\n') != std::string::npos || ::poll(&waiting, 1, timeout_ms) > 0;
}

void Link::wait() { poll(-1); }

void Link::wait(std::chrono::microseconds most) {
  if (received_.find('\n') != std::string::npos) {
    return;
  }
  pollfd waiting{descriptor_, POLLIN, 0};
  const timespec limit{most.count() / 1'000'000, most.count() % 1'000'000 * 1000};
  ppoll(&waiting, 1, &limit, nullptr);
}

std::optional<Json> Link::next() {
  while (!closed_) {
    if (const std::size_t end = received_.find('\n'); end != std::string::npos) {
      Json message = Json::parse(
          received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
      received_.erase(0, end + 1);
      if (message.is_object()) {
        return message;
      }
      continue;
    }
    std::array<char, 65'536> some;
    const ssize_t count = recv(descriptor_, some.data(), some.size(), MSG_DONTWAIT);
    if (count > 0) {
      received_.append(some.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
      closed_ = true;
    } else if (errno == EAGAIN) {
      break;
    }
  }
  return std::nullopt;
}

void Link::send(const Json& message) {
  const std::string text = message.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  for (std::size_t sent = 0; sent < text.size() && !closed_;) {
    const ssize_t count = ::send(descriptor_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      closed_ = true;
    }
  }
}

}  // namespace elsie::server
