// An actuator under test.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/actuator.h"
#include "elsie/testing/plugins.h"

namespace elsie::testing {

/// What an actuator did in one control period.
struct Done {
  std::optional<Colour> shine;  // none: it is dark
  double intensity = 0.0;
  double power = 0.0;           // units per second
  std::optional<double> reach;  // m, of a hand that is closed; none: it is open
  struct Sent {
    std::shared_ptr<const AnyMessage> message;
    std::string to;
    Transmission how;
  };
  std::vector<Sent> sent;
  std::map<std::string, double> deposited{};  // amounts, by fields
};

///   Actuator led("led", {{"intensity", 0.5}});
///   CHECK(led.act(LedCommand{{255, 0, 0}, 1.0}).shine == Colour{255, 0, 0});
///
/// Any actuator by its name, at the front edge and on top of a robot of the default size.
class Actuator {
 public:
  /// Throws plugin::PluginError with a sentence for an unknown plugin, wrong names or values of
  /// parameters, and what configured() refuses.
  explicit Actuator(const std::string& name, const Settings& settings = {},
                    const Elements& elements = {});
  Actuator(const Plugins& plugins, const std::string& name, const Settings& settings = {},
           const Elements& elements = {});

  /// Gives it a command, which it carries out for one control period. Throws std::invalid_argument
  /// for a command of another kind, base::Error for one that is not sound.
  template <class Command>
  const Done& act(const Command& command) {
    require(ReadingKind::of<Command>());
    return act_on(&command);
  }
  /// Lets it say a message.
  template <class Content>
  const Done& say(Content content, std::string to = "") {
    return act(SayCommand{std::make_shared<const AnyMessage>(AnyMessage(std::move(content))),
                          std::move(to)});
  }
  /// The same for the struct of a command of its kind; null: the present command holds.
  const Done& act_on(const void* command);
  /// Lets the present command hold for one more control period.
  const Done& hold() { return act_on(nullptr); }

  /// Returns to the start of a run, with the random stream of this seed.
  void reset(std::uint64_t seed = 1);
  /// See Sensor::take_over().
  bool take_over(Actuator& before);

  const Declaration& declaration() const { return *declaration_; }
  elsie::Actuator& operator*() { return *object_; }
  elsie::Actuator* operator->() { return object_.get(); }

 private:
  void require(const ReadingKind& kind) const;

  Plugins plugins_;
  const Declaration* declaration_;
  Mounting mounting_{{0.04, 0.0, 0.09}, 0.0, 0.0};
  OwnState robot_;
  std::uint64_t seed_ = 1;  // of the random stream
  Random random_;
  plugin::Object<elsie::Actuator> object_;
  Done done_;
  double time_s_ = 0.0;
  bool reset_ = false;
};

}  // namespace elsie::testing
