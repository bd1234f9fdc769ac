#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/batch/perform.h"
#include "elsie/batch/plan.h"
#include "elsie/batch/worker.h"
#include "elsie/batch/worker_pool.h"
#include "elsie/process/crash_report.h"
#include "elsie/process/process_end.h"
#include "elsie/world/vocabulary.h"

#include "run_template.h"
#include "start_process.h"
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
      // What can only be read, such as a table of the C library, is the same for all.
      count += line.size() > rights + 3 && line[rights + 1] == 'w' && line[rights + 3] == 's';
    }
    return count;
  }
};

void close_all(const std::vector<int>& descriptors) {
  for (const int each : descriptors) {
    close(each);
  }
}

bool has_children() {
  siginfo_t child{};
  return waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0;
}

/// Why copies of this process would not be like programs of their own, or "". `when`: what was
/// done with the libraries.
std::string obstacle(const Ties& before, const std::string& when) {
  const Ties now;
  return now.threads > 1  ? "one of them started a thread when it was " + when
         : has_children() ? "one of them started a process when it was " + when
         : now.descriptors != before.descriptors
             ? "one of them opened or closed a file when it was " + when
         : now.shared_memory != before.shared_memory
             ? "one of them shared memory when it was " + when
             : "";
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

void tell(const std::string& text) {
  ::send(kResultDescriptor, text.data(), text.size(), MSG_NOSIGNAL);
}

/// Answers a request.
void answer(int number) { ::send(kResultDescriptor, &number, sizeof(number), MSG_NOSIGNAL); }

[[noreturn]] void refuse_copies(const std::string& why) {
  tell(kRefused + why);
  process::end_with(base::kOtherFailure);
}

/// In the copy: takes the place of a program that the pool has started.
void take_place(const ReceivedRequest& received, pid_t original, const std::string& printed) {
  prctl(PR_SET_NAME, received.request.is_template ? kName : kNameOfRuns);
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != original) {
    process::end_with(base::kOtherFailure);  // it has ended already
  }
  answer(getpid());  // only now, so that the pool knows no process without its name and its group
  const std::vector<int>& given = received.descriptors;
  dup2(given[0], STDOUT_FILENO);
  dup2(given[0], STDERR_FILENO);
  dup2(given[1], kResultDescriptor);
  if (given.size() > 2) {
    dup2(given[2], STDIN_FILENO);
  }
  close_all(given);
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

/// Graphics belong to one process.
struct Cameras {};
std::unique_ptr<simulation::CameraRenderer> cameras_without_copies(const world::World&) {
  throw Cameras();
}

/// A process that is copied.
class Original {
 public:
  void load(const Job& example) {
    const Ties before;
    prepared_ = std::make_unique<Preparation>(example);
    become_ready(before, "loaded");
  }

  /// Returns only in a copy that is a template itself.
  void serve() {
    const pid_t own = getpid();
    while (const std::optional<ReceivedRequest> received = next_request(kResultDescriptor)) {
      if (received->request.ended > 0) {
        answer(end_process_group(received->request.ended));
        continue;
      }
      const pid_t copy = fork();
      if (copy == 0) {
        take_place(*received, own, printed_);
        if (received->request.is_template) {
          return;
        }
        run(*received);
      }
      close_all(received->descriptors);
      if (copy < 0) {
        answer(copy);
      }
    }
    process::end_with(base::kSuccess);
  }

  /// Reads the world of an example, and makes its objects.
  void read_world() {
    const Ties before;
    job_ = job_on_input();
    try {
      prepared_->make(job_, cameras_without_copies);
    } catch (const Cameras&) {
      refuse_copies("it has cameras");
    } catch (...) {
      refuse_copies("this failed");  // the run reports how
    }
    become_ready(before, "made");
  }

 private:
  [[noreturn]] void run(const ReceivedRequest& received) {
    if (received.descriptors.size() > 2) {
      job_ = job_on_input();
    } else {
      job_.run = received.request.run;
      job_.seed = received.request.seed;
    }
    do_run(job_, std::move(prepared_));
  }

  void become_ready(const Ties& before, const std::string& when) {
    std::cout.flush();
    std::fflush(nullptr);
    if (const std::string why = obstacle(before, when); !why.empty()) {
      refuse_copies(why);
    }
    printed_ = printed();
    tell({kReady});
  }

  std::unique_ptr<Preparation> prepared_;
  Job job_;
  std::string printed_;
};

}  // namespace

void stand_by() {
  prctl(PR_SET_NAME, kName);
  if (const char* const set = std::getenv(kBindNow); set && set == std::string(kBoundForCopies)) {
    unsetenv(kBindNow);  // children of plugins must not find it
  }
  process::report_crashes(base::kPluginFailed);
  handle_requests_to_end();
  Original original;
  const Job example = job_on_input();
  world::vocabulary();  // loads all engines, and what they link to
  rehearse();
  original.load(example);
  original.serve();
  original.read_world();
  original.serve();
  process::end_with(base::kOtherFailure);  // a copy with a world makes no templates
}

}  // namespace elsie::batch
