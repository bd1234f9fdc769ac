// Behaviours with one fault each, for the checker to find.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/remember.h"
#include "elsie/commands/led.h"

// Exists with the address sanitizer, which would report the intended leaks.
extern "C" __attribute__((weak)) void __lsan_ignore_object(const void* object);

using elsie::Motion;
using elsie::Perception;
using elsie::Response;

namespace {

/// A plugin without faults.
class Sound final : public elsie::Behavior, public elsie::Remembers {
 public:
  double speed = 5.0;
  double ratio = 0.5;

  void reset(elsie::Random&) override { steps_ = 0; }
  void remember(elsie::Memory& memory) override { memory("steps", steps_); }
  Response respond(const Perception& now) override {
    Response response(
        elsie::WheelPair().motion({speed + now.random().uniform(), ratio * ++steps_}));
    response.events.push_back({"stepped"});
    return response;
  }

 private:
  int steps_ = 0;
};
ELSIE_BEHAVIOR(Sound, "sound", "Is as it should be",
               elsie::parameter("speed", &Sound::speed, {.unit = "rad/s", .meaning = "a rate"}),
               elsie::parameter("ratio", &Sound::ratio, {.min = 0, .max = 1, .meaning = "a part"}),
               elsie::raises("stepped", "it was asked"));

class SharesStatic final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    static int calls = 0;
    return elsie::WheelPair().motion({static_cast<double>(++calls), 0.0});
  }
};
ELSIE_BEHAVIOR(SharesStatic, "shares_static", "Counts in a static");

/// Correct alone: each run starts again.
class SharesQuietly final : public elsie::Behavior {
 public:
  void reset(elsie::Random&) override { last = 0.0; }
  Response respond(const Perception& now) override {
    last = 0.5 * last + now.self().pose.x;
    return elsie::WheelPair().motion({last, last});
  }
  static inline double last = 0.0;
};
ELSIE_BEHAVIOR(SharesQuietly, "shares_quietly", "Smooths in a static, which reset() clears");

/// Correct in one thread: what is shared is used within one call only.
class Scratch : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    static std::atomic<double> scratch;
    const double own = now.self().pose.x;
    scratch = own;
    const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(20);
    while (scratch == own && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    return elsie::WheelPair().motion({scratch, scratch});
  }
};
ELSIE_BEHAVIOR(Scratch, "scratch", "Computes in a static");

class ScratchAlone final : public Scratch {};
ELSIE_BEHAVIOR(ScratchAlone, "scratch_alone", "Computes in a static, and says so",
               elsie::one_thread());

/// A hidden channel between objects: robots tell each other where they are.
class Board final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    static std::map<std::string, double> board;
    board[std::string(now.self().id)] = now.self().pose.x;
    double others = 0.0;
    for (const auto& [id, x] : board) {
      others += id == now.self().id ? 0.0 : x;
    }
    return elsie::WheelPair().motion({others, others});
  }
};
ELSIE_BEHAVIOR(Board, "board", "Leaves messages in a static");

/// The same between robots that see each other.
class Follower final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    static double goal = 0.0;
    if (now.self().is_leader) {
      goal = now.self().pose.x;
      return elsie::WheelPair().motion({1.0, 1.0});
    }
    return elsie::WheelPair().motion({goal, goal});
  }
};
ELSIE_BEHAVIOR(Follower, "follower", "The leader's place is in a static");

class TurnsByWay final : public elsie::Behavior {
 public:
  double turn_deg_m = 5.0;
  double turn_deg_per_m = 5.0;
  double offset_m = 1.0;
  Response respond(const Perception&) override { return elsie::WheelPair().motion({1.0, 1.0}); }
};
ELSIE_BEHAVIOR(TurnsByWay, "turns_by_way", "Has units of two parts",
               elsie::parameter("turn_deg_m", &TurnsByWay::turn_deg_m,
                                {.unit = "deg/m", .meaning = "an angle along the way"}),
               elsie::parameter("turn_deg_per_m", &TurnsByWay::turn_deg_per_m,
                                {.unit = "deg/m", .meaning = "the same"}),
               elsie::parameter("offset_m", &TurnsByWay::offset_m,
                                {.unit = "deg", .meaning = "of another unit than it says"}));

class Address final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    return elsie::WheelPair().motion(
        {static_cast<double>(reinterpret_cast<std::uintptr_t>(this) % 100003), 0.0});
  }
};
ELSIE_BEHAVIOR(Address, "address", "Goes by where it lies in memory");

class Clock final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return elsie::WheelPair().motion({std::chrono::duration<double>(now).count(), 0.0});
  }
};
ELSIE_BEHAVIOR(Clock, "clock", "Goes by the clock on the wall");

class OtherRandom final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    return elsie::WheelPair().motion({static_cast<double>(std::rand() % 10), 0.0});
  }
};
ELSIE_BEHAVIOR(OtherRandom, "other_random", "Draws from the C library");

class Forgetless final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    return elsie::WheelPair().motion({++count_, 0.0});
  }

 private:
  double count_ = 0.0;
};
ELSIE_BEHAVIOR(Forgetless, "forgetless", "Has no reset()");

class RarelyForgetless final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    has_been_there_ |= now.self().pose.x > 3.0;
    return elsie::WheelPair().motion({has_been_there_ ? 1.0 : 0.0, 0.0});
  }

 private:
  bool has_been_there_ = false;
};
ELSIE_BEHAVIOR(RarelyForgetless, "rarely_forgetless", "Has no reset(), which shows at few places");

class HalfForgets final : public elsie::Behavior, public elsie::Remembers {
 public:
  void reset(elsie::Random&) override { left_ = right_ = 0; }
  void remember(elsie::Memory& memory) override { memory("left", left_); }
  Response respond(const Perception&) override {
    ++left_;
    --right_;
    return elsie::Motion{static_cast<double>(left_), 0.0, static_cast<double>(right_)};
  }

 private:
  int left_ = 0, right_ = 0;
};
ELSIE_BEHAVIOR(HalfForgets, "half_forgets", "Hands over only half of what it has in mind");

class RefusesMemory final : public elsie::Behavior, public elsie::Remembers {
 public:
  void remember(elsie::Memory& memory) override {
    if (memory.recalls()) {
      throw std::invalid_argument("that is too long ago");
    }
  }
  Response respond(const Perception&) override { return elsie::WheelPair().motion({1.0, 1.0}); }
};
ELSIE_BEHAVIOR(RefusesMemory, "refuses_memory", "Does not take what it hands over");

class NotANumber final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    return elsie::WheelPair().motion({0.0, std::sqrt(now.self().pose.x)});
  }
};
ELSIE_BEHAVIOR(NotANumber, "not_a_number", "Takes the root of what may be negative");

class AtTheBound final : public elsie::Behavior {
 public:
  double distance = 1.0;
  Response respond(const Perception&) override {
    return elsie::WheelPair().motion({1.0 / distance, 0.0});
  }
};
ELSIE_BEHAVIOR(AtTheBound, "at_the_bound", "Divides by what its range lets be zero",
               elsie::parameter("distance", &AtTheBound::distance,
                                {.unit = "m", .min = 0, .max = 10, .meaning = "how far"}));

class Undeclared final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    Response response;
    response.events.push_back({"surprise"});
    return response;
  }
};
ELSIE_BEHAVIOR(Undeclared, "undeclared", "Raises what it does not declare");

class ActsUndeclared final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    Response response;
    response.act(elsie::LedCommand{{255, 0, 0}, 1.0});
    return response;
  }
};
ELSIE_BEHAVIOR(ActsUndeclared, "acts_undeclared", "Commands what it does not declare");

struct Tune {
  static constexpr const char* kind = "tune";
  double pitch = 1.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("pitch", pitch);
  }
};

/// Its answer is no number after it has heard a message.
class Enchanted final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    for (const auto& heard : now.heard<Tune>()) return Motion{std::sqrt(-1.0 - heard->pitch), 0, 0};
    return {};
  }
};
ELSIE_BEHAVIOR(Enchanted, "enchanted", "Loses its head over a tune", elsie::hears<Tune>());

class Eavesdrops final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    return Motion{now.heard<Tune>().empty() ? 0.1 : 0.2, 0.0, 0.0};
  }
};
ELSIE_BEHAVIOR(Eavesdrops, "eavesdrops", "Reads messages that it does not declare");

class Overactive final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override {
    Response response;
    response.activation = 1.5;
    return response;
  }
};
ELSIE_BEHAVIOR(Overactive, "overactive", "Is more active than can be");

class BadRating final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override { return {}; }
  void rate(const Perception&, const Response&, std::span<const Motion>,
            std::span<double> desirability) const override {
    desirability[0] = -0.1;
  }
};
ELSIE_BEHAVIOR(BadRating, "bad_rating", "Rates below zero");

class BadSets final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override { return {}; }
  elsie::CommandSets command_sets(const Perception&, const Response&) const override {
    return {{{{1.0, 0.0}, {0.0, 1.0}}}, {}};
  }
};
ELSIE_BEHAVIOR(BadSets, "bad_sets", "Hands over sets in no order");

class Throws final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    if (now.time_s() > 0.1) {
      throw std::runtime_error("out of ideas");
    }
    return {};
  }
};
ELSIE_BEHAVIOR(Throws, "throws", "Throws in the middle of a run");

class Grows final : public elsie::Behavior {
 public:
  void reset(elsie::Random&) override { all_.clear(); }
  Response respond(const Perception& now) override {
    all_.push_back(now.time_s());
    return {};
  }

 private:
  std::vector<double> all_;
};
ELSIE_BEHAVIOR(Grows, "grows", "Keeps all that it ever saw");

class Leaks final : public elsie::Behavior {
 public:
  void configured() override {
    memory_ = new std::array<double, 20>();  // never deleted
    if (__lsan_ignore_object) {
      __lsan_ignore_object(memory_);
    }
  }
  Response respond(const Perception&) override {
    return elsie::WheelPair().motion({(*memory_)[3], 0.0});
  }

 private:
  std::array<double, 20>* memory_ = nullptr;
};
ELSIE_BEHAVIOR(Leaks, "leaks", "Leaves memory behind");

class ConfiguredTwice final : public elsie::Behavior {
 public:
  double angle = 10.0;
  void configured() override { used_ += angle; }
  Response respond(const Perception&) override { return elsie::WheelPair().motion({used_, 0.0}); }

 private:
  double used_ = 0.0;
};
ELSIE_BEHAVIOR(ConfiguredTwice, "configured_twice", "Adds up in configured()",
               elsie::parameter("angle", &ConfiguredTwice::angle,
                                {.unit = "deg", .meaning = "an angle"}));

class UnsteadyDefault final : public elsie::Behavior {
 public:
  UnsteadyDefault() {
    static double made = 0.0;
    speed = ++made;
  }
  double speed = 0.0;
  Response respond(const Perception&) override { return {}; }
};
ELSIE_BEHAVIOR(UnsteadyDefault, "unsteady_default", "Has another default each time",
               elsie::parameter("speed", &UnsteadyDefault::speed,
                                {.unit = "rad/s", .meaning = "a rate"}));

class RefusesDefaults final : public elsie::Behavior {
 public:
  void configured() override { throw std::invalid_argument("never content"); }
  Response respond(const Perception&) override { return {}; }
};
ELSIE_BEHAVIOR(RefusesDefaults, "refuses_defaults", "Cannot be used as it is");

class RefusesRobots final : public elsie::Behavior {
 public:
  void equipped(const Perception&) override { throw std::invalid_argument("no robot will do"); }
  Response respond(const Perception&) override { return {}; }
};
ELSIE_BEHAVIOR(RefusesRobots, "refuses_robots", "Takes no robot at all");

struct RareReading {
  static constexpr const char* kind = "rare";
  double value = 0.0;
};
class Lonely final : public elsie::Behavior {
 public:
  Response respond(const Perception& now) override {
    return elsie::WheelPair().motion({now.readings<RareReading>()[0]->value, 0.0});
  }
};
ELSIE_BEHAVIOR(Lonely, "lonely", "Needs what no sensor makes", elsie::needs<RareReading>());

/// A declaration without meanings.
class Wordless final : public elsie::Behavior {
 public:
  double speed = 1.0;
  Response respond(const Perception&) override { return {}; }
};
ELSIE_BEHAVIOR(Wordless, "no_meaning", "Has a parameter that says nothing",
               elsie::parameter("speed", &Wordless::speed, {.unit = "rad/s"}));
class Unitless final : public elsie::Behavior {
 public:
  double speed = 1.0;
  Response respond(const Perception&) override { return {}; }
};
ELSIE_BEHAVIOR(Unitless, "no_unit", "Has a number of anything",
               elsie::parameter("speed", &Unitless::speed, {.meaning = "how fast"}));
class OtherUnit final : public elsie::Behavior {
 public:
  double turn_deg = 1.0;
  Response respond(const Perception&) override { return {}; }
};
ELSIE_BEHAVIOR(OtherUnit, "other_unit", "Has a name that says another unit",
               elsie::parameter("turn_deg", &OtherUnit::turn_deg,
                                {.unit = "rad", .meaning = "how far"}));
class WordlessEvent final : public elsie::Behavior {
 public:
  Response respond(const Perception&) override { return {}; }
};
ELSIE_BEHAVIOR(WordlessEvent, "wordless_event", "Raises something, whatever it is",
               elsie::raises("something", ""));

}  // namespace
