#include "run_template.h"

#include <array>
#include <cerrno>
#include <utility>

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include "start_process.h"

namespace elsie::batch {
namespace {

/// The longest time for an answer, far more than it takes on a busy machine: the template was
/// stopped.
constexpr int kAnswerTime = 10'000;  // ms

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
  process_ = start_process(command, file_of(example), file_for_output(), line.other, Binding::now);
  socket_ = std::move(line.own);
}

RunTemplate::RunTemplate(std::shared_ptr<RunTemplate> loaded, const Job& example)
    : loaded_(std::move(loaded)) {
  SocketPair line;
  const Descriptor output = file_for_output();
  const Descriptor job = file_of(example);
  process_ = loaded_->answer_to({.is_template = true}, {output.get(), line.other.get(), job.get()})
                 .value_or(-1);
  socket_ = std::move(line.own);
  if (process_ < 0) {
    state_ = State::gone;
  }
}

void RunTemplate::end() {
  if (const pid_t process = std::exchange(process_, -1); process > 0 && loaded_) {
    loaded_->end_copy(process);
  } else if (process > 0) {
    end_process_group(process);
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
  if (loaded_) {
    return answer_to({.run = job.run, .seed = job.seed}, {output.get(), answer.get()}).value_or(-1);
  }
  const Descriptor file = file_of(job);
  return answer_to({}, {output.get(), answer.get(), file.get()}).value_or(-1);
}

std::optional<int> RunTemplate::end_copy(pid_t worker) { return answer_to({.ended = worker}, {}); }

std::optional<int> RunTemplate::answer_to(const CopyRequest& request,
                                          const std::vector<int>& descriptors) {
  if (state_ != State::ready) {
    return std::nullopt;
  }
  if (send_request(socket_.get(), request, descriptors)) {
    pollfd answered{socket_.get(), POLLIN, 0};
    while (poll(&answered, 1, kAnswerTime) < 0 && errno == EINTR) {
    }
    int answer = 0;
    if (recv(socket_.get(), &answer, sizeof(answer), MSG_DONTWAIT) == sizeof(answer)) {
      return answer;
    }
  }
  state_ = State::gone;
  end();
  return std::nullopt;
}

}  // namespace elsie::batch
