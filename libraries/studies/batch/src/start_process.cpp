#include "start_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
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

/// In the child: becomes the program.
[[noreturn]] void become(char* const* command, int input, int output, int answer, pid_t parent) {
  // Its own group: killed with its children, and not reached by the terminal's Ctrl-C.
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() == parent) {  // it has not ended already
    for (const int number : {SIGINT, SIGHUP, SIGPIPE}) {
      std::signal(number, SIG_DFL);
    }
    std::signal(SIGTERM, SIG_IGN);  // until the program handles it
    // The sources never overlap the targets: 0 to 2 are in use, and 3 is kept free.
    dup2(input, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    dup2(answer, kResultDescriptor);
    execv(command[0], command);
  }
  _exit(127);
}

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
                    const Descriptor& output, const Descriptor& answer, Binding binding) {
  std::vector<char*> words;
  for (const std::string& word : command) {
    words.push_back(const_cast<char*>(word.c_str()));
  }
  words.push_back(nullptr);
  // Copies above the numbers that the child assigns.
  const Descriptor high_input(fcntl(input.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  const Descriptor high_output(fcntl(output.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  const Descriptor high_answer(fcntl(answer.get(), F_DUPFD_CLOEXEC, kResultDescriptor + 1));
  if (!high_input || !high_output || !high_answer) {
    cannot_start("fcntl");
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    if (binding == Binding::now) {
      setenv(kBindNow, kBoundForCopies, 0);
    }
    become(words.data(), high_input.get(), high_output.get(), high_answer.get(), parent);
  }
  if (child < 0) {
    cannot_start("fork");
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
