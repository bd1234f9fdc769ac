#include "start_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/batch/worker_pool.h"

namespace elsie::batch {
namespace {

/// Runs in the child between vfork and exec, where only these calls are allowed. All signals are
/// blocked, and the memory is the parent's.
[[noreturn]] void become_worker(char* const* command, char* const* environment, int job, int output,
                                int answer, pid_t parent) {
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
  execve(command[0], command, environment);
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

void cannot_start(const char* call) {
  throw std::runtime_error(std::string("no worker can be started: ") + call + ": " +
                           std::generic_category().message(errno));
}

Descriptor file_of(const Job& job) {
  Descriptor file(memfd_create("job", MFD_CLOEXEC));
  if (!file) {
    cannot_start("memfd_create");
  }
  const std::string text = to_json(job);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file.get(), text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) {
      cannot_start("write");
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  lseek(file.get(), 0, SEEK_SET);
  return file;
}

pid_t start_process(const std::vector<std::string>& command, const Descriptor& input,
                    const Descriptor& output, const Descriptor& answer, const char* variable) {
  std::vector<char*> words;
  for (const std::string& word : command) {
    words.push_back(const_cast<char*>(word.c_str()));
  }
  words.push_back(nullptr);
  std::vector<char*> variables;
  for (char** each = environ; *each; ++each) {
    variables.push_back(*each);
  }
  variables.push_back(const_cast<char*>(variable));
  variables.push_back(nullptr);
  // Copies above the numbers that the child assigns.
  const Descriptor high_input(fcntl(input.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  const Descriptor high_output(fcntl(output.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  const Descriptor high_answer(fcntl(answer.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  if (!high_input || !high_output || !high_answer) {
    cannot_start("fcntl");
  }
  const pid_t parent = getpid();
  pid_t child = -1;
  {
    const SignalsBlocked blocked;
    // fork() copies the page tables of this process, which costs a twentieth of a short run.
    child = vfork();
    if (child == 0) {
      become_worker(words.data(), variables.data(), high_input.get(), high_output.get(),
                    high_answer.get(), parent);
    }
  }
  if (child < 0) {
    cannot_start("vfork");
  }
  setpgid(child, child);  // in the child too; the first call counts
  return child;
}

int end_process_group(pid_t process) {
  kill(-process, SIGKILL);
  kill(process, SIGKILL);  // it may not have its own group yet
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace elsie::batch
