#include "child.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/random.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace elsie::supervisor {
namespace {

// A signal handler can only reach globals.
std::atomic<pid_t> child{0};
std::atomic<int> requests{0};  // to end, since the last check

/// Signals that users or schedulers send to a process. The program gets all of them and decides
/// what to do.
constexpr std::array kHandedOn{SIGINT,  SIGTERM, SIGHUP,  SIGQUIT, SIGUSR1, SIGUSR2,
                               SIGPIPE, SIGALRM, SIGXCPU, SIGTSTP, SIGCONT};

bool is_sent_by_terminals(int signal) {
  return signal == SIGINT || signal == SIGQUIT || signal == SIGTSTP || signal == SIGHUP ||
         signal == SIGCONT;
}

bool asks_to_end(int signal) { return signal == SIGINT || signal == SIGTERM || signal == SIGHUP; }

void hand_on(int signal, siginfo_t* info, void*) {
  const int error = errno;
  // A terminal sends its signals to the child, too.
  const bool from_terminal = info && info->si_code == SI_KERNEL && is_sent_by_terminals(signal);
  if (child > 0 && !from_terminal) {
    kill(child, signal);
  }
  if (asks_to_end(signal)) {
    ++requests;
  }
  if (signal == SIGTSTP) {
    raise(SIGSTOP);
  }
  errno = error;
}

/// Forwards signals from now on. Ignored ones stay ignored for both processes, except for requests
/// to end: shells ignore Ctrl-C for background jobs, but the program obeys it.
void hand_signals_on() {
  for (const int signal : kHandedOn) {
    struct sigaction action {};
    const bool always = signal == SIGINT || signal == SIGTERM;
    if (!always && sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) {
      continue;
    }
    action = {};
    action.sa_sigaction = hand_on;
    action.sa_flags = SA_SIGINFO;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string("the program cannot be started: ") + what + ": " +
                           std::generic_category().message(errno));
}

/// Kills a child that does not end after two requests.
class Patience {
 public:
  /// True if it is over. Must be called at least ten times a second.
  bool is_over() {
    using Clock = std::chrono::steady_clock;
    const auto now = Clock::now();
    if (const int come = requests.exchange(0); come > 0) {
      // timeout(1), schedulers and shells send a signal to a process and to its group: one request.
      // Further requests do not extend the time.
      if (asked_ == 0 || (asked_ == 1 && now - last_ > std::chrono::milliseconds(500))) {
        ++asked_;
        last_ = now;
      }
    }
    return asked_ > 1 && now - last_ > std::chrono::seconds(3);
  }
  bool has_begun() const { return asked_ > 1; }

 private:
  int asked_ = 0;
  std::chrono::steady_clock::time_point last_;
};

std::uint64_t random_number() {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof(number), 0) != sizeof(number)) {
    fail("getrandom");
  }
  return number;
}

/// Reads the messages. Copies that a plugin makes of the process also have the pipe: their messages
/// come from another process.
void read_messages(int from, std::uint64_t token, pid_t process, End& end, int& exit_code) {
  Message message;
  while (read(from, &message, sizeof(message)) == sizeof(message)) {
    if (message.token == token && message.process == process) {
      end.has_said_so = true;
      exit_code = message.exit_code;
    }
  }
}

/// Waits until the child has ended. Signals are blocked except with this mask while it waits.
void wait_for_end(int process_end, const sigset_t& mask, End& end) {
  Patience patience;
  for (;;) {
    pollfd ended{process_end, POLLIN, 0};
    // Without a second request, only the end or a signal wakes this process.
    constexpr timespec kPause{0, 100'000'000};
    if (ppoll(&ended, 1, patience.has_begun() ? &kPause : nullptr, &mask) > 0) {
      break;
    }
    if (patience.is_over() && !end.was_killed) {
      end.was_killed = true;
      kill(child, SIGKILL);
    }
  }
  const pid_t process = child.exchange(0);
  while (waitpid(process, &end.status, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

void become(const std::string& program, char** arguments) { execv(program.c_str(), arguments); }

End run_child(const std::string& program, char** arguments) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    fail("pipe");
  }
  // A high number if possible: plugins that close "their" descriptors begin with 3.
  constexpr int kHigh = 200;
  int channel = fcntl(ends[1], F_DUPFD, kHigh);
  if (channel < 0) {
    channel = fcntl(ends[1], F_DUPFD, 0);
  }
  if (channel < 0) {
    fail("fcntl");
  }
  close(ends[1]);
  const std::uint64_t token = random_number();
  setenv(kVariable, (std::to_string(channel) + ":" + std::to_string(token)).c_str(), 1);

  // No signal may come between the start of the child and the assignment of its number.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before);
  const pid_t self = getpid();
  const pid_t made = fork();
  if (made == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // killing this process kills the program
    if (getppid() == self) {
      sigprocmask(SIG_SETMASK, &before, nullptr);
      become(program, arguments);
    }
    _exit(127);
  }
  if (made < 0) {
    fail("fork");
  }
  close(channel);
  child = made;
  const int process_end = static_cast<int>(syscall(SYS_pidfd_open, made, 0));
  if (process_end < 0) {
    fail("pidfd_open");
  }
  hand_signals_on();
  End end;
  wait_for_end(process_end, before, end);
  int exit_code = 0;
  read_messages(ends[0], token, made, end, exit_code);
  const int shell_code =
      WIFEXITED(end.status) ? WEXITSTATUS(end.status) : 128 + WTERMSIG(end.status);
  end.has_said_so = end.has_said_so && shell_code == exit_code;
  return end;
}

}  // namespace elsie::supervisor
