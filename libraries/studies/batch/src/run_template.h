// A process that has done what several runs have in common, and is copied for each of them.
//
// There are two kinds. One has loaded the libraries of its runs. The other is a copy of such a
// process that has also read a world and made the objects of its plugins: its runs differ in their
// seeds only. The pool starts each with a job as an example of its runs. The process reports that
// it is ready, or why it makes no copies; see kReady and kRefused. Then it waits for requests; see
// copy_request.h. It makes copies by fork(), and is asked to wait for them when they have ended.
// They end with it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

#include "elsie/batch/job.h"

#include "copy_request.h"
#include "descriptor.h"

namespace elsie::batch {

/// The first message of the process: that it is ready; or that it is not, followed by the reason.
inline constexpr char kReady = '+';
inline constexpr char kRefused = '-';

class RunTemplate {
 public:
  /// Starts a program that loads the libraries of the example. Throws std::runtime_error.
  RunTemplate(const std::vector<std::string>& command, const Job& example);
  /// Copies a process that has loaded them. The copy also reads the world of the example. Throws
  /// std::runtime_error.
  RunTemplate(std::shared_ptr<RunTemplate> loaded, const Job& example);
  ~RunTemplate() { end(); }
  RunTemplate(const RunTemplate&) = delete;
  RunTemplate& operator=(const RunTemplate&) = delete;

  bool is_loading() const { return state_ == State::loading; }
  bool is_ready() const { return state_ == State::ready; }
  /// It was ready, but has ended since, or does not answer.
  bool is_gone() const { return state_ == State::gone; }
  /// Readable when there is something to hear(); -1 when the process has ended.
  int socket() const { return socket_.get(); }
  /// Hears whether the process is ready.
  void hear();
  /// Ends a process that cannot make copies.
  void refuse(std::string why);
  /// Why it makes no copies, once; "" if it does.
  std::string take_refusal() { return std::exchange(refusal_, {}); }
  /// Returns the number of a worker that has begun this job; -1 if there is none.
  pid_t copy(const Job& job, const Descriptor& output, const Descriptor& answer);
  /// Kills a worker, if it still runs, and its process group. Returns its status as waitpid(2)
  /// does; none: the template has ended, and the worker with it.
  std::optional<int> end_copy(pid_t worker);

 private:
  enum class State { loading, ready, refused, gone };
  std::optional<int> answer_to(const CopyRequest& request, const std::vector<int>& descriptors);
  void end();

  State state_ = State::loading;
  std::shared_ptr<RunTemplate> loaded_;  // of which this is a copy that has read a world
  pid_t process_ = -1;
  Descriptor socket_;
  std::string refusal_;
};

}  // namespace elsie::batch
