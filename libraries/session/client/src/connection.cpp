#include "elsie/client/connection.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/base/error.h"

namespace elsie::client {
namespace {

// The descriptors of the started program: elsie/server/server.h.
constexpr int kMessages = 150;
constexpr int kMemory = 151;
constexpr std::size_t kLongestReport = 65'536;
constexpr int kPatience_ms = 1000;  // for a process whose connection was closed here
constexpr int kReport_ms = 3000;    // for one that closed it: it writes a report

/// A descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) {
      close(number_);
    }
  }
  int get() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail(const std::string& program, int error) {
  throw base::Error("the program of sessions, '" + program +
                    "', cannot be started: " + std::strerror(error));
}

/// Reads all available text; false at the end.
bool read_into(std::string& text, int descriptor) {
  std::array<char, 65'536> some;
  while (true) {
    const ssize_t count = read(descriptor, some.data(), some.size());
    if (count > 0) {
      text.append(some.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
      return false;
    } else if (errno == EAGAIN) {
      return true;
    }
  }
}

}  // namespace

class Connection::Impl {
 public:
  Impl(const std::string& program, const std::vector<std::string>& arguments,
       std::size_t most_bytes)
      : memory_(snapshots::SharedMemory::create(most_bytes)), reader_(memory_) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      fail(program, errno);
    }
    messages_ = Descriptor(ends[0]);
    const Descriptor theirs(ends[1]);
    if (pipe2(ends, O_CLOEXEC) != 0) {
      fail(program, errno);
    }
    output_ = Descriptor(ends[0]);
    const Descriptor their_output(ends[1]);
    for (const int each : {messages_.get(), output_.get()}) {
      fcntl(each, F_SETFL, O_NONBLOCK);
    }
    start(program, arguments, theirs.get(), their_output.get());
  }

  ~Impl() {
    messages_ = Descriptor();  // closes the connection, which ends the process
    for (int waited_ms = 0; process_ > 0 && waited_ms < kPatience_ms; waited_ms += 10) {
      reap(WNOHANG);
      if (process_ > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    }
    end_by(SIGKILL);
    reap(0);
  }

  int descriptor() const { return messages_.get(); }

  void send(const Json& message) {
    unsent_ += message.dump(-1, ' ', false, Json::error_handler_t::replace);
    unsent_ += '\n';
    flush();
  }

  std::vector<Json> receive() {
    flush();
    // A process that a plugin left behind may hold the connection longer than the session lives.
    reap(WNOHANG);
    const bool is_gone = process_ <= 0;
    if (open_ && (!read_into(received_, messages_.get()) || is_gone)) {
      open_ = false;
      deadline_ = Clock::now() + std::chrono::milliseconds(kReport_ms);
    }
    read_output();
    std::vector<Json> messages;
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = received_.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      Json message =
          Json::parse(received_.begin() + static_cast<std::ptrdiff_t>(begin),
                      received_.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
      if (message.is_object()) {
        messages.push_back(std::move(message));
      }
    }
    received_.erase(0, begin);
    return messages;
  }

  std::optional<SessionEnd> ended() {
    if (open_) {
      return std::nullopt;
    }
    reap(WNOHANG);
    if (process_ > 0) {
      if (Clock::now() > deadline_) {
        end_by(SIGKILL);
      }
      return std::nullopt;
    }
    read_output();
    return SessionEnd{exit_code_, report_};
  }

  void close() {
    messages_ = Descriptor();
    open_ = false;
    deadline_ = Clock::now() + std::chrono::milliseconds(kPatience_ms);
  }

  void end_by(int signal) {
    if (process_ > 0) {
      ::kill(process_, signal);
    }
  }

  snapshots::Reader& reader() { return reader_; }

 private:
  using Clock = std::chrono::steady_clock;

  void start(const std::string& program, const std::vector<std::string>& arguments, int theirs,
             int their_output) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, their_output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, their_output, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, theirs, kMessages);
    posix_spawn_file_actions_adddup2(&actions, memory_.descriptor(), kMemory);
    // A program that was started in the background may ignore the signal of quit().
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGQUIT);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    std::vector<std::string> words{program, "session"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    const int error =
        posix_spawn(&process_, program.c_str(), &actions, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      process_ = -1;
      fail(program, error);
    }
  }

  void flush() {
    while (!unsent_.empty() && open_) {
      const ssize_t count =
          ::send(messages_.get(), unsent_.data(), unsent_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count < 0 && errno != EINTR) {
        return;  // receive() finds the end, if there is one
      }
      unsent_.erase(0, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
  }

  void read_output() {
    read_into(report_, output_.get());
    if (report_.size() > kLongestReport) {
      report_.erase(0, report_.size() - kLongestReport);
    }
  }

  void reap(int options) {
    int status = 0;
    if (process_ > 0 && waitpid(process_, &status, options) == process_) {
      process_ = -1;
      exit_code_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    }
  }

  snapshots::SharedMemory memory_;
  snapshots::Reader reader_;
  Descriptor messages_, output_;
  pid_t process_ = -1;
  int exit_code_ = 0;
  bool open_ = true;
  Clock::time_point deadline_;  // for ending, once the connection is closed
  std::string unsent_, received_, report_;
};

Connection::Connection(const std::string& program, const std::vector<std::string>& arguments,
                       std::size_t most_bytes)
    : impl_(std::make_unique<Impl>(program, arguments, most_bytes)) {}
Connection::~Connection() = default;

int Connection::descriptor() const { return impl_->descriptor(); }
void Connection::send(const Json& message) { impl_->send(message); }
std::vector<Json> Connection::receive() { return impl_->receive(); }
std::optional<SessionEnd> Connection::ended() { return impl_->ended(); }
void Connection::close() { impl_->close(); }
void Connection::quit() { impl_->end_by(SIGQUIT); }
void Connection::kill() { impl_->end_by(SIGKILL); }
snapshots::Reader& Connection::snapshots() { return impl_->reader(); }

}  // namespace elsie::client
