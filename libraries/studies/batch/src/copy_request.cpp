#include "copy_request.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include <sys/socket.h>

namespace elsie::batch {
namespace {

constexpr std::size_t kMost = 3;  // descriptors of a request

/// A message with one request and room for descriptors.
struct Message {
  explicit Message(CopyRequest& request) : part{&request, sizeof(request)} {
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;

  iovec part;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kMost * sizeof(int))> control{};
  msghdr header{};
};

}  // namespace

bool send_request(int to, const CopyRequest& request, const std::vector<int>& descriptors) {
  CopyRequest sent = request;
  Message message(sent);
  const std::size_t size = descriptors.size() * sizeof(int);
  message.header.msg_controllen = size > 0 ? CMSG_SPACE(size) : 0;
  if (cmsghdr* const attached = CMSG_FIRSTHDR(&message.header)) {
    attached->cmsg_level = SOL_SOCKET;
    attached->cmsg_type = SCM_RIGHTS;
    attached->cmsg_len = CMSG_LEN(size);
    std::memcpy(CMSG_DATA(attached), descriptors.data(), size);
  }
  return sendmsg(to, &message.header, MSG_NOSIGNAL | MSG_DONTWAIT) == sizeof(sent);
}

std::optional<ReceivedRequest> next_request(int from) {
  ReceivedRequest received;
  Message message(received.request);
  ssize_t size = 0;
  do {
    size = recvmsg(from, &message.header, MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  if (size != sizeof(CopyRequest)) {
    return std::nullopt;
  }
  if (const cmsghdr* const attached = CMSG_FIRSTHDR(&message.header)) {
    received.descriptors.resize((attached->cmsg_len - CMSG_LEN(0)) / sizeof(int));
    std::memcpy(received.descriptors.data(), CMSG_DATA(attached),
                received.descriptors.size() * sizeof(int));
  }
  return received;
}

}  // namespace elsie::batch
