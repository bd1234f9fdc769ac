// elsie: the program that users start.
//
// Another process, lib/elsie/elsie-program, does the work, because plugins run in it: a plugin can
// end its process in ways that no code in it can prevent, and must not decide the exit code that a
// script or a CI server reads. This process returns the exit code that the program sends over a
// pipe before it ends; a program that ends without sending one has failed.
//
// The program also gets an environment in which floating-point functions give the same bits on all
// x86-64 processors: see arithmetic.h.
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "arithmetic.h"
#include "channel.h"
#include "child.h"

namespace {

constexpr int kPluginFailed = 3;
constexpr int kOtherFailure = 4;

/// Ends this process by the signal that ended the child.
[[noreturn]] void end_by(int signal) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);  // the child's is enough
  std::signal(signal, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  raise(signal);
  sigprocmask(SIG_UNBLOCK, &only, nullptr);
  _exit(128 + signal);
}

/// The exit code and message for a child that ended without announcing its exit code.
int failed(const elsie::supervisor::End& end, const std::string& program) {
  if (end.was_killed) {
    std::cerr << "elsie: the program did not end although it was asked twice, and was killed; a "
                 "plugin has blocked signals or does not return\n";
    return kOtherFailure;
  }
  if (WIFSIGNALED(end.status)) {
    const int signal = WTERMSIG(end.status);
    const char* const name = sigabbrev_np(signal);
    std::cerr << "elsie: the program was "
              << (signal == SIGKILL
                      ? "killed (SIGKILL): by somebody, by a plugin, or by the system because "
                        "memory ran out\n"
                      : std::string("ended by the signal SIG") + (name ? name : "?") +
                            ", which it could not report: a plugin may have replaced its handlers "
                            "of signals\n");
    end_by(signal);
  }
  constexpr int kNotStarted = 127;  // as in a shell; the system's loader reported the reason
  if (WEXITSTATUS(end.status) == kNotStarted) {
    std::cerr << "elsie: '" << program
              << "' could not be started, or a plugin has ended it with exit code 127; if nothing "
                 "was run, install Elsie again\n";
    return kOtherFailure;
  }
  std::cerr << "elsie: the program was ended before its work was done, with exit code "
            << WEXITSTATUS(end.status)
            << ": a plugin has ended it by a system call, or has closed the files that it "
               "needs; the results are incomplete\n";
  return kPluginFailed;
}

}  // namespace

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  namespace supervisor = elsie::supervisor;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path prefix = self.parent_path().parent_path();
  fs::path program = prefix / ELSIE_PROGRAM;
  if (!fs::exists(program, error)) {
    program = prefix / ELSIE_PROGRAM_IN_BUILD;
  }
  if (error || !fs::exists(program, error)) {
    std::cerr << "elsie: '" << program.string()
              << "' is missing, which belongs to this program; install it again\n";
    return kOtherFailure;
  }
  supervisor::fix_arithmetic();
  const bool one_process = argc > 1 && std::strcmp(argv[1], supervisor::kOneProcess) == 0;
  char** const arguments = one_process ? argv + 1 : argv;
  // The program learns its path by this name: batches on a cluster start it again.
  std::string name = self.string();
  arguments[0] = name.data();
  if (one_process) {
    supervisor::become(program, arguments);
    std::cerr << "elsie: '" << program.string() << "' cannot be started: " << std::strerror(errno)
              << '\n';
    return kOtherFailure;
  }
  try {
    const supervisor::End end = supervisor::run_child(program, arguments);
    if (!end.has_said_so) {
      return failed(end, program.string());
    }
    if (WIFSIGNALED(end.status)) {
      end_by(WTERMSIG(end.status));
    }
    return WEXITSTATUS(end.status);
  } catch (const std::exception& problem) {
    std::cerr << "elsie: " << problem.what() << '\n';
    return kOtherFailure;
  }
}
