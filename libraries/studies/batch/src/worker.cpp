#include "elsie/batch/worker.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "elsie/base/number_text.h"
#include "elsie/batch/perform.h"
#include "elsie/batch/worker_pool.h"
#include "elsie/files/emergency.h"
#include "elsie/plugin/call.h"
#include "elsie/process/crash_report.h"
#include "elsie/process/process_end.h"

#include "worker_run.h"

namespace elsie::batch {
namespace {

constexpr int kDone = 0;
constexpr int kNoJob = 2;
constexpr int kPluginFailed = 3;
constexpr int kOtherFailure = 4;

// Used in signal handlers: only write(2), and memory that is allocated already.

/// A line that is built without heap memory.
class Line {
 public:
  Line() { raw("\n!"); }  // the answer before it may be incomplete
  /// Adds a part; what separates parts and lines is replaced.
  Line& part(std::string_view text, std::string_view more = "") {
    for (const std::string_view each : {text, more}) {
      for (const char c : each) {
        raw(c == '\t' || c == '\n' ? "?" : std::string_view(&c, 1));
      }
    }
    return raw("\t");
  }
  void send(int to) {
    text_[size_ - 1] = '\n';  // after the last part
    for (std::size_t sent = 0; sent < size_;) {
      const ssize_t written = write(to, text_.data() + sent, size_ - sent);
      if (written <= 0 && errno != EINTR) {
        return;
      }
      sent += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
  }

 private:
  Line& raw(std::string_view text) {
    size_ += text.copy(text_.data() + size_, text_.size() - size_);
    return *this;
  }

  std::array<char, 1024> text_{};
  std::size_t size_ = 0;
};

/// Writes the line that last_words.h describes.
void send_last_words() {
  const plugin::CallFacts known = process::facts_at_work();
  const auto text = [](const std::string* maybe) { return maybe ? std::string_view(*maybe) : ""; };
  const bool is_known = known.step != plugin::CallFacts::kNoStep;
  const Moment now = is_known ? Moment{known.step, known.time_s} : moment_at_work();
  const int caught = process::signal_of_crash();
  const char* const name = caught != 0 ? sigabbrev_np(caught) : nullptr;
  char step[20];
  Line line;
  line.part(text(known.plugin)).part(text(known.id)).part(text(known.robot));
  line.part({step, std::to_chars(step, step + sizeof(step), now.step).ptr});
  line.part(name ? "SIG" : "", name ? name : "")
      .part(base::NumberText(now.time_s).view())
      .send(kResultDescriptor);
}

class LastWordsWriter final : public files::EmergencyWriter {
 public:
  ~LastWordsWriter() override { retire(); }
  bool write_now() noexcept override {
    send_last_words();
    return false;
  }
};

void limit_is_met(int) {
  if (!plugin::Call::innermost()) {
    send_last_words();
  }
  process::end_process("did not return before the wall limit of the run",
                       "the run did not end before its wall limit", kPluginFailed);
}

[[noreturn]] void end(int exit_code) {
  // Flush the output, but do not run the destructors of globals.
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  process::end_with(exit_code);
}

void send(std::string answer) {
  answer += '\n';
  for (std::size_t sent = 0; sent < answer.size();) {
    const ssize_t written = write(kResultDescriptor, answer.data() + sent, answer.size() - sent);
    if (written < 0 && errno != EINTR) {
      std::cerr << "elsie: the results of the run cannot be sent\n";
      end(kOtherFailure);
    }
    sent += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
}

std::string standard_input() {
  std::string text;
  std::array<char, 65'536> buffer;
  for (;;) {
    const ssize_t size = read(STDIN_FILENO, buffer.data(), buffer.size());
    if (size > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(size));
    } else if (size == 0 || errno != EINTR) {
      return text;
    }
  }
}

}  // namespace

Job job_on_input() {
  try {
    return job_from(standard_input());
  } catch (const std::exception& error) {
    std::cerr << "elsie: " << error.what()
              << "; this command is for `elsie batch`, which starts its workers by it\n";
    end(kNoJob);
  }
}

void handle_requests_to_end() {
  struct sigaction action {};
  action.sa_handler = limit_is_met;
  action.sa_flags = SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  sigaction(SIGXCPU, &action, nullptr);
  // Has no effect. Not ignored, because children of plugins would ignore it, too.
  std::signal(SIGTERM, [](int) {});
}

void do_run(const Job& job, std::unique_ptr<Preparation> prepared) {
  LastWordsWriter last_words;
  fcntl(kResultDescriptor, F_SETFD, FD_CLOEXEC);  // children of plugins must not inherit it
  const RunRecord record = perform(job, std::move(prepared));
  send(to_json(record));
  end(record.state == RunState::done    ? kDone
      : record.state == RunState::fault ? kPluginFailed
                                        : kOtherFailure);
}

void work() {
  prctl(PR_SET_NAME, kNameOfRuns);
  process::report_crashes(kPluginFailed);
  handle_requests_to_end();
  do_run(job_on_input());
}

}  // namespace elsie::batch
