#include "elsie/api/disturbance.h"

#include "elsie/api/drive.h"
#include "elsie/api/sensor.h"

namespace elsie {
namespace {

ElementItem<Noise> noise() {
  return element<Noise>(
      "noise",
      "noise on a number of a sensor's readings, on each number of an array, or on a set point of "
      "a drive's joints",
      parameter("on", &Noise::on,
                {.meaning = "the name of the number: of a reading as the sensor's page lists it, "
                            "of a joint as in left_wheel.rate or front_wheel.angle",
                 .required = true}),
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

ElementItem<UpdateFailure> failure() {
  return element<UpdateFailure>(
      "failure", "when a sensor does not renew its reading, or a drive's joints their set points",
      parameter("dropout", &UpdateFailure::dropout,
                {.min = 0,
                 .max = 1,
                 .meaning = "probability that an update is missed, so that the last one holds"}),
      parameter("latency", &UpdateFailure::latency,
                {.unit = "s", .min = 0, .meaning = "how much later an update takes effect"}),
      parameter("stuck_from", &UpdateFailure::stuck_from,
                {.unit = "s",
                 .min = -1,
                 .meaning = "the time from which on nothing is renewed; negative: never"}));
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

void declare_disturbances(Declaration& declaration,
                          std::vector<Disturbance>& (*list_of)(Component&)) {
  const std::size_t list = declaration.elements.empty() ? 0 : declaration.elements.back().list + 1;
  declaration.elements.push_back(declared(noise(), list, list_of));
  declaration.elements.push_back(declared(failure(), list, list_of));
}

void Disturbable::declare_for_all(Declaration& declaration) {
  declare_disturbances(declaration, [](Component& object) -> std::vector<Disturbance>& {
    return static_cast<Disturbable&>(object).disturbances_;
  });
}

void Drive::declare_for_all(Declaration& declaration) {
  declare_disturbances(declaration, [](Component& drive) -> std::vector<Disturbance>& {
    return static_cast<Drive&>(drive).disturbances_;
  });
}

}  // namespace elsie
