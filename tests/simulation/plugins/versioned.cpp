// A library of which the tests make others: they write another number and another mode over those
// below in a copy of the file. So a hundred versions need no compiler.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/actuator.h>
#include <elsie/api/behavior.h>
#include <elsie/api/coordinator.h>
#include <elsie/api/remember.h>
#include <elsie/api/sensor.h>

namespace {

// Volatile: to be read from the library, not known to the compiler.
__attribute__((used)) const volatile char kStamp[] = "elsie-stamp:0001:-";

double number() {
  double value = 0.0;
  for (int i = 12; i < 16; ++i) {
    value = 10.0 * value + (kStamp[i] - '0');
  }
  return value;
}

/// What is otherwise in this version; '-': nothing.
bool mode(char wanted) { return kStamp[17] == wanted; }

/// A name that is this one unless the mode is `changed`.
const char* named(const char* name, char changed, const char* other) {
  return mode(changed) ? other : name;
}

/// Its own text, in the library's memory. Distinct for each number.
const char* own_text(const char* text) {
  static std::string texts[2];
  texts[0] = std::string(text) + " " + std::to_string(static_cast<int>(number()));
  return texts[0].c_str();
}

/// Answers the number of its version and how often it was asked; or draws.
class Numbered final : public elsie::Behavior, public elsie::Remembers {
 public:
  double gain = 1.0;
  double stale = 7.0;
  bool draws = false;

  Numbered() {
    if (mode('t') && made++ > 0) {
      throw std::runtime_error("it cannot be made any more");
    }
  }

  void configured() override {
    if (mode('c') && gain > 1.0) {
      throw std::invalid_argument("it does not want any gain");
    }
  }
  void reset(elsie::Random& random) override {
    asked_ = 0;
    random.uniform();  // of no consequence
    if (mode('z')) {
      throw std::runtime_error("it cannot begin");
    }
  }
  void remember(elsie::Memory& memory) override {
    memory("asked", asked_);
    memory("last", last_);
    if (mode('m') && memory.recalls()) {
      throw std::invalid_argument("it makes nothing of that");
    }
  }

  elsie::Response respond(const elsie::Perception& now) override {
    ++asked_;
    last_ = draws ? now.random().uniform(-5.0, 5.0) : 0.01 * gain * number();
    elsie::Response response(
        elsie::WheelPair().motion({last_, draws ? last_ : 0.01 * static_cast<double>(asked_)}));
    if (asked_ % 2 == 1) {
      response.events.push_back({mode('e') ? "bong" : "beat"});
    }
    return response;
  }

  double version() const { return number(); }
  double asked() const { return static_cast<double>(asked_); }

 private:
  static inline int made = 0;
  std::int64_t asked_ = 0;
  double last_ = 0.0;
};

/// Counts, and hands over nothing.
class Forgetful final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override {
    ++asked_;
    return elsie::WheelPair().motion({0.01 * asked_, number()});
  }

 private:
  int asked_ = 0;
};

/// Answers what is inside answers.
class Holder final : public elsie::Behavior {
 public:
  elsie::Coordination* inside = nullptr;
  elsie::Response respond(const elsie::Perception& now) override { return inside->respond(now); }
};

class First final : public elsie::Coordinator {
 public:
  elsie::Motion coordinate(std::span<elsie::Member> members, const elsie::Perception&) override {
    members[0].respond();
    members[0].trace.share = members[0].trace.weight = 1.0;
    members[0].trace.reason = own_text("by number");
    return members[0].respond().command;
  }
};

struct NumberMessage {
  static constexpr const char* kind = "number";
  double number = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("number", number);
  }
};

/// Says its number, once.
class Talker final : public elsie::Behavior, public elsie::Remembers {
 public:
  void reset(elsie::Random&) override { has_spoken_ = false; }
  void remember(elsie::Memory& memory) override { memory("has_spoken", has_spoken_); }
  elsie::Response respond(const elsie::Perception&) override {
    elsie::Response response;
    if (!has_spoken_) response.say(NumberMessage{number()});
    has_spoken_ = true;
    return response;
  }

 private:
  bool has_spoken_ = false;
};

/// Says a number of its own in its first period, and what it is to say half a second later.
class Horn final : public elsie::ActuatorOf<elsie::SayCommand> {
 public:
  void act(const elsie::SayCommand& said, const elsie::ActuatorContext& now) override {
    const elsie::Transmission how{.range_m = 10.0, .delay_s = 0.05};
    if (now.time_s == 0.0) {
      const elsie::AnyMessage own(NumberMessage{-number()});
      now.robot->transmit(std::make_shared<const elsie::AnyMessage>(own), "", how);
    }
    if (now.is_new) now.robot->transmit(said.message, said.to, how);
  }
};

struct LevelReading {
  static constexpr const char* kind = "level";
  double level = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    if (mode('v')) {
      visitor("new_one", -1.0);
    }
    visitor("level", level);
  }
};

struct OtherReading {
  static constexpr const char* kind = "other";
};

class Level final : public elsie::SensorOf<LevelReading> {
 public:
  LevelReading sense(const elsie::SensorContext&) override { return {number()}; }
  std::optional<elsie::Camera> camera() const override {
    return mode('o') ? std::optional(elsie::Camera{}) : std::nullopt;
  }
};

/// A level sensor of another kind of reading.
class OtherLevel final : public elsie::SensorOf<OtherReading> {
 public:
  OtherReading sense(const elsie::SensorContext&) override { return {}; }
};

/// Answers what the level is.
class Leveller final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception& now) override {
    const auto levels = now.readings<LevelReading>();
    return elsie::WheelPair().motion({levels.empty() ? -1.0 : 0.01 * levels[0]->level, 0.0});
  }
};

elsie::ParameterItem<Numbered, double> gain() {
  return elsie::parameter(named("gain", 'r', "boost"), &Numbered::gain,
                          {.max = mode('n') ? 1.5 : 100.0, .meaning = "factor"});
}
elsie::ParameterItem<Numbered, double> stale() {
  return elsie::parameter("stale", &Numbered::stale,
                          {.meaning = "of no use", .required = mode('q')});
}

/// The first or the second number that it publishes, which change places in the mode 'p'.
auto published(bool is_first) {
  const bool is_version = is_first == mode('p');
  return elsie::publishes(is_version ? named("version", 'u', "number") : "asked",
                          is_version ? &Numbered::version : &Numbered::asked);
}

}  // namespace

ELSIE_BEHAVIOR(Numbered, named("numbered", 'g', "gone"), "Answers its number", gain(), stale(),
               elsie::parameter("draws", &Numbered::draws, {.meaning = "answers chance"}),
               published(true), published(false),
               elsie::raises(named("beat", 'e', "bong"), "every other time"));
ELSIE_BEHAVIOR(Forgetful, "forgetful", "Counts");
ELSIE_BEHAVIOR(Holder, "holder", "Holds", elsie::holds_behaviors(&Holder::inside));
ELSIE_COORDINATOR(First, "numbered_first", "The first decides");
ELSIE_BEHAVIOR(Talker, "talker", "Says its number", elsie::only_acts());
ELSIE_ACTUATOR(Horn, "horn", "Says what it is told", elsie::hears_messages());
ELSIE_SENSOR(Level, named("level", 'k', "old_level"), "Reads its number");
ELSIE_SENSOR(OtherLevel, named("other_level", 'k', "level"), "Reads nothing");
ELSIE_BEHAVIOR(Leveller, "leveller", "Answers the level", elsie::needs<LevelReading>());
