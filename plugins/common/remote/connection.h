// A program of any language that takes part in a run: its process or its socket, and the lines that
// go both ways.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace remote {

/// How a program is reached.
struct Program {
  std::string command;  // for /bin/sh; empty: the file itself is started
  std::string file;     // the last argument of the command, or what is started; may be empty
  std::string socket;   // the path of a Unix socket on which it listens; empty: it is started
};

/// One line at a time: every line that is sent gets one in return. A program that does not keep to
/// that is left at once: every function throws base::Error with a sentence, and the connection is
/// of no further use.
///
/// A program that is started has a socket as its standard input and output, so that writing to one
/// that has died raises no signal. It leads a process group, which ends with the connection.
class Connection {
 public:
  /// The longest line that a program may send, in bytes.
  static constexpr std::size_t kLongest = 1 << 20;

  /// Starts the program, or connects to it. `timeout_s`: how long each of its answers may take on
  /// the clock, and at the end its leaving.
  Connection(const Program& program, double timeout_s);
  /// Sends {"end":true} and waits until the process has ended; after the time-out, or if the
  /// program failed, the process is killed.
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Sends this line and returns the answer; both without their ends.
  std::string ask(const std::string& line);
  /// Throws: what is wrong with the answer that it gave.
  [[noreturn]] void refuse(std::string_view answer, const std::string& problem);

 private:
  using Clock = std::chrono::steady_clock;

  void start(const Program& program);
  void connect_to(const std::string& path);
  void send_line(const std::string& line);
  std::string receive_line();
  /// Receives what is there; returns whether there was something.
  bool receive();
  /// Waits for one of these events, until the time-out.
  bool wait(int descriptor, short events) const;
  /// Waits for the end of the process, until the time-out.
  bool wait_for_end() const;
  /// Ends what is left of the process and its group; returns how it ended, in words.
  std::string reap();
  void set_deadline();
  [[noreturn]] void fail(const std::string& sentence);
  [[noreturn]] void fail_by_end();

  double timeout_s_;
  Clock::time_point deadline_;
  std::string name_;  // "its program 'python3 drive.py'"
  int socket_ = -1;
  pid_t process_ = 0;     // 0: none, or it has been waited for
  std::string received_;  // without an end so far
  bool failed_ = false;
};

}  // namespace remote
