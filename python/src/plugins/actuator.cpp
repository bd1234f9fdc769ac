// Actuators in Python.
#include "actuator.h"

#include <string>

#include <pybind11/stl.h>

#include "elsie/api/actuator.h"

#include "device.h"
#include "kinds.h"
#include "perception.h"

namespace elsie::python {
namespace {

/// `now` of an actuator.
struct ActuatorNow : Made {
  LentTo<const ActuatorContext> context = std::make_shared<Lent<const ActuatorContext>>();
  LentRandom random = std::make_shared<Lent<Random>>();

  const ActuatorContext* operator->() const { return &**context; }
};

class ScriptedActuator : public ScriptedDevice<Actuator> {
 public:
  explicit ScriptedActuator(const ScriptClassRef& of)
      : ScriptedDevice(of, StructLayout::of(of->declared["struct"])) {
    run({}, [&] {
      act_ = method("act");
      equipped_ = method("equipped");
      now_ = py::cast(made<ActuatorNow>());
      lends_ = now_.cast<ActuatorNow*>();
    });
  }
  ~ScriptedActuator() override { drop({&act_, &equipped_, &now_}); }

  void equipped(const Mounting& mounting) override { call_if_there(equipped_, mounting); }
  void check_command(const void* command) const override { check(command); }
  void take(const void* command) override { copy_value(command, in_work()); }
  void carry_out(const ActuatorContext& now) override {
    run(act_, [&] {
      const Lending context(*lends_->context, now);
      const Lending random(*lends_->random, *now.random);
      act_(layout().told(value()), now_);
    });
  }

 private:
  py::object act_, equipped_, now_;
  ActuatorNow* lends_ = nullptr;
};

}  // namespace

void bind_actuators(py::module_& module) {
  py::class_<ActuatorNow>(module, "ActuatorNow", "What an actuator can do, during act().")
      .def_property_readonly(
          "time", [](const ActuatorNow& now) { return now->time_s; }, "s")
      .def_property_readonly(
          "period", [](const ActuatorNow& now) { return now->period_s; }, "s")
      .def_property_readonly(
          "is_new", [](const ActuatorNow& now) { return now->is_new; },
          "Whether a behaviour gave the command in this period.")
      .def_property_readonly(
          "random", [](const ActuatorNow& now) { return now.random; }, "its own stream")
      .def_property_readonly(
          "mounting", [](const ActuatorNow& now) { return *now->mounting; },
          "where it is on its robot")
      .def_property_readonly(
          "place",
          [](const ActuatorNow& now) {
            const Vector3& at = now->frame.origin;
            return py::make_tuple(at.x, at.y, at.z);
          },
          "(x, y, z) of the actuator in the world")
      .def_property_readonly(
          "energy", [](const ActuatorNow& now) { return now->self.energy; },
          "in the battery, units")
      .def(
          "shine",
          [](const ActuatorNow& now, int red, int green, int blue, double intensity) {
            const auto part = [](int value) {
              if (value < 0 || value > 255)
                throw py::value_error("a colour has parts from 0 to 255");
              return static_cast<std::uint8_t>(value);
            };
            now->robot->shine({part(red), part(green), part(blue)}, intensity);
          },
          py::arg("red"), py::arg("green"), py::arg("blue"), py::arg("intensity") = 1.0,
          "Shines for this period.")
      .def(
          "transmit",
          [](const ActuatorNow& now, py::handle message, const py::dict& numbers,
             const std::string& to, double range_m, double delay_s, double loss, bool in_sight,
             bool tells_sender) {
            now->robot->transmit(made_message(message, numbers), to,
                                 {.range_m = range_m,
                                  .delay_s = delay_s,
                                  .loss = loss,
                                  .in_sight = in_sight,
                                  .tells_from = tells_sender});
          },
          py::arg("message"), py::arg("numbers"), py::arg("to") = "", py::arg("range_m") = 1.0,
          py::arg("delay_s") = 0.0, py::arg("loss") = 0.0, py::arg("in_sight") = false,
          py::arg("tells_sender") = true,
          "Sends a message to robots with such an actuator: transmit(OFFER, {\"x\": 1.0}).")
      .def(
          "hold", [](const ActuatorNow& now, double reach_m) { now->robot->hold(reach_m); },
          py::arg("reach_m"), "Holds the nearest box or resource for this period.")
      .def(
          "deposit",
          [](const ActuatorNow& now, const std::string& field, double amount) {
            now->robot->deposit(field, amount);
          },
          py::arg("field"), py::arg("amount"), "Adds to a field of the world.")
      .def(
          "draw_power",
          [](const ActuatorNow& now, double units_per_s) { now->robot->draw_power(units_per_s); },
          py::arg("units_per_s"), "Takes energy from the battery in this period.");
}

std::unique_ptr<Component> make_actuator(const ScriptClassRef& of) {
  return make_scripted<ScriptedActuator>(of);
}

}  // namespace elsie::python
