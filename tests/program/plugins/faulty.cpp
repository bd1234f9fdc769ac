// Plugins that fail after half a second, each in its own way, for the tests of the program.
#include <cerrno>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <dlfcn.h>
#include <err.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <unistd.h>

#include <elsie/api/behavior.h>
#include <elsie/api/coordinator.h>
#include <elsie/api/measure.h>
#include <elsie/api/sensor.h>

namespace {

/// A fault that a test selects happens while the library is loaded.
[[maybe_unused]] const bool loaded = [] {
  const char* const wish = std::getenv("FAULTY_WHILE_LOADED");
  if (wish && std::string_view(wish) == "late") {
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  }
  if (wish && std::string_view(wish) == "at once") {
    std::exit(0);
  }
  while (wish) {
    raise(SIGTERM);  // as if a user had sent it
    pause();
  }
  return true;
}();

void pause_here() { pause(); }

/// What a test selects is left behind when the library is loaded.
[[maybe_unused]] const bool left_behind = [] {
  const char* const wish = std::getenv("FAULTY_LEAVES_BEHIND");
  const std::string_view what = wish ? wish : "";
  if (what == "thread") {
    Dl_info own{};  // the thread needs the code of this library to the end of the process
    const bool stays = dladdr(reinterpret_cast<void*>(&pause_here), &own) != 0 &&
                       dlopen(own.dli_fname, RTLD_NOW | RTLD_NODELETE);
    std::thread(pause_here).detach();
    return stays;
  } else if (what == "process" && fork() == 0) {
    pause();
  } else if (what == "program") {  // until a file is gone
    return std::system("while [ -e \"$FAULTY_LEAVES_UNTIL\" ]; do sleep 0.1; done &") == 0;
  } else if (what == "file") {
    return dup(STDERR_FILENO) > 0;
  } else if (what == "memory") {
    return mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0) !=
           MAP_FAILED;
  } else if (what == "locale") {
    return std::setlocale(LC_ALL, "de_DE") != nullptr;  // where LOCPATH has it
  } else if (what == "text") {
    std::printf("loaded\n");
  }
  return true;
}();

/// The compiler cannot see into this function, so that the faults below stay.
template <class Value>
Value hidden(Value value) {
  asm volatile("" : "+r"(value));
  return value;
}

/// Drives on for half a second, then executes `Fault`.
template <class Fault>
class Failing final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception& now) override {
    return now.time_s() >= 0.495 ? fault_() : elsie::WheelPair().motion({10, 10});
  }

 private:
  Fault fault_;
};

struct Throws {
  elsie::Motion operator()() { throw std::runtime_error("it gave up"); }
};
struct NotANumber {
  elsie::Motion operator()() { return {std::numeric_limits<double>::quiet_NaN(), 0, 0}; }
};
struct Segfaults {
  elsie::Motion operator()() { return {*hidden<double*>(nullptr), 0, 0}; }
};
struct Divides {
  elsie::Motion operator()() {
    raise(SIGFPE);  // 1 / 0 raises it on some processors only
    return {};
  }
};
template <int kSignal>
struct Raises {
  elsie::Motion operator()() {
    raise(kSignal);
    return {};
  }
};
struct RaisesRealTime {
  elsie::Motion operator()() {
    raise(SIGRTMIN + 3);
    return {};
  }
};
struct SetsTimer {
  elsie::Motion operator()() {
    const itimerval soon{{0, 0}, {0, 1000}};
    setitimer(ITIMER_REAL, &soon, nullptr);
    for (;;) hidden(0);
  }
};
struct Aborts {
  elsie::Motion operator()() { std::abort(); }
};
struct ThrowsWhereNoneMay {
  elsie::Motion operator()() noexcept { return Throws()(); }
};
struct IllegalInstruction {
  elsie::Motion operator()() { __builtin_trap(); }
};
struct BusError {
  elsie::Motion operator()() {
    raise(SIGBUS);
    return {};
  }
};
/// The C library ends the process by its own exit().
struct Errs {
  elsie::Motion operator()() { errx(0, "it gave up"); }
};
struct Exits {
  elsie::Motion operator()() { std::exit(0); }
};
struct Overflows {
  elsie::Motion operator()() { return {deeper(1), 0, 0}; }
  static double deeper(int depth) {
    volatile double here[64] = {};
    here[0] = depth;
    return hidden(depth) > 0 ? deeper(depth + 1) + here[0] : 0.0;
  }
};
/// Prints a line for tests that wait, and makes a file that they ask for, then loops for ever.
void loop() {
  constexpr std::string_view kText = "for ever\n";
  [[maybe_unused]] const ssize_t count = write(STDERR_FILENO, kText.data(), kText.size());
  if (const char* const sign = std::getenv("FAULTY_LOOP_SIGN")) {
    close(creat(sign, 0600));
  }
  while (hidden(true)) {
  }
}
struct Loops {
  elsie::Motion operator()() {
    loop();
    return {};
  }
};
struct Sleeps {
  elsie::Motion operator()() {
    return elsie::WheelPair().motion(usleep(300'000) == 0 ? elsie::WheelRates{10, 10}
                                                          : elsie::WheelRates{});
  }
};
/// In all threads but the first.
template <class Fault>
struct Beside {
  elsie::Motion operator()() { return gettid() == getpid() ? elsie::Motion{} : Fault()(); }
};
/// Calls an address without code.
struct CallsNowhere {
  elsie::Motion operator()() {
    hidden(reinterpret_cast<void (*)()>(0x1234))();
    return {};
  }
};
/// Overwrites its own return address and those of its callers.
struct SmashesStack {
  elsie::Motion operator()() { return {smash(hidden(24)), 0, 0}; }
  __attribute__((noinline)) static double smash(int words) {
    volatile std::uintptr_t here[4] = {};
    volatile std::uintptr_t* const beyond = hidden(&here[0]);
    for (int i = 0; i < words; ++i) {
      beyond[i] = 0x4141414141414141;
    }
    return static_cast<double>(here[1]);
  }
};
/// A separate thread that crashes while the robot drives.
struct CrashesElsewhere {
  elsie::Motion operator()() {
    std::thread([] { *hidden<int*>(nullptr) = 1; }).join();
    return {};
  }
};
/// Takes a second; or, if a test names a file, the time until it is there. It is removed, so that
/// one step goes on; a folder stays, so that all do. Each task of a cluster has its own file.
struct Dawdles {
  elsie::Motion operator()() {
    using std::chrono::milliseconds;
    if (const char* const name = std::getenv("FAULTY_DAWDLES_UNTIL")) {
      const char* const task = std::getenv("SLURM_ARRAY_TASK_ID");
      const std::string file = std::string(name) + (task ? task : "");
      constexpr int kMost = 30'000;  // five minutes
      for (int i = 0; i < kMost && unlink(file.c_str()) != 0 && errno == ENOENT; ++i) {
        std::this_thread::sleep_for(milliseconds(10));
      }
    } else {
      std::this_thread::sleep_for(milliseconds(1000));
    }
    return elsie::WheelPair().motion({10, 10});
  }
};
struct Leaks {
  elsie::Motion operator()() {
    hidden(new char[1000]);
    return elsie::WheelPair().motion({10, 10});
  }
};
/// Allocates and frees in every call, with constant memory.
struct Thrifty {
  elsie::Motion operator()() {
    texts_.assign(20, std::string(100, 'x'));
    return elsie::WheelPair().motion({10, 10});
  }
  std::vector<std::string> texts_;
};

/// The first object, made when the library is read, works.
int made = 0;
class ThrowsWhenMade final : public elsie::Behavior {
 public:
  ThrowsWhenMade() {
    if (made++ > 0) {
      throw std::runtime_error("no more of these");
    }
  }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
int made_too = 0;
class CrashesWhenMade final : public elsie::Behavior {
 public:
  CrashesWhenMade() {
    if (made_too++ > 0) {
      *hidden<int*>(nullptr) = 1;
    }
  }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
int made_for_ever = 0;
class LoopsWhenMade final : public elsie::Behavior {
 public:
  LoopsWhenMade() {
    if (made_for_ever++ > 0) {
      loop();
    }
  }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
class LoopsWhenConfigured final : public elsie::Behavior {
 public:
  void configured() override { loop(); }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
class LoopsWhenEquipped final : public elsie::Behavior {
 public:
  void equipped(const elsie::Perception&) override { loop(); }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
class LoopsWhenReset final : public elsie::Behavior {
 public:
  void reset(elsie::Random&) override { loop(); }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
class CrashesWhenConfigured final : public elsie::Behavior {
 public:
  void configured() override { *hidden<int*>(nullptr) = 1; }
  elsie::Response respond(const elsie::Perception&) override { return {}; }
};
class CrashesWhenDestroyed final : public elsie::Behavior {
 public:
  ~CrashesWhenDestroyed() override {
    if (asked_) {
      *hidden<int*>(nullptr) = 1;
    }
  }
  elsie::Response respond(const elsie::Perception&) override {
    asked_ = true;
    return {};
  }

 private:
  bool asked_ = false;
};

class CrashingCoordinator final : public elsie::Coordinator {
 public:
  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    const elsie::Motion command = members[0].respond().command;
    return now.time_s() >= 0.495 ? elsie::WheelPair().motion({*hidden<double*>(nullptr), 0})
                                 : command;
  }
};

class CrashingSensor final : public elsie::SensorOf<elsie::RangeReading> {
 public:
  elsie::RangeReading sense(const elsie::SensorContext& now) override {
    return {now.time_s >= 0.495 ? *hidden<double*>(nullptr) : 1.0, 1.0, false};
  }
};

/// A reading that lists another number after a fifth of a second.
struct RenamedReading {
  static constexpr const char* kind = "renamed";
  bool is_late = false;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor(is_late ? "late" : "early", is_late);
  }
};

class RenamingSensor final : public elsie::SensorOf<RenamedReading> {
 public:
  RenamedReading sense(const elsie::SensorContext& now) override { return {now.time_s >= 0.195}; }
};

class UnableToReport final : public elsie::Measure {
 public:
  std::vector<elsie::Quantity> quantities() const override { return {{"", "m", "nothing"}}; }
  void observe(const elsie::Observation&) override {}
  void report(const elsie::RunEnd&, std::span<std::optional<double>>) const override {
    throw std::runtime_error("lost count");
  }
};

using ThrowsLate = Failing<Throws>;
using NotANumberLate = Failing<NotANumber>;
using SegfaultsLate = Failing<Segfaults>;
using DividesLate = Failing<Divides>;
using AbortsLate = Failing<Aborts>;
using TrapsLate = Failing<Raises<SIGTRAP>>;
using UserSignalLate = Failing<Raises<SIGUSR1>>;
using RealTimeLate = Failing<RaisesRealTime>;
using TimedLate = Failing<SetsTimer>;
using ThrowsWhereNoneMayLate = Failing<ThrowsWhereNoneMay>;
using IllegalInstructionLate = Failing<IllegalInstruction>;
using BusErrorLate = Failing<BusError>;
using ErrsLate = Failing<Errs>;
using ExitsLate = Failing<Exits>;
using OverflowsLate = Failing<Overflows>;
using SleepsLate = Failing<Sleeps>;
using LoopsLate = Failing<Loops>;
using LoopsBesideLate = Failing<Beside<Loops>>;
using SegfaultsBesideLate = Failing<Beside<Segfaults>>;
using AbortsBesideLate = Failing<Beside<Aborts>>;
using ExitsBesideLate = Failing<Beside<Exits>>;
using CallsNowhereLate = Failing<CallsNowhere>;
using SmashesStackLate = Failing<SmashesStack>;
using CrashesElsewhereLate = Failing<CrashesElsewhere>;
using DawdlesLate = Failing<Dawdles>;
using LeaksLate = Failing<Leaks>;
using ThriftyLate = Failing<Thrifty>;

}  // namespace

ELSIE_BEHAVIOR(ThrowsLate, "throwing", "Throws after half a second");
ELSIE_BEHAVIOR(NotANumberLate, "not_a_number", "Answers NaN after half a second");
ELSIE_BEHAVIOR(SegfaultsLate, "segfaulting", "Reads from nowhere after half a second");
ELSIE_BEHAVIOR(DividesLate, "dividing", "Divides by zero after half a second");
ELSIE_BEHAVIOR(AbortsLate, "aborting", "Calls abort() after half a second");
ELSIE_BEHAVIOR(TrapsLate, "trapping", "Raises SIGTRAP after half a second");
ELSIE_BEHAVIOR(UserSignalLate, "user_signal", "Raises SIGUSR1 after half a second");
ELSIE_BEHAVIOR(RealTimeLate, "real_time", "Raises a real-time signal after half a second");
ELSIE_BEHAVIOR(TimedLate, "timed", "Sets a timer after half a second");
ELSIE_BEHAVIOR(ThrowsWhereNoneMayLate, "throwing_through",
               "Throws through a noexcept after half a second");
ELSIE_BEHAVIOR(IllegalInstructionLate, "illegal",
               "Runs an illegal instruction after half a second");
ELSIE_BEHAVIOR(BusErrorLate, "bus_error", "Gets a bus error after half a second");
ELSIE_BEHAVIOR(ErrsLate, "erring", "Calls errx() after half a second");
ELSIE_BEHAVIOR(ExitsLate, "exiting", "Calls exit() after half a second");
ELSIE_BEHAVIOR(OverflowsLate, "overflowing", "Overflows its stack after half a second");
ELSIE_BEHAVIOR(SleepsLate, "sleeping",
               "Sleeps in each step after half a second, and stops once it is woken up");
ELSIE_BEHAVIOR(LoopsLate, "looping", "Does not return after half a second");
ELSIE_BEHAVIOR(LoopsBesideLate, "looping_beside",
               "Does not return after half a second, but in the program's first thread");
ELSIE_BEHAVIOR(SegfaultsBesideLate, "segfaulting_beside",
               "Reads from nowhere after half a second, but in the program's first thread");
ELSIE_BEHAVIOR(AbortsBesideLate, "aborting_beside",
               "Calls abort() after half a second, but in the program's first thread");
ELSIE_BEHAVIOR(ExitsBesideLate, "exiting_beside",
               "Calls exit() after half a second, but in the program's first thread");
ELSIE_BEHAVIOR(CallsNowhereLate, "calling_nowhere", "Calls a wild pointer after half a second");
ELSIE_BEHAVIOR(SmashesStackLate, "smashing_stack", "Writes over its stack after half a second");
ELSIE_BEHAVIOR(CrashesElsewhereLate, "crashing_elsewhere",
               "Crashes in a thread of its own after half a second");
ELSIE_BEHAVIOR(DawdlesLate, "dawdling", "Takes a second for each answer after half a second");
ELSIE_BEHAVIOR(LeaksLate, "leaking", "Leaks 1000 bytes a call after half a second");
ELSIE_BEHAVIOR(ThriftyLate, "thrifty", "Allocates and frees after half a second");
ELSIE_BEHAVIOR(ThrowsWhenMade, "throws_when_made", "Throws when it is made");
ELSIE_BEHAVIOR(LoopsWhenMade, "loops_when_made", "Does not return when it is made");
ELSIE_BEHAVIOR(LoopsWhenConfigured, "loops_when_configured",
               "Does not return when it gets its parameters");
ELSIE_BEHAVIOR(LoopsWhenEquipped, "loops_when_equipped",
               "Does not return when it hears what the robot has");
ELSIE_BEHAVIOR(LoopsWhenReset, "loops_when_reset", "Does not return when it is reset");
ELSIE_BEHAVIOR(CrashesWhenMade, "crashes_when_made", "Crashes when it is made");
ELSIE_BEHAVIOR(CrashesWhenConfigured, "crashes_when_configured",
               "Crashes when it gets its parameters");
ELSIE_BEHAVIOR(CrashesWhenDestroyed, "crashes_when_destroyed", "Crashes when it goes");
ELSIE_COORDINATOR(CrashingCoordinator, "crashing_coordinator",
                  "Reads from nowhere after half a second");
ELSIE_SENSOR(CrashingSensor, "crashing_sensor", "Reads from nowhere after half a second");
ELSIE_SENSOR(RenamingSensor, "renaming_sensor", "Lists another number after a fifth of a second");
ELSIE_MEASURE(UnableToReport, "unable_to_report", "Throws when it is asked what came of a run");
