#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/batch/perform.h"
#include "elsie/batch/plan.h"
#include "elsie/batch/worker.h"
#include "elsie/batch/worker_pool.h"
#include "elsie/process/crash_report.h"
#include "elsie/process/process_end.h"

#include "run_template.h"
#include "worker_run.h"

namespace elsie::batch {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "elsie-template";

/// What copies would share with this process, or would lack.
struct Ties {
  std::ptrdiff_t threads = entries_of("/proc/self/task");
  std::ptrdiff_t descriptors = entries_of("/proc/self/fd");
  std::ptrdiff_t shared_memory = count_shared_memory();

  static std::ptrdiff_t entries_of(const char* folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }
  static std::ptrdiff_t count_shared_memory() {
    std::ptrdiff_t count = 0;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
      const std::size_t rights = line.find(' ') + 1;  // such as "rw-s"
      count += line.size() > rights + 3 && line[rights + 3] == 's' ? 1 : 0;
    }
    return count;
  }
};

/// SIGTERM is blocked, in contrast to a worker that loads libraries.
bool was_asked_to_end() {
  sigset_t waiting;
  return sigpending(&waiting) == 0 && sigismember(&waiting, SIGTERM) == 1;
}

bool has_children() {
  siginfo_t child{};
  return waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0;
}

/// Why copies of this process would not be like programs of their own, or "".
std::string obstacle(const Ties& before) {
  const Ties now;
  return now.threads > 1      ? "one of them started a thread when it was loaded"
         : was_asked_to_end() ? "SIGTERM came while they were loaded"
         : has_children()     ? "one of them started a process when it was loaded"
         : now.descriptors != before.descriptors
             ? "one of them opened or closed a file when it was loaded"
         : now.shared_memory != before.shared_memory
             ? "one of them shared memory when it was loaded"
             : "";
}

/// The place where the C library keeps the number of this process's only thread; null if the
/// system does not say.
int* place_of_thread_number() {
  int* place = nullptr;
  return prctl(PR_GET_TID_ADDRESS, &place) == 0 && place && *place == getpid() ? place : nullptr;
}

/// As fork(), but the copy is a child of this process's parent, and functions registered with
/// pthread_atfork() are not called: plugins must not notice.
pid_t copy_beside(int* thread_number) {
  constexpr unsigned long kFlags =
      CLONE_PARENT | CLONE_CHILD_SETTID | CLONE_CHILD_CLEARTID | SIGCHLD;
#if defined(__x86_64__)
  return static_cast<pid_t>(syscall(SYS_clone, kFlags, nullptr, nullptr, thread_number, 0));
#else
  return static_cast<pid_t>(syscall(SYS_clone, kFlags, nullptr, nullptr, 0, thread_number));
#endif
}

/// What libraries printed while they were loaded.
std::string printed() {
  std::string text;
  std::array<char, 4096> part;
  for (;;) {
    const ssize_t size =
        pread(STDOUT_FILENO, part.data(), part.size(), static_cast<off_t>(text.size()));
    if (size <= 0) {
      return text;
    }
    text.append(part.data(), static_cast<std::size_t>(size));
  }
}

/// The descriptors of a request. Ends the process when the pool has closed the socket.
std::array<int, 3> next_request() {
  std::array<int, 3> received{};
  char nothing = 0;
  iovec text{&nothing, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(received))> control{};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  ssize_t size = 0;
  do {
    size = recvmsg(kResultDescriptor, &message, MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  const cmsghdr* const header = size == 1 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (!header || header->cmsg_len != CMSG_LEN(sizeof(received))) {
    process::end_with(base::kSuccess);
  }
  std::memcpy(received.data(), CMSG_DATA(header), sizeof(received));
  return received;
}

/// In the copy: takes the place of a program that the pool has started.
void take_place(const std::array<int, 3>& request, pid_t pool, const std::string& printed) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != pool) {
    process::end_with(base::kOtherFailure);  // the pool has ended already
  }
  const auto [job, output, answer] = request;
  dup2(job, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  dup2(answer, kResultDescriptor);
  for (const int copied : request) {
    close(copied);
  }
  std::cerr << printed << std::flush;
  process::report_crashes_of_copy();
}

/// Does a run without plugins. What it sets up once for a process, such as the words of the world
/// format or the addresses of functions, need not be set up in each copy.
void rehearse() {
  Job job;
  job.world_text = R"(<world format="1"><limits time="0.02"/><obstacles><static_box/>
      <dynamic_box x="1"/></obstacles></world>)";
  to_json(perform(job_from(to_json(job))));
}

void tell(const std::string& text) {
  ::send(kResultDescriptor, text.data(), text.size(), MSG_NOSIGNAL);
}

[[noreturn]] void refuse_copies(const std::string& why) {
  tell(kRefused + why);
  process::end_with(base::kOtherFailure);
}

}  // namespace

void stand_by() {
  prctl(PR_SET_NAME, kName);
  // SIGTERM stays blocked, here and in copies until they can handle it.
  process::report_crashes(base::kPluginFailed);
  const pid_t pool = getppid();
  int* const thread_number = place_of_thread_number();
  if (!thread_number) {
    refuse_copies("this system does not say what a copy of a process needs");
  }
  const Job example = job_on_input();
  deciding_libraries();  // loads the engines
  rehearse();
  const Ties before;
  std::optional<plugin::Host> loaded(load_libraries(example));
  std::cout.flush();
  std::fflush(nullptr);
  if (const std::string why = obstacle(before); !why.empty()) {
    refuse_copies(why);
  }
  const std::string output = printed();
  tell({kReady});
  for (;;) {
    const std::array<int, 3> request = next_request();
    prctl(PR_SET_NAME, kNameOfRuns);  // of the copy: it never has another
    const pid_t copy = copy_beside(thread_number);
    if (copy == 0) {
      take_place(request, pool, output);
      do_run(std::move(loaded));
    }
    prctl(PR_SET_NAME, kName);
    for (const int copied : request) {
      close(copied);
    }
    ::send(kResultDescriptor, &copy, sizeof(copy), MSG_NOSIGNAL);
  }
}

}  // namespace elsie::batch
