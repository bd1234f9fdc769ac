#include "elsie/api/disturbance.h"

#include <iterator>

#include "elsie/api/sensor.h"

namespace elsie {
namespace {

ElementItem<Noise> noise() {
  return element<Noise>(
      "noise", "noise on a number of its readings, or on each number of an array",
      parameter(
          "on", &Noise::on,
          {.meaning = "the name of the number, as the plugin's page lists it", .required = true}),
      parameter("scale", &Noise::scale, {.meaning = "first, a factor"}),
      parameter("bias", &Noise::bias, {.meaning = "then a constant, in the unit of the number"}),
      parameter("proportional", &Noise::proportional,
                {.min = 0,
                 .meaning = "then normal noise with this deviation, as a fraction of the value"}),
      parameter("gaussian", &Noise::gaussian,
                {.min = 0, .meaning = "then normal noise with this deviation"}),
      parameter("uniform", &Noise::uniform,
                {.min = 0, .meaning = "then uniform noise within this distance to either side"}),
      parameter("resolution", &Noise::resolution,
                {.min = 0, .meaning = "then rounded to a multiple of this; 0: not rounded"}),
      parameter("clamp", &Noise::clamp,
                {.meaning = "at last kept between these two numbers; empty: no limits"}));
}

ElementItem<Failure> failure() {
  return element<Failure>(
      "failure", "when it does not renew its reading",
      parameter("dropout", &Failure::dropout,
                {.min = 0,
                 .max = 1,
                 .meaning = "probability that an update is missed, so that the reading stays"}),
      parameter("latency", &Failure::latency,
                {.unit = "s", .min = 0, .meaning = "how much later a reading is seen"}),
      parameter("stuck_from", &Failure::stuck_from,
                {.unit = "s",
                 .min = -1,
                 .meaning = "the time from which on the reading stays; negative: never"}));
}

template <class Item>
ElementDeclaration declared(const ElementItem<Item>& item, std::size_t list,
                            std::vector<Disturbance>& (*list_of)(Component&)) {
  ElementDeclaration element;
  element.name = item.name;
  element.meaning = item.meaning;
  element.parameters = item.parameters;
  element.list = list;
  element.is_of_kind = true;
  element.clear = [list_of](Component& object) { list_of(object).clear(); };
  element.append = [list_of, make = item.make](Component& object, const ElementValue& value) {
    list_of(object).push_back(make(value));
  };
  return element;
}

}  // namespace

std::vector<ElementDeclaration> disturbance_elements(
    std::vector<Disturbance>& (*list_of)(Component&), std::size_t list) {
  return {declared(noise(), list, list_of), declared(failure(), list, list_of)};
}

void Sensor::declare_for_all(Declaration& declaration) {
  const std::size_t list = declaration.elements.empty() ? 0 : declaration.elements.back().list + 1;
  auto elements = disturbance_elements(
      [](Component& sensor) -> std::vector<Disturbance>& {
        return static_cast<Sensor&>(sensor).disturbances_;
      },
      list);
  std::move(elements.begin(), elements.end(), std::back_inserter(declaration.elements));
}

}  // namespace elsie
