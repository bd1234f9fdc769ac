#include "link.h"

#include <array>
#include <cerrno>
#include <string_view>

#include <linux/sockios.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "elsie/base/error.h"

namespace elsie::server {

namespace {

constexpr int kDeepest = 100;

/// Copying and printing values takes a call for each level, and a deep one has no meaning.
Json parsed(std::string_view line) {
  bool is_deep = false;
  const auto goes_on = [&](int depth, Json::parse_event_t event, const Json&) {
    is_deep |= depth >= kDeepest && (event == Json::parse_event_t::object_start ||
                                     event == Json::parse_event_t::array_start);
    return !is_deep;
  };
  Json message = Json::parse(line, goes_on, false);
  return is_deep ? Json(Json::value_t::discarded) : message;
}

}  // namespace

std::uint64_t whole_number(const Json& order, const char* member, std::uint64_t otherwise) {
  const auto found = order.find(member);
  if (found == order.end()) {
    return otherwise;
  }
  if (!found->is_number_unsigned()) {
    throw base::BadInput("`" + std::string(member) + "` is " +
                         found->dump(-1, ' ', false, Json::error_handler_t::replace) +
                         "; expected a whole number from 0 to 18446744073709551615");
  }
  return found->get<std::uint64_t>();
}

void Link::wait(std::chrono::microseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  flush();
  while (!closed_ && received_.find('\n') == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(
        end - std::chrono::steady_clock::now());
    if (left.count() <= 0) {
      return;
    }
    pollfd waiting{descriptor_, static_cast<short>(unsent_.empty() ? POLLIN : POLLIN | POLLOUT), 0};
    const timespec limit{left.count() / 1'000'000'000, left.count() % 1'000'000'000};
    ppoll(&waiting, 1, &limit, nullptr);
    if ((waiting.revents & POLLOUT) != 0) {
      flush();
    }
    if ((waiting.revents & ~POLLOUT) != 0) {
      return;
    }
  }
}

std::optional<Json> Link::next() {
  while (!closed_) {
    if (const std::size_t end = received_.find('\n'); end != std::string::npos) {
      Json message = parsed(std::string_view(received_).substr(0, end));
      received_.erase(0, end + 1);
      return message;
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
  flush();
  return std::nullopt;
}

void Link::send(const Json& message) {
  unsent_ += message.dump(-1, ' ', false, Json::error_handler_t::replace);
  unsent_ += '\n';
  flush();
}

bool Link::is_idle() {
  flush();
  int unread = 0;
  return unsent_.empty() && ioctl(descriptor_, SIOCOUTQ, &unread) == 0 && unread == 0;
}

void Link::flush() {
  std::size_t sent = 0;
  while (sent < unsent_.size() && !closed_) {
    const ssize_t count = ::send(descriptor_, unsent_.data() + sent, unsent_.size() - sent,
                                 MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      break;
    } else if (errno != EINTR) {
      closed_ = true;
    }
  }
  unsent_.erase(0, sent);
}

}  // namespace elsie::server
