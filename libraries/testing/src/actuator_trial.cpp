#include "elsie/plugin/parameters.h"
#include "elsie/testing/actuator.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

/// What it is made to say.
struct Word {
  static constexpr const char* kind = "word";
  double number = 0.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("number", number);
  }
};

/// Gives an actuator random commands, and lets each hold for a few control periods.
class ActuatorTrial final : public Trial {
 public:
  explicit ActuatorTrial(const TrialSetting& setting)
      : settings_(setting.plugins.completed(setting.declaration, setting.settings)),
        actuator_(setting.plugins, setting.declaration.name, setting.settings, setting.elements) {}

  Component& object() override { return *actuator_; }
  void reset(std::uint64_t seed) override {
    actuator_.reset(seed);
    actuator_->notes();
    actuator_->curves();
  }
  bool take_over(Trial& before) override {
    return actuator_.take_over(static_cast<ActuatorTrial&>(before).actuator_);
  }
  void configure_again() override {
    plugin::apply_parameters(actuator_.declaration(), *actuator_, settings_);
  }

  void step(std::size_t step, Answer& answer) override {
    const auto command = step % 4 == 0 ? random_command(step) : nullptr;
    const Done& done = actuator_.act_on(command.get());
    answer.clear();
    answer.add("whether it shines", done.shine ? 1.0 : 0.0);
    const Colour colour = done.shine.value_or(Colour{});
    answer.add("its red", colour.red);
    answer.add("its green", colour.green);
    answer.add("its blue", colour.blue);
    require_finite("its intensity", done.intensity);
    answer.add("its intensity", done.intensity);
    require_finite("its power", done.power);
    answer.add("its power", done.power);
    answer.add("whether it holds", done.reach ? 1.0 : 0.0);
    require_finite("its reach", done.reach.value_or(0.0));
    answer.add("its reach", done.reach.value_or(0.0));
    answer.add("the number of its messages", static_cast<double>(done.sent.size()));
    for (const Done::Sent& sent : done.sent) {
      tell(sent, answer);
    }
    for (const auto& [field, amount] : done.deposited) {
      require_finite("its deposit", amount);
      answer.add("its deposit", amount);
    }
    if (done.shine && !(done.intensity > 0.0)) {
      throw Wrong("it shines with the intensity " + number_text(done.intensity) +
                  "; expected a number above 0");
    }
    if (done.power < 0.0) {
      throw Wrong("it draws a power of " + number_text(done.power) + "; expected at least 0");
    }
  }

 private:
  static void tell(const Done::Sent& sent, Answer& answer) {
    if (!sent.message) throw Wrong("it sends a message that is null");
    require_finite("the range of its message", sent.how.range_m);
    require_finite("the delay of its message", sent.how.delay_s);
    require_degree("the loss of its message", sent.how.loss);
    answer.add("the range of its message", sent.how.range_m);
    answer.add("the delay of its message", sent.how.delay_s);
    answer.add("the loss of its message", sent.how.loss);
    sent.message->visit_fields([&](const ReadingField& field) {
      for (std::size_t i = 0; field.is_number() && i < field.count; ++i) {
        answer.add("a number of its message", field.number(i));
      }
    });
    answer.events.push_back("message of the kind '" + std::string(sent.message->kind().name) +
                            "' to '" + sent.to + "'");
  }

  /// A command whose fields have numbers of every sign and size.
  std::shared_ptr<void> random_command(std::size_t step) const {
    auto command = actuator_->new_value();
    Random random(step + 1);
    if (actuator_->kind() == ReadingKind::of<SayCommand>()) {
      *static_cast<SayCommand*>(command.get()) = random_words(random);
      return command;
    }
    actuator_->visit_fields(command.get(), [&](const ReadingField& field) {
      if (!field.is_number() || !field.is_stored) return;
      for (std::size_t i = 0; i < field.count; ++i) {
        const double scale = step % 3 == 0 ? 1.0 : step % 3 == 1 ? 300.0 : 1e9;
        field.set_number(i, scale * random.uniform(-0.3, 1.0));
      }
    });
    return command;
  }

  /// Mostly to all that hear it, now and then silence.
  static SayCommand random_words(Random& random) {
    if (random.chance(0.1)) return {};
    return {std::make_shared<const AnyMessage>(AnyMessage(Word{random.uniform(-1e3, 1e3)})),
            random.chance(0.3) ? kFirstMate : ""};
  }

  const Settings settings_;
  mutable Actuator actuator_;
};

}  // namespace

std::unique_ptr<Trial> make_actuator_trial(const TrialSetting& setting) {
  return std::make_unique<ActuatorTrial>(setting);
}

}  // namespace elsie::testing
