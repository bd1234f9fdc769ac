// What the behaviour `remote` and the coordinator `arbiter_remote` have in common: the parameters
// that name a program, and what it is told and asked.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <elsie/api/declaration_items.h>

#include "answer.h"
#include "connection.h"

namespace remote {

/// A base of the plugin's class. The program is started when it is first asked, so that a world
/// that is only read, checked or edited starts none.
class Client {
 public:
  std::string command;
  elsie::FilePath file;
  std::string socket;
  double timeout = 5.0;

 protected:
  ~Client() = default;

  /// Throws std::invalid_argument unless the parameters name one program.
  void require_program() const;
  /// The robot may have changed, and the program is told what it has now.
  void tell_facts() { facts_are_told_ = false; }
  /// A new run, for which this is drawn from the object's own stream.
  void begin_run(elsie::Random& random);
  /// Sends what the robot perceives now, before that the facts and the beginning of a run, and
  /// reads the answer, all fields of which must be read. Throws base::Error.
  void ask(const std::function<Json()>& facts, const Json& now,
           const std::function<void(Answer&)>& read);

 private:
  void exchange(const std::string& line, const std::function<void(Answer&)>& read);

  std::optional<Connection> connection_;
  bool facts_are_told_ = false;
  std::string facts_;      // that the program was told
  std::int64_t seed_ = 0;  // of this run
  bool run_is_told_ = false;
};

// The items of the declaration.
#define REMOTE_PARAMETERS                                                                        \
  elsie::parameter(                                                                              \
      "command", &remote::Client::command,                                                       \
      {.meaning = "a command line for /bin/sh that starts the program; `file` is its last word", \
       .live = false}),                                                                          \
      elsie::parameter("file", &remote::Client::file,                                            \
                       {.meaning = "the program's file, which is started itself if there is no " \
                                   "`command`; the program runs in its folder",                  \
                        .live = false}),                                                         \
      elsie::parameter("socket", &remote::Client::socket,                                        \
                       {.meaning = "instead of both: the path of a Unix socket on which a "      \
                                   "program listens",                                            \
                        .live = false}),                                                         \
      elsie::parameter(                                                                          \
          "timeout", &remote::Client::timeout,                                                   \
          {.unit = "s",                                                                          \
           .min = 0.1,                                                                           \
           .max = 86400,                                                                         \
           .meaning = "how long an answer may take on the clock, the first one with the start",  \
           .live = false})

}  // namespace remote
