#include "elsie/testing/actuator.h"

#include "made.h"

namespace elsie::testing {
namespace {

constexpr double kActuatorPeriod = 0.01;  // s

class Recorded final : public Effects {
 public:
  explicit Recorded(Done& done) : done_(done) {}
  void shine(const Colour& colour, double intensity) override {
    done_.shine = colour;
    done_.intensity = intensity;
  }
  void deposit(std::string_view field, double amount) override {
    done_.deposited[std::string(field)] += amount;
  }
  void draw_power(double units_per_s) override { done_.power += units_per_s; }
  void hold(double reach_m) override { done_.reach = reach_m; }
  void transmit(const std::shared_ptr<const AnyMessage>& message, const std::string& to,
                const Transmission& how) override {
    done_.sent.push_back({message, to, how});
  }

 private:
  Done& done_;
};

}  // namespace

Actuator::Actuator(const std::string& name, const Settings& settings, const Elements& elements)
    : Actuator(Plugins::found(), name, settings, elements) {}

Actuator::Actuator(const Plugins& plugins, const std::string& name, const Settings& settings,
                   const Elements& elements)
    : plugins_(plugins),
      declaration_(&plugins_.declaration(PluginKind::actuator, name)),
      random_(1),
      object_(make<elsie::Actuator>(plugins_, *declaration_, settings, elements,
                                    [](elsie::Actuator&) {})) {
  object_->equipped(mounting_);
  object_->fit_value();
}

const Done& Actuator::act_on(const void* command) {
  if (!reset_) reset();
  if (command) {
    object_->check_command(command);
    object_->take(command);
  }
  done_ = {};
  Recorded effects(done_);
  object_->carry_out({time_s_, kActuatorPeriod, command != nullptr,
                      Frame::turned(mounting_.position, 0.0, 0.0), &mounting_, robot_, &random_,
                      &effects});
  time_s_ += kActuatorPeriod;
  return done_;
}

void Actuator::reset(std::uint64_t seed) {
  seed_ = seed;
  random_ = Random(seed);
  time_s_ = 0.0;
  object_->forget();
  object_->reset(random_);
  reset_ = true;
}

bool Actuator::take_over(Actuator& before) {
  reset(before.seed_);
  random_ = before.random_;
  time_s_ = before.time_s_;
  return hand_over(*before.object_, *object_);
}

void Actuator::require(const ReadingKind& kind) const {
  require_kind(object_->kind(), kind, "actuator '" + declaration_->name + "' takes commands");
}

}  // namespace elsie::testing
