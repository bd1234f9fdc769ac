#include "elsie/process/run_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/files/emergency.h"

extern char** environ;

namespace elsie::process {
namespace {

/// What the process writes until it ends, although others that it has started may still hold the
/// pipe.
std::string read_all(int from, pid_t process) {
  const auto ended = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
  std::string text;
  std::array<char, 4096> buffer;
  bool has_ended = false;
  for (;;) {
    std::array<pollfd, 2> waited{{{from, POLLIN, 0}, {ended, POLLIN, 0}}};
    if (poll(waited.data(), waited.size(), has_ended ? 0 : -1) < 0) continue;
    if (waited[0].revents == 0) {
      if (std::exchange(has_ended, true)) break;  // after a look at what it has written last
      continue;
    }
    const ssize_t count = read(from, buffer.data(), buffer.size());
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      break;
    }
  }
  if (ended >= 0) close(ended);
  return text;
}

/// A process that leads its own group, which ends with this process.
class Group final : private files::EmergencyWriter {
 public:
  Group(pid_t leader, int signal) : leader_(leader), signal_(signal) {}
  ~Group() override { retire(); }
  void terminate() const noexcept { kill(-leader_, signal_); }

 private:
  void clean_up_now() noexcept override { terminate(); }

  const pid_t leader_;
  const int signal_;
};

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments,
                                         const std::stop_token& stop, int signal) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) {
    return std::nullopt;
  }
  const auto [reads, writes] = pipe_ends;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, writes, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, writes, STDERR_FILENO);
  // The process gets a group of its own, so that it can be ended with all its children. It blocks
  // no signals, even if the calling thread does.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> copies = arguments;
  std::vector<char*> words;
  for (std::string& word : copies) {
    words.push_back(word.data());
  }
  words.push_back(nullptr);
  pid_t process = 0;
  const int problem =
      posix_spawnp(&process, words.front(), &actions, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(writes);
  std::optional<ProcessResult> result;
  if (problem == 0) {
    result.emplace();
    {
      const Group group(process, signal);
      const std::stop_callback stopped(stop, [&group] { group.terminate(); });
      result->output = read_all(reads, process);
    }
    result->exit_code = wait_for(process);
  }
  close(reads);
  return result;
}

}  // namespace elsie::process
