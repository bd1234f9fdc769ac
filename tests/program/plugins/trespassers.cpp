// Plugins that change their process after half a second, as no plugin should, for the tests of the
// program: they end it, copy it, print, close its files, or change how it computes.
#include <cfenv>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <unistd.h>

#include <elsie/api/behavior.h>

namespace {

std::string wish() {
  const char* const text = std::getenv("TRESPASS_WHILE_LOADED");
  return text ? text : "";
}

/// A fault that a test selects happens while the library is loaded, whether a world uses it or not.
[[maybe_unused]] const bool loaded = [] {
  if (wish() == "leave") {
    _exit(0);
  }
  if (wish() == "round") {
    std::fesetround(FE_UPWARD);
  }
  if (wish() == "loop") {
    if (const char* const sign = std::getenv("TRESPASS_SIGN")) {
      std::ofstream{sign};  // for a test that waits until the loop is reached
    }
    for (volatile bool is_looping = true; is_looping;) {
    }
  }
  return true;
}();

/// The compiler cannot see into this function, so that the faults below stay.
template <class Value>
Value hidden(Value value) {
  asm volatile("" : "+r"(value));
  return value;
}

/// Drives on for half a second, executes `Deed` once, and drives on.
template <class Deed>
class Trespassing final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception& now) override {
    if (!done_ && now.time_s() >= 0.495) {
      done_ = true;
      Deed()();
    }
    return elsie::WheelPair().motion({10.0, 10.0 + 0.1 * now.time_s()});
  }

 private:
  bool done_ = false;
};

struct Leaves {
  void operator()() { _exit(0); }
};
struct LeavesInC {
  void operator()() { std::_Exit(0); }
};
struct LeavesQuickly {
  void operator()() { std::quick_exit(0); }
};
struct LeavesAtTheEnd {
  void operator()() {
    std::atexit([] { _exit(0); });
  }
};
struct KillsTheProgram {
  void operator()() { raise(SIGKILL); }
};
struct LeavesElsewhere {
  void operator()() {
    std::thread([] { _exit(0); }).join();
  }
};
/// The run continues, and reaches its goals, while the thread's crash is reported.
struct CrashesBeside {
  void operator()() {
    std::thread([] { *hidden<int*>(nullptr) = 1; }).detach();
  }
};
/// Leaves a thread behind, which runs after its code was unloaded.
struct LeavesAThread {
  void operator()() {
    std::thread([] {
      while (hidden(true)) {
      }
    }).detach();
  }
};
/// A copy that crashes does not concern the program.
struct ForksAndCrashesThere {
  void operator()() {
    if (fork() == 0) {
      *hidden<int*>(nullptr) = 1;
    }
  }
};
struct Forks {
  void operator()() { static_cast<void>(fork()); }
};
struct StartsAProgram {
  void operator()() { static_cast<void>(std::system("true")); }
};
struct WritesToABrokenPipe {
  void operator()() {
    int ends[2];
    if (pipe(ends) == 0) {
      close(ends[0]);
      static_cast<void>(write(ends[1], "x", 1));
    }
  }
};
struct Prints {
  void operator()() {
    std::printf("printed by printf\n");
    std::cout << "printed by cout\n";  // not flushed: the program does that
    static_cast<void>(write(STDOUT_FILENO, "written\n", 8));
  }
};
struct Rounds {
  void operator()() { std::fesetround(FE_UPWARD); }
};
struct CrashesInElsie {
  void operator()() {
    // The heap is damaged here, and the damage shows elsewhere: behind blocks of so many sizes lies
    // what is in use.
    void* blocks[16];
    std::size_t size = 0;
    for (void*& block : blocks) {
      block = std::malloc(size += 64);
    }
    for (void* const block : blocks) {
      for (int i = -16; i < 4096; ++i) {
        static_cast<volatile char*>(hidden(static_cast<char*>(block)))[i] = 0x41;
      }
    }
  }
};

/// The first object, made when the library is read, works.
int made = 0;
class LeavesWhenMade final : public elsie::Behavior {
 public:
  LeavesWhenMade() {
    if (made++ > 0) {
      _exit(0);
    }
  }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
int made_too = 0;
class RoundsWhenMade final : public elsie::Behavior {
 public:
  RoundsWhenMade() {
    if (made_too++ > 0) {
      std::fesetround(FE_UPWARD);
    }
  }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
class LeavesWhenDestroyed final : public elsie::Behavior {
 public:
  ~LeavesWhenDestroyed() override {
    if (asked_) {
      _exit(0);
    }
  }
  elsie::Response respond(const elsie::Perception&) override {
    asked_ = true;
    return {};
  }

 private:
  bool asked_ = false;
};

/// Loops from the first step on.
class LoopsAtOnce final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override {
    while (hidden(true)) {
    }
    return {};
  }
};
class LeavesAtOnce final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override { _exit(0); }
};
/// Allocates memory in every step and does not free it.
class Hoards final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override {
    kept_.push_back(hidden(new double[1000]));
    return elsie::WheelPair().motion({1, 1});
  }

 private:
  std::vector<double*> kept_;
};
/// Allocates a large block at once.
class Gulps final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override {
    delete[] hidden(new char[hidden(std::size_t{4'000'000'000})]);
    return elsie::WheelPair().motion({1, 1});
  }
};

using LeavesLate = Trespassing<Leaves>;
using LeavesInCLate = Trespassing<LeavesInC>;
using LeavesQuicklyLate = Trespassing<LeavesQuickly>;
using LeavesAtTheEndLate = Trespassing<LeavesAtTheEnd>;
using KillsTheProgramLate = Trespassing<KillsTheProgram>;
using LeavesElsewhereLate = Trespassing<LeavesElsewhere>;
using CrashesBesideLate = Trespassing<CrashesBeside>;
using LeavesAThreadLate = Trespassing<LeavesAThread>;
using ForksAndCrashesThereLate = Trespassing<ForksAndCrashesThere>;
using ForksLate = Trespassing<Forks>;
using StartsAProgramLate = Trespassing<StartsAProgram>;
using WritesToABrokenPipeLate = Trespassing<WritesToABrokenPipe>;
using PrintsLate = Trespassing<Prints>;
using RoundsLate = Trespassing<Rounds>;
using CrashesInElsieLate = Trespassing<CrashesInElsie>;

}  // namespace

ELSIE_BEHAVIOR(LeavesLate, "leaving", "Calls _exit(0) after half a second");
ELSIE_BEHAVIOR(LeavesInCLate, "leaving_in_c", "Calls _Exit(0) after half a second");
ELSIE_BEHAVIOR(LeavesQuicklyLate, "leaving_quickly", "Calls quick_exit(0) after half a second");
ELSIE_BEHAVIOR(LeavesAtTheEndLate, "leaving_at_the_end",
               "Has _exit(0) called when its library goes");
ELSIE_BEHAVIOR(KillsTheProgramLate, "killing", "Kills the process after half a second");
ELSIE_BEHAVIOR(LeavesElsewhereLate, "leaving_elsewhere",
               "Calls _exit(0) in a thread of its own after half a second");
ELSIE_BEHAVIOR(CrashesBesideLate, "crashing_beside",
               "Crashes in a thread of its own, which it does not wait for");
ELSIE_BEHAVIOR(LeavesAThreadLate, "leaving_a_thread", "Leaves a thread behind that does not end");
ELSIE_BEHAVIOR(ForksAndCrashesThereLate, "forking_and_crashing",
               "Copies the process after half a second, and the copy crashes");
ELSIE_BEHAVIOR(ForksLate, "forking", "Copies the process after half a second");
ELSIE_BEHAVIOR(StartsAProgramLate, "starting", "Starts a program after half a second");
ELSIE_BEHAVIOR(WritesToABrokenPipeLate, "writing_to_a_broken_pipe",
               "Writes to a pipe that nobody reads");
ELSIE_BEHAVIOR(PrintsLate, "printing", "Prints after half a second");
ELSIE_BEHAVIOR(RoundsLate, "rounding", "Has numbers rounded upward after half a second");
ELSIE_BEHAVIOR(CrashesInElsieLate, "smashing_heap", "Damages the heap after half a second");
ELSIE_BEHAVIOR(LeavesWhenMade, "leaving_when_made", "Calls _exit(0) when it is made");
ELSIE_BEHAVIOR(RoundsWhenMade, "rounding_when_made", "Has numbers rounded upward when it is made");
ELSIE_BEHAVIOR(LeavesWhenDestroyed, "leaving_when_destroyed", "Calls _exit(0) when it goes");
ELSIE_BEHAVIOR(LoopsAtOnce, "looping_at_once", "Never returns");
ELSIE_BEHAVIOR(LeavesAtOnce, "leaving_at_once", "Calls _exit(0) in its first step");
ELSIE_BEHAVIOR(Hoards, "hoarding", "Keeps 8000 bytes of every step");
ELSIE_BEHAVIOR(Gulps, "gulping", "Wants 4 GB in every step");
