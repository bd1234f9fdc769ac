#include "worker_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/output/clean_text.h"

#include "last_words.h"
#include "post_mortem.h"

namespace elsie::batch {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string("no worker can be started: ") + what + ": " +
                           std::generic_category().message(errno));
}

struct Pipe {
  Pipe() {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      fail("pipe");
    }
    from = Descriptor(ends[0]);
    to = Descriptor(ends[1]);
    fcntl(from.get(), F_SETFL, O_NONBLOCK);
  }
  Descriptor from;
  Descriptor to;
};

/// The job as a file in memory, positioned at its start.
Descriptor file_of(const Job& job) {
  Descriptor file(memfd_create("job", MFD_CLOEXEC));
  if (!file) {
    fail("memfd_create");
  }
  const std::string text = to_json(job);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file.get(), text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) {
      fail("write");
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  lseek(file.get(), 0, SEEK_SET);
  return file;
}

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

/// Runs in the child between vfork and exec, where only these calls are allowed. All signals are
/// blocked, and the memory is the parent's.
[[noreturn]] void become_worker(char* const* command, int job, int output, int answer,
                                pid_t parent) {
  setpgid(0,
          0);  // its own group: killed with its children, and not reached by the terminal's Ctrl-C
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    _exit(127);  // the parent has ended already
  }
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    std::signal(number, SIG_DFL);
  }
  // Not earlier, because the parent's handlers must not run here. SIGTERM waits for the worker's
  // handler.
  sigset_t blocked;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  sigprocmask(SIG_SETMASK, &blocked, nullptr);
  // The sources never overlap the targets: 0 to 2 are in use, and 3 is kept free.
  dup2(job, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  dup2(answer, kResultDescriptor);
  execv(command[0], command);
  _exit(127);
}

/// Blocks all signals in this thread during its lifetime.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

WorkerPool::Worker::Worker(const PoolOptions& options, const Job& job)
    : run_(job.run), wall_limit_s_(options.wall_limit_s), grace_s_(options.grace_s) {
  start(options, job);
}

void WorkerPool::Worker::start(const PoolOptions& options, const Job& job) {
  const Descriptor input = file_of(job);
  Pipe output;
  Pipe answer;
  std::vector<char*> command;
  for (const std::string& word : options.command) {
    command.push_back(const_cast<char*>(word.c_str()));
  }
  command.push_back(nullptr);
  // Copies above the numbers that the child assigns.
  const Descriptor high_input(fcntl(input.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  const Descriptor high_output(fcntl(output.to.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  const Descriptor high_answer(fcntl(answer.to.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  if (!high_input || !high_output || !high_answer) {
    fail("fcntl");
  }
  begun_ = Clock::now();
  due_ = begun_ +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wall_limit_s_));
  const pid_t parent = getpid();
  pid_t child = -1;
  {
    const SignalsBlocked blocked;
    // fork() copies the page tables of this process, which costs a twentieth of a short run.
    child = vfork();
    if (child == 0) {
      become_worker(command.data(), high_input.get(), high_output.get(), high_answer.get(), parent);
    }
  }
  if (child < 0) {
    fail("vfork");
  }
  process_ = child;
  setpgid(child, child);  // in the child too; the first call counts
  // By number, because the header of glibc 2.36 does not work in C++.
  process_end_ = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  if (!process_end_) {
    const int error = errno;
    reap();
    errno = error;
    fail("pidfd_open");
  }
  fcntl(process_end_.get(), F_SETFD, FD_CLOEXEC);
  output_ = std::move(output.from);
  answer_ = std::move(answer.from);
}

WorkerPool::Worker::~Worker() {
  if (process_ > 0) {
    reap();
  }
}

/// Kills the process, if it still runs, and its children.
void WorkerPool::Worker::reap() {
  kill(-process_, SIGKILL);
  kill(process_, SIGKILL);  // it may not have its own group yet
  while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

void WorkerPool::Worker::list(std::vector<pollfd>& polled) const {
  for (const Descriptor* one : {&process_end_, &output_, &answer_}) {
    polled.push_back({one->get(), POLLIN, 0});
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
  if (polled[0].revents != 0) {
    // The process has ended, but its number is still reserved: no other group is killed. Children
    // that it left behind must not keep the pipes open.
    siginfo_t info{};
    waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOWAIT);
    wall_s_ = std::chrono::duration<double>(Clock::now() - begun_).count();
    reap();
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
  if (hangs_) {
    kill(-process_, SIGKILL);
    due_ = Clock::time_point::max();
    return;
  }
  hangs_ = true;
  kill(process_, SIGTERM);
  due_ = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(grace_s_));
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
                          .wall_limit_s = wall_limit_s_});
    record.wall_s = wall_s_;
  }
  if (WIFEXITED(status_)) {
    record.exit_code = WEXITSTATUS(status_);
  }
  if (record.state != RunState::done) {
    record.log = (log_is_cut_ ? "[...]\n" : "") + output::clean(log_);
  }
  return record;
}

}  // namespace elsie::batch
