#include "supervised.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <locale>
#include <memory>
#include <string_view>
#include <vector>

#include <ext/stdio_filebuf.h>
#include <fcntl.h>
#include <unistd.h>

#include "elsie/process/process_end.h"

#include "../supervisor/channel.h"

namespace elsie::program {

namespace {

using elsie::supervisor::Message;

// A signal handler can only reach globals.
int channel = -1;
Message final_message;
int kept_output = STDOUT_FILENO;

/// The first number for descriptors that plugins should not find.
constexpr int kHigh = 200;

void announce(int exit_code) noexcept {
  final_message.process = getpid();  // different in a copy of the process
  final_message.exit_code = exit_code;
  while (write(channel, &final_message, sizeof(final_message)) < 0 && errno == EINTR) {
  }
}

/// "DESCRIPTOR:TOKEN".
bool read_variable(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) {
    return false;
  }
  const auto whole = [](std::string_view part, auto& number) {
    const auto read = std::from_chars(part.data(), part.data() + part.size(), number);
    return read.ec == std::errc() && read.ptr == part.data() + part.size();
  };
  return whole(text.substr(0, colon), channel) &&
         whole(text.substr(colon + 1), final_message.token) &&
         fcntl(channel, F_SETFD, FD_CLOEXEC) == 0;
}

std::string& path() {
  static std::string program;
  return program;
}

}  // namespace

void meet_supervisor() {
  char* const variable = std::getenv(elsie::supervisor::kVariable);
  if (variable && read_variable(variable)) {
    process::set_announcer(announce);
    std::fill_n(variable, std::strlen(variable), ' ');  // /proc/self/environ would show it for ever
  }
  unsetenv(elsie::supervisor::kVariable);
}

std::ostream& out() {
  // Never destroyed: it is used until the process ends, and flushed before.
  static auto* const buffer =
      new __gnu_cxx::stdio_filebuf<char>(kept_output, std::ios::out | std::ios::binary);
  static auto* const stream = [] {
    auto* const made = new std::ostream(buffer);
    made->imbue(std::locale::classic());  // whatever a plugin has set for new streams
    return made;
  }();
  return *stream;
}

int out_descriptor() { return kept_output; }

void keep_output(int count, char** arguments) {
  int kept = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, kHigh);
  if (kept < 0) {
    kept = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  }
  if (kept < 0) {
    return;  // closed: writing will fail and report it
  }
  kept_output = kept;
  dup2(STDERR_FILENO, STDOUT_FILENO);
  // Kept until the program ends, like arguments.
  static std::vector<std::string> changed;
  changed.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    for (const std::string_view name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
      const bool is_value = argument.size() > name.size() && argument.ends_with(name) &&
                            argument[argument.size() - name.size() - 1] == '=';
      if (argument == name || is_value) {
        changed.push_back(std::string(argument.substr(0, argument.size() - name.size())) +
                          "/dev/fd/" + std::to_string(kept));
        arguments[i] = changed.back().data();
        break;
      }
    }
  }
}

const std::string& program_path() { return path(); }

void set_program_path(const char* first_argument) {
  std::error_code error;
  // Without the supervisor, the path of the program itself.
  path() = std::string_view(first_argument).starts_with('/')
               ? first_argument
               : std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace elsie::program
