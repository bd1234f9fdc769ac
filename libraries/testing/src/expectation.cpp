#include "elsie/testing/expectation.h"

#include <algorithm>
#include <cmath>

#include "text.h"

namespace elsie::testing {
namespace {

bool near(double value, double expected, double within) {
  return std::abs(value - expected) <= within;  // false for NaN
}

bool goes_nowhere(const Response& r, double than) {
  return near(r.command.forward, 0.0, than) && near(r.command.lateral, 0.0, than);
}

}  // namespace

std::string text(const Motion& motion) {
  constexpr int kDigits = 6;
  return "command (forward " + number_text(motion.forward, kDigits) + " m/s, " +
         (motion.lateral != 0.0 ? "lateral " + number_text(motion.lateral, kDigits) + " m/s, "
                                : "") +
         "turn " + number_text(motion.turn, kDigits) + " rad/s)";
}

std::string text(const Response& response) {
  std::string text =
      testing::text(response.command) + ", activation " + number_text(response.activation);
  if (response.strength != 1.0) {
    text += ", strength " + number_text(response.strength);
  }
  if (response.charge) {
    text += ", asks to be charged";
  }
  for (const Event& event : response.events) {
    text += ", raises " + std::string(event.name);
  }
  return text;
}

Verdict Expectation::check(const Response& response) const {
  return match(response)
             ? Verdict()
             : Verdict::wrong("the answer should " + says_ + ", but is " + text(response));
}

Expectation operator&&(const Expectation& a, const Expectation& b) {
  return {a.says_ + " and " + b.says_,
          [a, b](const Response& r) { return a.match(r) && b.match(r); }};
}

Expectation operator||(const Expectation& a, const Expectation& b) {
  return {a.says_ + " or " + b.says_,
          [a, b](const Response& r) { return a.match(r) || b.match(r); }};
}

Expectation Expectation::operator!() const {
  return {"not " + says_, [wanted = *this](const Response& r) { return !wanted.match(r); }};
}

Expectation turns_left(double than) {
  return {"turn left", [=](const Response& r) { return r.command.turn > than; }};
}

Expectation turns_right(double than) {
  return {"turn right", [=](const Response& r) { return r.command.turn < -than; }};
}

Expectation drives_straight_on(double than) {
  return {"drive straight on", [=](const Response& r) {
            return near(r.command.turn, 0.0, than) && near(r.command.lateral, 0.0, than) &&
                   r.command.forward > than;
          }};
}

Expectation drives_forward(double than) {
  return {"drive forward", [=](const Response& r) { return r.command.forward > than; }};
}

Expectation backs_up(double than) {
  return {"back up", [=](const Response& r) { return r.command.forward < -than; }};
}

Expectation turns_on_the_spot(double than) {
  return {"turn on the spot", [=](const Response& r) {
            return goes_nowhere(r, than) && std::abs(r.command.turn) > than;
          }};
}

Expectation stands(double than) {
  return {"stand", [=](const Response& r) {
            return goes_nowhere(r, than) && near(r.command.turn, 0.0, than);
          }};
}

Expectation commands(const Motion& motion, double within) {
  return {text(motion) + " within " + number_text(within), [=](const Response& r) {
            return near(r.command.forward, motion.forward, within) &&
                   near(r.command.lateral, motion.lateral, within) &&
                   near(r.command.turn, motion.turn, within);
          }};
}

Expectation commands_wheels(double left, double right, double within, const WheelPair& wheels) {
  return {"command wheel rates of " + number_text(left) + " and " + number_text(right) +
              " rad/s within " + number_text(within),
          [=](const Response& r) {
            const WheelRates rates = wheels.wheel_rates(r.command);
            return near(rates.left, left, within) && near(rates.right, right, within) &&
                   r.command.lateral == 0.0;
          }};
}

Expectation is_active() {
  return {"be active", [](const Response& r) { return r.activation > 0.0; }};
}

Expectation is_not_active() {
  return {"not be active", [](const Response& r) { return r.activation == 0.0; }};
}

Expectation has_activation(double activation, double within) {
  return {"have activation " + number_text(activation) + " within " + number_text(within),
          [=](const Response& r) { return near(r.activation, activation, within); }};
}

Expectation has_strength(double strength, double within) {
  return {"have strength " + number_text(strength) + " within " + number_text(within),
          [=](const Response& r) { return near(r.strength, strength, within); }};
}

Expectation raises(std::string_view event) {
  return {"raise " + std::string(event), [name = std::string(event)](const Response& r) {
            return std::any_of(r.events.begin(), r.events.end(),
                               [&](const Event& e) { return e.name == name; });
          }};
}

Expectation raises_nothing() {
  return {"raise nothing", [](const Response& r) { return r.events.empty(); }};
}

Expectation asks_to_be_charged() {
  return {"ask to be charged", [](const Response& r) { return r.charge; }};
}

}  // namespace elsie::testing
