// Asks for the motion, and gives the commands, that somebody outside sets by live parameters: a
// program that steps the simulation, a person with the window, edits at given times.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/behavior.h>
#include <elsie/base/words.h>

namespace {

class Commanded final : public elsie::Behavior {
 public:
  double forward = 0.0, lateral = 0.0, turn = 0.0;
  double activation = 1.0;
  std::string commands;
  std::vector<double> values;

  void configured() override {
    if (commands != named_) name_numbers();
    if (!values.empty() && values.size() != places_.size()) {
      throw std::invalid_argument("`values` has " + elsie::base::counted(values.size(), "number") +
                                  ", but `commands` names " + std::to_string(places_.size()) +
                                  "; expected a value for each, or none at all");
    }
  }

  elsie::Response respond(const elsie::Perception&) override {
    elsie::Response response{{forward, lateral, turn}};
    response.activation = activation;
    for (std::size_t i = 0; i < values.size(); ++i) {
      numbers_[places_[i].actuator][places_[i].number].second = values[i];
    }
    for (std::size_t i = 0; !values.empty() && i < actuators_.size(); ++i) {
      response.acts.emplace_back(actuators_[i], "", numbers_[i]);
    }
    return response;
  }

 private:
  struct Place {
    std::size_t actuator, number;
  };

  /// Takes `commands` apart: "grip.closed lamp.red lamp.green" are a number of one actuator and two
  /// of another.
  void name_numbers() {
    std::vector<std::string> actuators;
    std::vector<elsie::NamedNumbers> numbers;
    std::vector<Place> places;
    std::istringstream words(commands);
    for (std::string word; words >> word;) {
      const std::size_t point = word.find('.');
      if (point == 0 || point == std::string::npos || point + 1 == word.size()) {
        throw std::invalid_argument(
            "`commands` has " + elsie::base::name_in_quotes(word) +
            "; expected the id of an actuator, a point, and a number of its command, such as "
            "'gripper.closed'");
      }
      const std::string actuator = word.substr(0, point), number = word.substr(point + 1);
      const auto known = std::find(actuators.begin(), actuators.end(), actuator);
      const auto at = static_cast<std::size_t>(known - actuators.begin());
      if (known == actuators.end()) {
        actuators.push_back(actuator);
        numbers.emplace_back();
      }
      if (std::any_of(numbers[at].begin(), numbers[at].end(),
                      [&](const auto& other) { return other.first == number; })) {
        throw std::invalid_argument("`commands` names " + elsie::base::name_in_quotes(word) +
                                    " twice; expected each number once");
      }
      places.push_back({at, numbers[at].size()});
      numbers[at].emplace_back(number, 0.0);
    }
    named_ = commands;
    actuators_ = std::move(actuators);
    numbers_ = std::move(numbers);
    places_ = std::move(places);
  }

  std::string named_;                         // the `commands` of what follows
  std::vector<std::string> actuators_;        // ids
  std::vector<elsie::NamedNumbers> numbers_;  // of the command of each actuator
  std::vector<Place> places_;                 // of each of `values`
};

}  // namespace

ELSIE_BEHAVIOR(
    Commanded, "commanded",
    "Asks for the motion, and gives the commands to actuators, that somebody outside sets",
    elsie::parameter("forward", &Commanded::forward,
                     {.unit = "m/s", .min = -100, .max = 100, .meaning = "speed ahead"}),
    elsie::parameter("lateral", &Commanded::lateral,
                     {.unit = "m/s",
                      .min = -100,
                      .max = 100,
                      .meaning = "speed to the left, for drives that can make it"}),
    elsie::parameter("turn", &Commanded::turn,
                     {.unit = "rad/s",
                      .min = -10000,
                      .max = 10000,
                      .meaning = "how fast it turns, counter-clockwise"}),
    elsie::parameter("activation", &Commanded::activation,
                     {.min = 0,
                      .max = 1,
                      .meaning = "how relevant that is now; 0: the other behaviours decide"}),
    elsie::parameter(
        "commands", &Commanded::commands,
        {.meaning = "the numbers of actuators' commands that `values` sets: words such "
                    "as `gripper.closed`, an actuator's id and what its command lists"}),
    elsie::parameter("values", &Commanded::values,
                     {.min = -1e12,
                      .max = 1e12,
                      .meaning = "their values, in this order; none: it gives no commands"}));
