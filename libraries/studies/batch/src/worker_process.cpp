#include "worker_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/files/clean_text.h"

#include "last_words.h"
#include "post_mortem.h"
#include "start_process.h"

namespace elsie::batch {
namespace {

struct Pipe {
  Pipe() {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      cannot_start("pipe");
    }
    from = Descriptor(ends[0]);
    to = Descriptor(ends[1]);
    fcntl(from.get(), F_SETFL, O_NONBLOCK);
  }
  Descriptor from;
  Descriptor to;
};

/// Reads everything that is in a pipe now. Returns false at its end.
template <class Take>
bool drain(const Descriptor& from, const Take& take) {
  std::array<char, 64 * 1024> buffer;
  for (;;) {
    const ssize_t size = read(from.get(), buffer.data(), buffer.size());
    if (size > 0) {
      take(buffer.data(), static_cast<std::size_t>(size));
    } else if (size == 0) {
      return false;
    } else if (errno != EINTR) {
      return errno == EAGAIN;
    }
  }
}

}  // namespace

WorkerPool::Worker::Worker(const PoolOptions& options, Job job, RunTemplates& originals)
    : options_(options), job_(std::move(job)), originals_(originals) {
  set_due(options_.wall_limit_s);
  proceed();
}

void WorkerPool::Worker::set_due(double in_s) {
  begun_ = Clock::now();
  due_ = begun_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(in_s));
}

void WorkerPool::Worker::proceed() {
  original_ = has_begun_again_ ? nullptr : originals_.original_for(job_);
  if (original_ && original_->is_loading()) {
    return;
  }
  Pipe output;
  Pipe answer;
  if (original_) {
    process_ = original_->copy(job_, output.to, answer.to);
  }
  if (process_ < 0) {
    original_ = nullptr;
    process_ = start_process(options_.command, file_of(job_), output.to, answer.to);
  }
  set_due(options_.wall_limit_s);  // a copy that was not made may have taken time
  // By number, because the header of glibc 2.36 does not work in C++.
  process_end_ = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, process_, 0)));
  if (!process_end_) {
    const int error = errno;
    if (error == ESRCH && original_) {  // the template ended, and its copy with it
      process_ = -1;
      begin_again();
      return;
    }
    reap();
    errno = error;
    cannot_start("pidfd_open");
  }
  fcntl(process_end_.get(), F_SETFD, FD_CLOEXEC);
  output_ = std::move(output.from);
  answer_ = std::move(answer.from);
}

void WorkerPool::Worker::begin_again() {
  has_begun_again_ = true;
  log_.clear();
  log_is_cut_ = false;
  answered_.clear();
  too_long_ = false;
  hangs_ = false;
  proceed();
}

WorkerPool::Worker::~Worker() {
  if (process_ > 0) {
    reap();
  }
}

bool WorkerPool::Worker::reap() {
  const pid_t process = std::exchange(process_, -1);
  const std::optional<int> status =
      original_ ? original_->end_copy(process) : end_process_group(process);
  status_ = status.value_or(0);
  return status.has_value();
}

void WorkerPool::Worker::list(std::vector<pollfd>& polled) const {
  const int first = is_waiting() ? original_->socket() : process_end_.get();
  for (const int one : {first, output_.get(), answer_.get()}) {
    polled.push_back({one, POLLIN, 0});
  }
}

void WorkerPool::Worker::read_output() {
  const bool more = drain(output_, [&](const char* text, std::size_t size) {
    log_.append(text, size);
    if (log_.size() > 2 * kLogTail) {
      log_.erase(0, log_.size() - kLogTail);
      log_is_cut_ = true;
    }
  });
  if (!more) {
    output_.reset();
  }
}

void WorkerPool::Worker::read_answer() {
  const bool more = drain(answer_, [&](const char* text, std::size_t size) {
    if (answered_.size() + size <= kLongestAnswer) {
      answered_.append(text, size);
    } else {
      too_long_ = true;
    }
  });
  if (!more) {
    answer_.reset();
  }
}

void WorkerPool::Worker::read(const pollfd* polled) {
  if (is_waiting()) {
    proceed();
    return;
  }
  if (polled[0].revents != 0) {
    wall_s_ = std::chrono::duration<double>(Clock::now() - begun_).count();
    // Children that it left behind must not keep the pipes open.
    if (!reap()) {
      begin_again();
      return;
    }
    ended_ = true;
    process_end_.reset();
  }
  if (output_ && (ended_ || polled[1].revents != 0)) {
    read_output();
  }
  if (answer_ && (ended_ || polled[2].revents != 0)) {
    read_answer();
  }
}

void WorkerPool::Worker::overdue(Clock::time_point now) {
  if (is_waiting()) {
    original_->refuse("this took longer than the wall limit of a run");
    proceed();
    return;
  }
  if (hangs_) {
    kill(-process_, SIGKILL);
    due_ = Clock::time_point::max();
    return;
  }
  hangs_ = true;
  kill(process_, SIGXCPU);
  due_ = now + std::chrono::duration_cast<Clock::duration>(
                   std::chrono::duration<double>(options_.grace_s));
}

RunRecord WorkerPool::Worker::record() {
  RunRecord record;
  if (log_.size() > kLogTail) {
    log_.erase(0, log_.size() - kLogTail);
    log_is_cut_ = true;
  }
  const std::optional<LastWords> words = last_words_in(answered_);
  std::string problem;
  if (!words && answered_.ends_with('\n')) {
    try {
      record = record_from(answered_);
    } catch (const std::exception& error) {
      problem = error.what();
    }
  }
  const bool ended_well = WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
  const bool crashed_beside = record.state == RunState::done && !ended_well;
  if (crashed_beside) {
    record = {};
    problem =
        "it had answered, but a thread of a plugin, or the unloading of a library, ended the "
        "process in another way; see the end of its output";
  }
  if (record.state == RunState::error && record.message.empty()) {
    record = post_mortem({.status = status_,
                          .words = words,
                          .problem = problem,
                          .said_nothing = answered_.empty() || crashed_beside,
                          .said_too_much = too_long_,
                          .overdue = hangs_,
                          .wall_limit_s = options_.wall_limit_s});
    record.wall_s = wall_s_;
  }
  if (WIFEXITED(status_)) {
    record.exit_code = WEXITSTATUS(status_);
  }
  if (record.state != RunState::done) {
    record.log = (log_is_cut_ ? "[...]\n" : "") + files::clean(log_);
  }
  return record;
}

}  // namespace elsie::batch
