// A process that has loaded the libraries of a run, and is copied for each run that needs the same.
//
// The pool starts it with a job as an example of these runs. It loads their libraries and reports
// that it is ready, or why it makes no copies; see kReady and kRefused. Then it waits for requests:
// messages with three descriptors, for the input, the output and the answer of a worker.
// It makes the copy with CLONE_PARENT, so that the copy is a child of the pool like any other
// worker, and answers with its process number. It runs no code of plugins after their declarations
// were read.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

#include "elsie/batch/job.h"

#include "descriptor.h"

namespace elsie::batch {

/// The first message of the process: that it is ready; or that it is not, followed by the reason.
inline constexpr char kReady = '+';
inline constexpr char kRefused = '-';

class RunTemplate {
 public:
  /// Starts the process. Throws std::runtime_error.
  RunTemplate(const std::vector<std::string>& command, const Job& example);
  ~RunTemplate() { end(); }
  RunTemplate(const RunTemplate&) = delete;
  RunTemplate& operator=(const RunTemplate&) = delete;

  bool is_loading() const { return state_ == State::loading; }
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
  /// Returns the number of a worker that has begun; -1 if there is none.
  pid_t copy(const Descriptor& job, const Descriptor& output, const Descriptor& answer);

 private:
  enum class State { loading, ready, refused, gone };
  void end();

  State state_ = State::loading;
  pid_t process_ = -1;
  Descriptor socket_;
  std::string refusal_;
};

}  // namespace elsie::batch
