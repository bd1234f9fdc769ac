#include "connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <elsie/base/error.h>
#include <elsie/base/number_text.h>
#include <elsie/base/words.h>

extern char** environ;

namespace remote {
namespace {

namespace fs = std::filesystem;
using elsie::base::in_quotes;

constexpr std::size_t kShown = 60;  // characters of what it said, in a message

std::string reason(int error) { return std::generic_category().message(error); }

std::string name_of(const Program& program) {
  if (!program.socket.empty()) return "the program at the socket " + in_quotes(program.socket, 200);
  const std::string file = fs::path(program.file).filename().string();
  return "its program " +
         in_quotes(program.command + (program.command.empty() || file.empty() ? "" : " ") + file,
                   200);
}

/// What a program said, for a message.
std::string in_short(std::string_view said) {
  if (said.ends_with('\n')) said.remove_suffix(1);
  return in_quotes(said, kShown);
}

/// Starts a process with this end of a socket as its standard input and output. It gets a group of
/// its own, so that Ctrl-C in a terminal ends the simulation first, and the signals of a new
/// process, whatever this one does with them. Returns 0 or what is wrong.
int spawn(std::vector<std::string> words, const std::string& folder, int end, pid_t& process) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, end, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, end, STDOUT_FILENO);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int problem =
      posix_spawn(&process, pointers.front(), &actions, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return problem;
}

}  // namespace

Connection::Connection(const Program& program, double timeout_s)
    : timeout_s_(timeout_s), name_(name_of(program)) {
  program.socket.empty() ? start(program) : connect_to(program.socket);
}

Connection::~Connection() {
  if (!failed_) {
    constexpr std::string_view kEnd = "{\"end\":true}\n";
    send(socket_, kEnd.data(), kEnd.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    // What it still says finds an open socket, so that it does not end with an error.
    shutdown(socket_, SHUT_WR);
  }
  if (process_ != 0) {
    set_deadline();
    if (!failed_) wait_for_end();
    reap();
  }
  close(socket_);
}

void Connection::start(const Program& program) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw elsie::base::Error("cannot start " + name_ + ": " + reason(errno));
  }
  const std::string file =
      program.file.empty() ? std::string() : fs::absolute(program.file).string();
  std::vector<std::string> words{file};
  if (!program.command.empty()) {
    words = {"/bin/sh", "-c", program.command, "elsie"};
    if (!file.empty()) {
      words[2] += " \"$@\"";
      words.push_back(file);
    }
  }
  const int problem = spawn(words, fs::path(file).parent_path().string(), ends[1], process_);
  close(ends[1]);
  socket_ = ends[0];
  if (problem != 0) {
    process_ = 0;
    close(socket_);
    const bool may_not_run = problem == EACCES || problem == ENOEXEC;
    throw elsie::base::Error(
        "cannot start " + name_ + ": " + reason(problem) +
        (may_not_run ? "; make the file executable and let its first line name what runs it "
                       "(#!/usr/bin/env python3), or give that as 'command'"
                     : ""));
  }
}

void Connection::connect_to(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    throw elsie::base::Error("the path of the socket " + in_quotes(path, 200) + " has " +
                             std::to_string(path.size()) + " bytes; expected at most " +
                             std::to_string(sizeof address.sun_path - 1));
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  timeval patience{};
  patience.tv_sec = static_cast<time_t>(timeout_s_);
  patience.tv_usec = static_cast<suseconds_t>((timeout_s_ - std::floor(timeout_s_)) * 1e6);
  setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int error = errno;
    close(socket_);
    throw elsie::base::Error("cannot connect to " + name_ + ": " + reason(error) +
                             "; start it before the run, and let it listen there");
  }
}

std::string Connection::ask(const std::string& line) {
  set_deadline();
  receive();
  if (!received_.empty()) {
    fail(name_ + " said " + in_short(received_) +
         " without being asked; expected one line for each that it is sent, and what people are to "
         "read on its standard error");
  }
  send_line(line + '\n');
  return receive_line();
}

void Connection::send_line(const std::string& line) {
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t count =
        send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      if (!wait(socket_, POLLOUT)) {
        fail(name_ + " has not read the line that it was sent within " +
             elsie::base::seconds_text(timeout_s_) + " (its 'timeout')");
      }
    } else if (errno != EINTR) {
      while (receive()) {  // its last words
      }
      fail_by_end();
    }
  }
}

std::string Connection::receive_line() {
  std::size_t searched = 0;
  for (;;) {
    const std::size_t end = received_.find('\n', searched);
    if (end != std::string::npos) {
      if (end + 1 < received_.size()) {
        refuse(std::string_view(received_).substr(0, end),
               "it said " + in_short(std::string_view(received_).substr(end + 1)) +
                   " in another line; expected one line for each that it is sent");
      }
      std::string line = std::exchange(received_, {});
      line.pop_back();
      return line;
    }
    if (received_.size() > kLongest) {
      refuse(received_, "the line has no end within 1 MB; expected an object in one line");
    }
    searched = received_.size();
    if (!receive() && !wait(socket_, POLLIN)) {
      fail(name_ + " has not answered within " + elsie::base::seconds_text(timeout_s_) +
           " (its 'timeout')" +
           (received_.empty()
                ? ""
                : "; it said " + in_short(received_) + " without an end of the line"));
    }
  }
}

bool Connection::receive() {
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t count = recv(socket_, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count > 0) {
      received_.append(buffer.data(), static_cast<std::size_t>(count));
      return true;
    }
    if (count < 0 && errno == EAGAIN) return false;
    if (count == 0 || errno != EINTR) fail_by_end();
  }
}

bool Connection::wait(int descriptor, short events) const {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now());
    pollfd polled{descriptor, events, 0};
    const int ready = poll(&polled, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (ready > 0) return true;
    if (ready == 0 && Clock::now() >= deadline_) return false;
    if (ready < 0 && errno != EINTR) return false;
  }
}

bool Connection::wait_for_end() const {
  const int descriptor = static_cast<int>(syscall(SYS_pidfd_open, process_, 0));
  if (descriptor < 0) return false;
  const bool ended = wait(descriptor, POLLIN);
  close(descriptor);
  return ended;
}

std::string Connection::reap() {
  // The number of the group belongs to it until its leader has been waited for.
  kill(-process_, SIGKILL);
  int status = 0;
  pid_t found = 0;
  while ((found = waitpid(process_, &status, 0)) < 0 && errno == EINTR) {
  }
  process_ = 0;
  if (found < 0) return "has ended";
  if (WIFSIGNALED(status)) {
    return "was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  }
  const int code = WEXITSTATUS(status);
  return "ended with exit code " + std::to_string(code) +
         (code == 127   ? " (the shell finds no such command)"
          : code == 126 ? " (the shell may not run it)"
                        : "");
}

void Connection::set_deadline() {
  deadline_ =
      Clock::now() + std::chrono::ceil<Clock::duration>(std::chrono::duration<double>(timeout_s_));
}

void Connection::refuse(std::string_view answer, const std::string& problem) {
  fail(name_ + " answered " + in_quotes(answer, kShown) + ": " + problem);
}

void Connection::fail(const std::string& sentence) {
  failed_ = true;
  throw elsie::base::Error(sentence);
}

void Connection::fail_by_end() {
  const std::string how = process_ != 0 && wait_for_end() ? reap() : "has closed the connection";
  fail(name_ + " " + how + " instead of answering" +
       (received_.empty() ? "" : "; it said " + in_short(received_)));
}

}  // namespace remote
