#include "run_template.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <utility>

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include "start_process.h"

namespace elsie::batch {
namespace {

/// The longest time for a copy, far more than it takes on a busy machine: the template was stopped.
constexpr int kCopyTime = 3'000;  // ms

/// The two ends of the connection with a template.
struct SocketPair {
  SocketPair() {
    std::array<int, 2> ends;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      cannot_start("socketpair");
    }
    own = Descriptor(ends[0]);
    other = Descriptor(ends[1]);
  }
  Descriptor own;
  Descriptor other;
};

/// What libraries and plugins print while they are loaded and made; each copy prints it again.
Descriptor file_for_output() {
  Descriptor file(memfd_create("output", MFD_CLOEXEC));
  if (!file) {
    cannot_start("memfd_create");
  }
  return file;
}

}  // namespace

RunTemplate::RunTemplate(const std::vector<std::string>& command, const Job& example) {
  SocketPair line;
  // All addresses are looked up once, not in each copy; see kBindNow.
  const bool is_set = std::getenv(kBindNow) != nullptr;
  const std::string variable = std::string(kBindNow) + '=' + kBoundForCopies;
  process_ = start_process(command, file_of(example), file_for_output(), line.other,
                           is_set ? nullptr : variable.c_str());
  socket_ = std::move(line.own);
}

RunTemplate::RunTemplate(RunTemplate& loaded, const Job& example) : has_read_world_(true) {
  SocketPair line;
  const Descriptor output = file_for_output();
  const Descriptor job = file_of(example);
  process_ = loaded.copy({.is_template = true}, {output.get(), line.other.get(), job.get()});
  socket_ = std::move(line.own);
  if (process_ < 0) {
    state_ = State::gone;
  }
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
    refuse("the process that was to be copied ended");
  }
}

void RunTemplate::refuse(std::string why) {
  if (state_ != State::loading) {
    return;
  }
  state_ = State::refused;
  refusal_ = std::move(why);
  end();
}

pid_t RunTemplate::copy(const Job& job, const Descriptor& output, const Descriptor& answer) {
  if (has_read_world_) {
    return copy({.run = job.run, .seed = job.seed}, {output.get(), answer.get()});
  }
  const Descriptor file = file_of(job);
  return copy(CopyRequest{}, {output.get(), answer.get(), file.get()});
}

pid_t RunTemplate::copy(const CopyRequest& request, const std::vector<int>& descriptors) {
  if (state_ != State::ready) {
    return -1;
  }
  pid_t copy = -1;
  const auto receive = [&] {
    // Other lengths: a sentence, because there is no copy.
    return recv(socket_.get(), &copy, sizeof(copy), MSG_DONTWAIT | MSG_TRUNC) == sizeof(copy) &&
           copy > 0;
  };
  if (send_request(socket_.get(), request, descriptors)) {
    pollfd answered{socket_.get(), POLLIN, 0};
    while (poll(&answered, 1, kCopyTime) < 0 && errno == EINTR) {
    }
    if (receive()) {
      return copy;
    }
    shutdown(socket_.get(), SHUT_RDWR);  // a copy cannot answer any more; one has perhaps done so
    if (receive()) {
      return copy;
    }
  }
  state_ = State::gone;
  end();
  return -1;
}

}  // namespace elsie::batch
