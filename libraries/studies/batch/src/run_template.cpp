#include "run_template.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include "start_process.h"

namespace elsie::batch {
namespace {

/// The longest time for a copy: far more than it takes on a machine that is busy.
constexpr int kCopyTime = 10'000;  // ms

/// Sends a message with descriptors. Returns whether it was sent.
bool send_descriptors(int to, std::array<int, 3> sent) {
  char nothing = 0;
  iovec text{&nothing, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(sent))> control{};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(sent));
  std::memcpy(CMSG_DATA(header), sent.data(), sizeof(sent));
  return sendmsg(to, &message, MSG_NOSIGNAL | MSG_DONTWAIT) == 1;
}

}  // namespace

RunTemplate::RunTemplate(const std::vector<std::string>& command, const Job& example) {
  std::array<int, 2> ends;
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    cannot_start("socketpair");
  }
  socket_ = Descriptor(ends[0]);
  const Descriptor other(ends[1]);
  // What libraries print while they are loaded; the copies print it again.
  const Descriptor output(memfd_create("output", MFD_CLOEXEC));
  if (!output) {
    cannot_start("memfd_create");
  }
  process_ = start_process(command, file_of(example), output, other);
}

void RunTemplate::end() {
  if (process_ > 0) {
    end_process_group(std::exchange(process_, -1));
  }
  socket_.reset();
}

void RunTemplate::hear() {
  if (state_ != State::loading) {
    return;
  }
  std::array<char, 1024> text;
  const ssize_t size = recv(socket_.get(), text.data(), text.size(), MSG_DONTWAIT);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) {
    return;
  }
  if (size == 1 && text[0] == kReady) {
    state_ = State::ready;
  } else if (size > 1 && text[0] == kRefused) {
    refuse({text.data() + 1, static_cast<std::size_t>(size) - 1});
  } else {
    refuse("the process that loaded them ended");
  }
}

void RunTemplate::refuse(std::string why) {
  state_ = State::refused;
  refusal_ = std::move(why);
  end();
}

pid_t RunTemplate::copy(const Descriptor& job, const Descriptor& output, const Descriptor& answer) {
  if (state_ != State::ready) {
    return -1;
  }
  pid_t copy = -1;
  pollfd answered{socket_.get(), POLLIN, 0};
  if (send_descriptors(socket_.get(), {job.get(), output.get(), answer.get()})) {
    int count = 0;
    do {
      count = poll(&answered, 1, kCopyTime);
    } while (count < 0 && errno == EINTR);
    if (count == 1 && recv(socket_.get(), &copy, sizeof(copy), MSG_DONTWAIT) == sizeof(copy)) {
      return copy;
    }
  }
  state_ = State::gone;
  end();
  return -1;
}

}  // namespace elsie::batch
